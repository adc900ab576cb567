// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>

#include <sqlite3.h>

namespace burin::tst_window_killed {

namespace {

double unixTime() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// An X server of its own, and a program that mills in a window on it.
class Session {
public:
    ~Session() {
        for (QProcess* process : {&hand_, &display_})
            if (process->state() != QProcess::NotRunning) {
                process->kill();
                process->waitForFinished();
            }
        if (!folder_.isEmpty()) QDir(folder_).removeRecursively();
    }

    /// Waits until the program records. Returns false if it never does. @param arguments  see window_hand.cpp
    bool start(const QStringList& arguments = {}) {
        display_.start("Xvfb", {"-displayfd", "1", "-screen", "0", "1600x1000x24", "+extension", "GLX"});
        if (!display_.waitForStarted() || !lineOf(display_, [](const QByteArray&) { return true; })) return false;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("DISPLAY", ":" + QString::fromLatin1(line_));
        environment.insert("QT_QPA_PLATFORM", "xcb");
        hand_.setProcessEnvironment(environment);
        hand_.start(BURIN_BUILD_DIRECTORY "/test-programs/burin-window-hand", arguments);
        if (!lineOf(hand_, [](const QByteArray& line) { return line.startsWith("folder "); })) return false;
        folder_ = QString::fromUtf8(line_.mid(7));
        return lineOf(hand_, [](const QByteArray& line) { return line == "recording"; });
    }

    QProcess& hand() { return hand_; }
    QProcess& display() { return display_; }

    QString folder() const { return folder_; }
    /// All lines that the program has written.
    QList<QByteArray> told() { return said_ + hand_.readAllStandardOutput().split('\n'); }

    /// The output of `burin info` for the work that the program left behind.
    QJsonObject left() const {
        QDirIterator files(folder_, {"*.burin.working"}, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        if (!files.hasNext()) return {};
        const QFileInfo working(files.next());
        QString name = working.fileName().mid(1);
        name.chop(static_cast<int>(qstrlen(".working")));
        return runBurin({"info", working.dir().filePath(name), "--json"}).json();
    }

private:
    template <class Requested>
    bool lineOf(QProcess& process, Requested wanted) {
        QElapsedTimer patience;
        patience.start();
        while (patience.elapsed() < 120'000) {
            while (process.canReadLine()) {
                line_ = process.readLine().trimmed();
                if (&process == &hand_) said_ += line_;
                if (wanted(line_)) return true;
            }
            if (process.state() == QProcess::NotRunning) return false;
            process.waitForReadyRead(100);
        }
        return false;
    }

    QProcess display_, hand_;
    QByteArray line_;
    QList<QByteArray> said_;
    QString folder_;
};

/// The time of the last sample of the only recording, s since 1970; 0 if there is none.
double endOfRecording(const QJsonObject& info) {
    const QJsonArray takes = info["takes"].toArray();
    if (takes.size() != 1) return 0.0;
    const QJsonObject take = takes[0].toObject();
    return take["started_unix_s"].toDouble() + take["duration_s"].toDouble();
}

} // namespace

/// The number behind the last line that begins with a word; 0 if there is none.
qint64 lastNumber(const QList<QByteArray>& told, const QByteArray& word) {
    qint64 number = 0;
    for (const QByteArray& line : told)
        if (line.startsWith(word + ' ')) number = line.mid(word.size() + 1).toLongLong();
    return number;
}

/// A copy of a folder's files, hidden ones too.
bool copyFiles(const QString& from, const QString& to) {
    for (const QFileInfo& file : QDir(from).entryInfoList(QDir::Files | QDir::Hidden))
        if (!QFile::copy(file.filePath(), to + "/" + file.fileName())) return false;
    return true;
}

/// Removes the kept workpieces from all files of a folder that have some.
bool forgetKept(const QString& folder) {
    for (const char* name : {"kept.burin", ".kept.burin.working"}) {
        const QString file = folder + "/" + QLatin1String(name);
        if (!QFile::exists(file)) continue;
        sqlite3* database = nullptr;
        const bool good =
            sqlite3_open_v2(file.toUtf8().constData(), &database, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK &&
            sqlite3_exec(database, "DELETE FROM kept_workpiece", nullptr, nullptr, nullptr) == SQLITE_OK;
        sqlite3_close(database);
        if (!good) return false;
    }
    return true;
}

/// The hash of the workpiece that a project opens with; empty if it doesn't open.
QString hashOf(const QString& folder) {
    const ProgramRun run =
        runBurin({"volume", "export", folder + "/kept.burin", "-o", folder + "/stock.srle", "--json"});
    if (run.status != 0) qWarning("%s", run.messages.constData());
    return run.json()["hash"].toString();
}

/// The window is ended from outside in the middle of a recording.
class WindowKilledTest : public QObject {
    Q_OBJECT
private slots:
    void costsAtMost100Milliseconds_data();
    void costsAtMost100Milliseconds();
    void anyMomentOfTheTimelineIsSafe_data();
    void anyMomentOfTheTimelineIsSafe();
    void closingTheWindowKeepsWhatIsSaved();
    void closingTheWindowAsksAndKeepsNothingThatIsDiscarded();
};

enum class End { programKilled, programTerminated, displayKilled };

void WindowKilledTest::costsAtMost100Milliseconds_data() {
    QTest::addColumn<End>("end");
    QTest::addColumn<int>("milliseconds"); // of recording before it
    if (burin::testing::longRun()) QTest::newRow("kill -9, early") << End::programKilled << 900;
    QTest::newRow("kill -9 in a stroke") << End::programKilled << 2600;
    QTest::newRow("the X server dies") << End::displayKilled << 2300;
    QTest::newRow("kill") << End::programTerminated << 1700;
}

void WindowKilledTest::costsAtMost100Milliseconds() {
    QFETCH(End, end);
    QFETCH(int, milliseconds);
    Session session;
    QVERIFY(session.start());
    QTest::qWait(milliseconds);
    const pid_t victim =
        static_cast<pid_t>((end == End::displayKilled ? session.display() : session.hand()).processId());
    ::kill(victim, end == End::programTerminated ? SIGTERM : SIGKILL);
    const double ended = unixTime();
    QVERIFY(session.hand().waitForFinished(20'000)); // it does not hang without its display
    const QJsonObject info = session.left();
    const double missing = ended - endOfRecording(info);
    qInfo("%.0f ms are missing", 1000.0 * missing);
    QVERIFY2(missing <= 0.1, qPrintable(QString("%1 s are missing").arg(missing)));
    QVERIFY(info["samples"].toInteger() > milliseconds / 2);
}

void WindowKilledTest::anyMomentOfTheTimelineIsSafe_data() {
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("milliseconds"); // until the kill
    std::mt19937 random(50);
    const int kills = burin::testing::longRun() ? 50 : 1;
    for (int seed = 1; seed <= kills; ++seed)
        QTest::addRow("kill %d", seed) << seed << static_cast<int>(100 + random() % 6000);
}

/// Killed while it goes to a moment, continues there, takes back or saves: the file is complete with all that was saved
/// last, the work that is found holds every recording that had ended, the running one to 100 ms, and opens with the
/// workpiece that its recordings make.
void WindowKilledTest::anyMomentOfTheTimelineIsSafe() {
    QFETCH(int, seed);
    QFETCH(int, milliseconds);
    Session session;
    QVERIFY(session.start({QString::number(seed)}));
    QTest::qWait(milliseconds);
    ::kill(static_cast<pid_t>(session.hand().processId()), SIGKILL);
    const double ended = unixTime();
    QVERIFY(session.hand().waitForFinished(20'000));
    QList<QByteArray> told = session.told();
    while (!told.isEmpty() && told.last().isEmpty()) told.removeLast();
    QVERIFY(!told.isEmpty());
    QVERIFY(!told.contains("failed"));
    qInfo("killed after \"%s\", %lld actions", told.last().constData(), static_cast<long long>(told.size()));

    const QTemporaryDir saved, found, replayed;
    QVERIFY(QFile::copy(session.folder() + "/kept.burin", saved.filePath("kept.burin")));
    const ProgramRun file = runBurin({"info", saved.filePath("kept.burin"), "--json"});
    QVERIFY2(file.status == 0, file.messages.constData());
    QVERIFY(lastNumber(told, "saved") > 0);
    QVERIFY(file.json()["samples"].toInteger() >= lastNumber(told, "saved"));

    QVERIFY(copyFiles(session.folder(), found.path()) && copyFiles(session.folder(), replayed.path()));
    const ProgramRun work = runBurin({"info", found.filePath("kept.burin"), "--json"});
    QVERIFY2(work.status == 0, work.messages.constData());
    QVERIFY(work.json()["samples"].toInteger() >= std::max(lastNumber(told, "saved"), lastNumber(told, "recorded")));
    if (told.last() == "records") {
        double missing = ended;
        for (const QJsonValue& take : work.json()["takes"].toArray())
            missing = std::min(missing, ended - take["started_unix_s"].toDouble() - take["duration_s"].toDouble());
        QVERIFY2(missing <= 0.1, qPrintable(QString("%1 s are missing").arg(missing)));
    }

    const QString hash = hashOf(found.path());
    QVERIFY(!hash.isEmpty());
    QVERIFY(forgetKept(replayed.path()));
    QCOMPARE(hashOf(replayed.path()), hash);
}

void WindowKilledTest::closingTheWindowKeepsWhatIsSaved() {
    Session session;
    QVERIFY(session.start());
    QTest::qWait(1500);
    session.hand().write("save\n");
    const double ended = unixTime();
    QVERIFY(session.hand().waitForFinished(30'000));
    const ProgramRun run = runBurin({"info", session.folder() + "/kept.burin", "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    QVERIFY(!run.json()["recovered"].toBool());
    const double missing = ended - endOfRecording(run.json());
    QVERIFY2(missing <= 0.1, qPrintable(QString("%1 s are missing").arg(missing)));
}

void WindowKilledTest::closingTheWindowAsksAndKeepsNothingThatIsDiscarded() {
    Session session;
    QVERIFY(session.start());
    QTest::qWait(1500);
    session.hand().write("discard\n");
    QVERIFY(session.hand().waitForFinished(20'000));
    QCOMPARE(session.hand().exitStatus(), QProcess::NormalExit);
    QVERIFY(session.left().isEmpty()); // the user was asked and chose to discard it
}

BURIN_TEST(WindowKilledTest, QCoreApplication)

} // namespace burin::tst_window_killed

#include "tst_window_killed.moc"

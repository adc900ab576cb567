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
#include <QtTest>

#include <chrono>
#include <csignal>

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

    /// Waits until the program records. Returns false if it never does.
    bool start() {
        display_.start("Xvfb", {"-displayfd", "1", "-screen", "0", "1600x1000x24", "+extension", "GLX"});
        if (!display_.waitForStarted() || !lineOf(display_, [](const QByteArray&) { return true; })) return false;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("DISPLAY", ":" + QString::fromLatin1(line_));
        environment.insert("QT_QPA_PLATFORM", "xcb");
        hand_.setProcessEnvironment(environment);
        hand_.start(BURIN_BUILD_DIRECTORY "/test-programs/burin-window-hand", {});
        if (!lineOf(hand_, [](const QByteArray& line) { return line.startsWith("folder "); })) return false;
        folder_ = QString::fromUtf8(line_.mid(7));
        return lineOf(hand_, [](const QByteArray& line) { return line == "recording"; });
    }

    QProcess& hand() { return hand_; }
    QProcess& display() { return display_; }

    QString folder() const { return folder_; }

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
                if (wanted(line_)) return true;
            }
            if (process.state() == QProcess::NotRunning) return false;
            process.waitForReadyRead(100);
        }
        return false;
    }

    QProcess display_, hand_;
    QByteArray line_;
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

/// The window is ended from outside in the middle of a recording.
class WindowKilledTest : public QObject {
    Q_OBJECT
private slots:
    void costsAtMost100Milliseconds_data();
    void costsAtMost100Milliseconds();
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

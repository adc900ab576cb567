// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/stat.h>

namespace burin::tst_untrusted {

/// Untrusted files, arbitrary names, outputs to wrong locations, users of any language.
class UntrustedTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void projectsThatDoHarmAreRefusedOrHarmless_data();
    void projectsThatDoHarmAreRefusedOrHarmless();
    void programsWithEndlessWorkAreRefused_data();
    void programsWithEndlessWorkAreRefused();
    void namesNeverReachATerminalAsTheyAre_data();
    void namesNeverReachATerminalAsTheyAre();
    void outputsNeverReplaceInputs_data();
    void outputsNeverReplaceInputs();
    void devicesAreWrittenToAndNeverReplaced();
    void numbersAreReadTheSameInEveryLanguage_data();
    void numbersAreReadTheSameInEveryLanguage();
    void argumentsThatAreRejectedTakeOneSentence_data();
    void argumentsThatAreRejectedTakeOneSentence();
    void aPipeThatNobodyReadsIsGivenUpWhenAsked();

private:
    QString file(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
};

namespace {

QString fixture(const QString& name) {
    return QStringLiteral(BURIN_FIXTURES "/faults/") + name;
}

constexpr qint64 patience = 60'000; // ms

} // namespace

void UntrustedTest::initTestCase() {
    for (const QString& name : QDir(fixture("")).entryList(QDir::Files))
        QVERIFY(QFile::copy(fixture(name), folder_.filePath(name)));
    QVERIFY(QFile::copy(BURIN_FIXTURES "/models/pocket-test.stl", file("part.stl")));
    const QList<QStringList> steps{
        {"embed", file("part.stl"), "-o", file("p.burin"), "--voxel", "2", "--margin", "2", "--material",
         "tooling-board"},
        {"mill", file("p.burin"), "--step-over", "4", "--seconds", "2"},
        {"path", file("p.burin"), "new"},
        {"post", file("p.burin"), "-o", file("program.ngc"), "--override", "a test", "--tolerance", "1"},
        {"path", file("p.burin"), "trace", "1", "-o", file("hand.csv")}};
    for (const QStringList& step : steps) {
        const ProgramRun run = runBurin(step);
        QVERIFY2(run.status == 0, run.messages.constData());
    }
}

void UntrustedTest::projectsThatDoHarmAreRefusedOrHarmless_data() {
    QTest::addColumn<QString>("project");
    QTest::addColumn<int>("status");
    QTest::newRow("an allowance of 1e308") << "allow_1e308_segv.burin" << 0;
    QTest::newRow("an allowance of 1e6") << "allow_1e6.burin" << 0;
    QTest::newRow("a column that is worked out") << "gencol.burin" << 3;
    QTest::newRow("an index over an expression") << "index_expr.burin" << 3;
    QTest::newRow("a frame that claims 2 GB") << "mesh_bigframe.burin" << 3;
}

void UntrustedTest::projectsThatDoHarmAreRefusedOrHarmless() {
    QFETCH(QString, project);
    QFETCH(int, status);
    QElapsedTimer clock;
    clock.start();
    const ProgramRun looked = runBurin({"info", folder_.filePath(project)});
    QVERIFY2(looked.status == status, looked.messages.constData());
    if (status != 0) QCOMPARE(looked.messages.trimmed().count('\n'), 0);
    const ProgramRun drawn = runBurin({"picture", folder_.filePath(project), "-o", file("harm.png")});
    QVERIFY2(drawn.status == status, drawn.messages.constData());
    if (status == 0) {
        QCOMPARE(runBurin({"path", folder_.filePath(project), "new"}).status, 0);
        QVERIFY(runBurin({"path", folder_.filePath(project), "show", "1"}).status >= 0);
    }
    QVERIFY(clock.elapsed() < patience);
}

void UntrustedTest::programsWithEndlessWorkAreRefused_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("line");
    QTest::newRow("an arc") << "arcbig.ngc"
                            << "line 9";
    QTest::newRow("moves") << "longmove.ngc"
                           << "line 9";
    QTest::newRow("turns") << "turns.ngc"
                           << "line 9";
    QTest::newRow("pecks") << "pecks.ngc"
                           << "line 9";
}

void UntrustedTest::programsWithEndlessWorkAreRefused() {
    QFETCH(QString, program);
    QFETCH(QString, line);
    const ProgramRun run = runBurin({"verify", folder_.filePath(program), "--project", file("p.burin")});
    QCOMPARE(run.status, 3);
    QVERIFY2(run.messages.contains(line.toUtf8()), run.messages.constData());
}

void UntrustedTest::namesNeverReachATerminalAsTheyAre_data() {
    QTest::addColumn<QStringList>("command");
    QTest::newRow("escape sequences of a body") << QStringList{"import", "name_esc_x.step"};
    QTest::newRow("a body in Latin-1") << QStringList{"import", "t06b-name-latin1.stp"};
    QTest::newRow("a body in GBK") << QStringList{"import", "s16b-name-gbk.stl"};
    QTest::newRow("escape sequences of a take") << QStringList{"info", "takename_esc.burin"};
    QTest::newRow("a file that is not there") << QStringList{"info", "\x1b[31mred.burin"};
}

void UntrustedTest::namesNeverReachATerminalAsTheyAre() {
    QFETCH(QStringList, command);
    command[1] = folder_.filePath(command[1]);
    for (const bool json : {false, true}) {
        const ProgramRun run = runBurin(json ? command + QStringList{"--json"} : command);
        QVERIFY(run.status == 0 || run.status == 3);
        for (const QByteArray& text : {run.output, run.messages}) {
            QVERIFY2(QString::fromUtf8(text).toUtf8() == text, "not UTF-8");
            for (const char character : text) {
                const auto byte = static_cast<unsigned char>(character);
                QVERIFY(byte >= 0x20 || byte == '\n');
            }
        }
        if (json) QVERIFY(!run.json().isEmpty());
    }
}

void UntrustedTest::outputsNeverReplaceInputs_data() {
    QTest::addColumn<QStringList>("command"); // OUTPUT is replaced by each name of the project in turn
    QTest::newRow("path show") << QStringList{"path", "p.burin", "show", "1", "-o", "OUTPUT"};
    QTest::newRow("path show as CSV") << QStringList{"path", "p.burin", "show", "1", "--csv", "OUTPUT"};
    QTest::newRow("path take") << QStringList{"path", "p.burin", "take", "1", "-o", "OUTPUT"};
    QTest::newRow("path trace") << QStringList{"path", "p.burin", "trace", "1", "-o", "OUTPUT"};
    QTest::newRow("post") << QStringList{"post", "p.burin", "-o", "OUTPUT"};
    QTest::newRow("picture") << QStringList{"picture", "p.burin", "-o", "OUTPUT"};
    QTest::newRow("verify") << QStringList{"verify", "program.ngc", "--project", "p.burin", "--map", "OUTPUT"};
    QTest::newRow("verify faces") << QStringList{"verify",  "program.ngc",  "--project",
                                                 "p.burin", "--face-table", "OUTPUT"};
    QTest::newRow("mill") << QStringList{"mill", "p.burin", "--stylus", "trace:hand.csv", "--trace", "OUTPUT"};
}

void UntrustedTest::outputsNeverReplaceInputs() {
    QFETCH(QStringList, command);
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder_.path()));
    QFile::link("p.burin", "symbolic.burin");
    QVERIFY(QFile::exists("hard.burin") || ::link("p.burin", "hard.burin") == 0);
    QStringList outputs{"p.burin",          "./p.burin",     "symbolic.burin", "hard.burin",
                        ".p.burin.working", ".p.burin.lock", "p.burin-wal"};
    if (command.first() == "verify") outputs << "program.ngc";
    if (command.first() == "mill") outputs << "hand.csv";
    const auto contents = [] {
        QList<QByteArray> all;
        for (const char* name : {"p.burin", "program.ngc", "hand.csv"}) {
            QFile content(name);
            all << (content.open(QIODevice::ReadOnly) ? content.readAll() : QByteArray());
        }
        return all;
    };
    const QList<QByteArray> standing = contents();
    const QString given = command[command.indexOf("OUTPUT") - 1], option = given == "-o" ? "--output" : given;
    for (const QString& output : outputs) {
        QStringList arguments = command;
        arguments.replaceInStrings("OUTPUT", output);
        const ProgramRun run = runBurin(arguments);
        QVERIFY2(run.status == 2, qPrintable(output + ": " + run.messages));
        QCOMPARE(run.messages.trimmed().count('\n'), 0);
        QVERIFY2(run.messages.contains('"' + option.toUtf8() + '"'), run.messages.constData());
        QVERIFY(contents() == standing);
    }
    QVERIFY(QDir::setCurrent(before));
}

void UntrustedTest::devicesAreWrittenToAndNeverReplaced() {
    const ProgramRun full = runBurin({"path", file("p.burin"), "take", "1", "-o", "/dev/full"});
    QCOMPARE(full.status, 4);
    const ProgramRun out = runBurin({"path", file("p.burin"), "take", "1", "-o", "/dev/stdout"});
    QCOMPARE(out.status, 0);
    QVERIFY(out.output.startsWith("tick,"));
    QCOMPARE(runBurin({"path", file("p.burin"), "take", "1", "-o", "/dev/null"}).status, 0);
    for (const char* device : {"/dev/full", "/dev/null"}) {
        struct stat standing {};
        QVERIFY(::stat(device, &standing) == 0 && S_ISCHR(standing.st_mode));
    }
}

void UntrustedTest::numbersAreReadTheSameInEveryLanguage_data() {
    QTest::addColumn<QString>("locale");
    QTest::newRow("German") << "de_DE.UTF-8";
    QTest::newRow("Turkish") << "tr_TR.UTF-8";
}

void UntrustedTest::numbersAreReadTheSameInEveryLanguage() {
    QFETCH(QString, locale);
    QProcess probe;
    probe.start("locale", {"-a"});
    QVERIFY(probe.waitForFinished());
    const QString without = QString(locale).remove('-').toLower();
    if (!QString::fromUtf8(probe.readAll()).toLower().remove('-').contains(without)) QSKIP("no such locale here");
    const QString project = folder_.filePath(locale + ".burin");
    const QList<QStringList> steps{
        {"embed", file("part.stl"), "-o", project, "--voxel", "2.5", "--margin", "2.5", "--material", "tooling-board",
         "--keep-out", "0.5,0.5,-20,5.5,5.5,-10.5", "--clearance", "1.5"},
        {"mill", project, "--step-over", "4.5", "--seconds", "1.5", "--tool", "ball-6"},
        {"path", project, "new"},
        {"post", project, "-o", file("local.ngc"), "--override", "a test", "--tolerance", "0.75"},
        {"verify", file("local.ngc"), "--project", project, "--tolerance", "9.5", "--exact", "0"},
        {"picture", project, "-o", file("local.png"), "--section", "X=1.5", "--transparency", "12.5"}};
    for (const QStringList& step : steps) {
        const ProgramRun here = runBurin(step, locale);
        QVERIFY2(here.status == 0, here.messages.constData());
    }
    const QString program = contentOf(file("local.ngc"));
    QVERIFY(program.contains("G21") && !program.contains(QRegularExpression("[XYZ]-?\\d+,\\d")));
    QCOMPARE(runBurin({"info", project, "--json"}, locale).json()["setup"].toObject()["voxel_mm"].toDouble(), 2.5);
}

void UntrustedTest::argumentsThatAreRejectedTakeOneSentence_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("named");
    QTest::newRow("no number") << QStringList{"embed", "m.stl", "-o", "x.burin", "--voxel", "small"} << "small";
    QTest::newRow("out of range") << QStringList{"mill", "p.burin", "--rate", "3"} << "1000";
    QTest::newRow("not in a list") << QStringList{"mill", "p.burin", "--grip", "loose"} << "light";
    QTest::newRow("missing") << QStringList{"embed", "m.stl"} << "--output";
    QTest::newRow("too many") << QStringList{"info", "p.burin", "--colour"} << "--colour";
    QTest::newRow("together") << QStringList{"mill", "p.burin", "--fast", "--realtime"} << "--realtime";
    QTest::newRow("without its value") << QStringList{"post", "p.burin", "-o"} << "--output";
}

void UntrustedTest::argumentsThatAreRejectedTakeOneSentence() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, named);
    const ProgramRun run = runBurin(arguments);
    QCOMPARE(run.status, 2);
    QVERIFY2(run.messages.contains(named.toUtf8()), run.messages.constData());
    QCOMPARE(run.messages.trimmed().count('\n'), 0);
    QVERIFY(run.messages.trimmed().endsWith('.'));
}

void UntrustedTest::aPipeThatNobodyReadsIsGivenUpWhenAsked() {
    QVERIFY(::mkfifo(file("pipe").toLocal8Bit().constData(), 0600) == 0);
    QProcess process;
    process.start(burinProgram(), {"path", file("p.burin"), "take", "1", "-o", file("pipe")});
    QVERIFY(process.waitForStarted());
    QTest::qWait(1500); // by then it only waits for a reader
    QCOMPARE(process.state(), QProcess::Running);
    process.terminate();
    QVERIFY(process.waitForFinished(5000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 5);
}

BURIN_TEST(UntrustedTest, QCoreApplication)

} // namespace burin::tst_untrusted

#include "tst_untrusted.moc"

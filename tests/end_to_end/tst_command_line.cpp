// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <csignal>
#include <sys/resource.h>

namespace burin::tst_command_line {

namespace {

/// Exit status of Burin if no file can grow beyond 64 kB, which simulates a full disk; -1 after a crash.
int statusOnFullDisk(const QStringList& arguments) {
    QProcess process;
    process.setChildProcessModifier([] {
        const rlimit limit{65536, 65536};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN);
    });
    process.start(burinProgram(), arguments);
    const bool ended = process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit;
    return ended ? process.exitCode() : -1;
}

} // namespace

/// The result of a user's mistakes: one sentence, the right status, no loss.
class CommandLineTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void helpsWithEachCommand_data();
    void helpsWithEachCommand();
    void statusTellsWhatWentWrong_data();
    void statusTellsWhatWentWrong();
    void jsonStaysJsonWhenItFails();
    void aPictureIsCutOpen_data();
    void aPictureIsCutOpen();
    void aMachineIsCopiedChangedAndDeleted();
    void aProjectOutlivesItsMachine();
    void whatIsDoubtfulOfAPartIsRepeated();
    void anOperatorThatReachesNothingSaysSo();
    void fullDiskKeepsTheOldProject();
    void fullDiskLeavesNothingOfANewProject();
    void stopsWhenAsked();

private:
    QTemporaryDir folder_;
};

void CommandLineTest::initTestCase() {
    const auto write = [&](const char* name, const QByteArray& content) {
        QFile file(folder_.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    };
    write("empty.step", "");
    QFile whole(BURIN_FIXTURES "/models/tet.step");
    QVERIFY(whole.open(QIODevice::ReadOnly));
    const QByteArray step = whole.readAll();
    write("truncated.step", step.left(step.size() / 2));
    write("noise.stl", QByteArray("\x01\x02\x03 no model at all \xff\xfe"));
    write("text.burin", "not a project");
    write("wrong.ngc", "G21 G90\nG1 X10 F100\nBANANA\nM2\n");
    QVERIFY(qputenv("XDG_DATA_HOME", folder_.filePath("data").toUtf8()));
    QByteArray machine = runBurin({"machines", "show", "haas-mill"}).output;
    write("machine.json", machine.replace("\"rapid_feed_mm_per_min\": ", "\"rapid_feed_mm_per_min\": -"));
    write("trace.csv", "time_s,x_mm\n0,zero\n");
    QVERIFY(QFile::copy(BURIN_FIXTURES "/models/cube.brep", folder_.filePath("cube.brep")));
    QCOMPARE(
        runBurin({"embed", folder_.filePath("cube.brep"), "-o", folder_.filePath("cube.burin"), "--voxel", "1"}).status,
        0);
}

void CommandLineTest::helpsWithEachCommand_data() {
    QTest::addColumn<QString>("command");
    for (const char* command : {"import", "embed", "setup", "mill", "path", "post", "verify", "info", "calibrate",
                                "demo", "devices", "bench", "picture", "machines"})
        QTest::newRow(command) << QString(command);
}

void CommandLineTest::helpsWithEachCommand() {
    QFETCH(QString, command);
    const ProgramRun run = runBurin({command, "--help"});
    QCOMPARE(run.status, 0);
    QVERIFY(run.output.contains("--json"));
    QVERIFY(run.messages.isEmpty());
}

void CommandLineTest::statusTellsWhatWentWrong_data() {
    QTest::addColumn<QStringList>("arguments"); // @ is replaced by the test's folder
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("named"); // what the sentence mentions
    const auto row = [](const char* name, QStringList arguments, int status, const char* named) {
        QTest::newRow(name) << std::move(arguments) << status << QString(named);
    };
    row("no command and no display", {}, 2, "display");
    row("unknown command", {"engrave"}, 2, "engrave");
    row("unknown option", {"info", "@/cube.burin", "--colour"}, 2, "--colour");
    row("missing file", {"import", "@/nowhere.step"}, 3, "nowhere.step");
    row("empty file", {"import", "@/empty.step"}, 3, "empty.step");
    row("truncated file", {"import", "@/truncated.step"}, 3, "truncated.step");
    row("noise", {"import", "@/noise.stl"}, 3, "noise.stl");
    row("a folder", {"import", "@"}, 3, "");
    row("unknown material", {"embed", "@/cube.brep", "-o", "@/x.burin", "--material", "cheese"}, 2, "cheese");
    row("unknown body", {"embed", "@/cube.brep", "-o", "@/x.burin", "--body-material", "nose=machinable-wax"}, 2,
        "nose");
    row("voxel of no size", {"embed", "@/cube.brep", "-o", "@/x.burin", "--voxel", "0"}, 2, "");
    row("voxels without number", {"embed", "@/cube.brep", "-o", "@/x.burin", "--voxel", "0.00001"}, 2, "");
    row("name that no folder can hold",
        {"embed", "@/cube.brep", "-o", "@/" + QString(300, QLatin1Char('x')) + ".burin", "--voxel", "1"}, 4, "xxx");
    row("folder that is not there", {"embed", "@/cube.brep", "-o", "@/no/such/x.burin", "--voxel", "1"}, 4, "x.burin");
    row("not a project", {"info", "@/text.burin"}, 3, "text.burin");
    row("no project", {"mill", "@/none.burin"}, 3, "none.burin");
    row("unknown tool", {"mill", "@/cube.burin", "--tool", "spoon"}, 2, "spoon");
    row("unknown stylus", {"mill", "@/cube.burin", "--stylus", "pen"}, 2, "pen");
    row("unknown grip", {"mill", "@/cube.burin", "--grip", "iron"}, 2, "iron");
    row("unknown intent", {"mill", "@/cube.burin", "--intent", "harm"}, 2, "harm");
    row("device that is not there", {"mill", "@/cube.burin", "--stylus", "device:omega"}, 2, "omega");
    row("trace of the operator", {"mill", "@/cube.burin", "--trace", "@/x.csv"}, 2, "operator");
    row("trace of the operator names what was given", {"mill", "@/cube.burin", "--trace", "@/x.csv"}, 2, "x.csv");
    row("force of no trace", {"mill", "@/cube.burin", "--felt", "0.5"}, 2, "\"--felt\"");
    row("distance out of range", {"mill", "@/cube.burin", "--stock-distance", "20"}, 2, "--stock-distance");
    row("trace with an error", {"mill", "@/cube.burin", "--stylus", "trace:@/trace.csv"}, 3, "trace.csv");
    row("fixture that is not there", {"setup", "@/cube.burin", "--fixture", "@/vise.step"}, 3, "vise.step");
    row("fixture that is no model", {"setup", "@/cube.burin", "--fixture", "@/noise.stl"}, 3, "noise.stl");
    row("keep-out of no size", {"setup", "@/cube.burin", "--keep-out", "0,0,0,1,1,0"}, 2, "--keep-out");
    row("keep-out of five numbers", {"setup", "@/cube.burin", "--keep-out", "0,0,0,1,1"}, 2, "0,0,0,1,1");
    row("axis of no length", {"setup", "@/cube.burin", "--axis", "0,0,0"}, 2, "--axis");
    row("axis without a meaning", {"mill", "@/cube.burin", "--axis", "sideways"}, 2, "sideways");
    row("travel without a meaning", {"setup", "@/cube.burin", "--travel", "far"}, 2, "middle");
    row("obstacle that is not there", {"setup", "@/cube.burin", "--remove", "vise"}, 2, "vise");
    row("section of no axis", {"picture", "@/cube.burin", "-o", "@/x.png", "--section", "W=3"}, 2, "W=3");
    row("section without a number", {"picture", "@/cube.burin", "-o", "@/x.png", "--section", "X=half"}, 2, "X=half");
    row("section beside the stock", {"picture", "@/cube.burin", "-o", "@/x.png", "--section", "X=500"}, 2, "X=500");
    row("demo cut at no axis", {"demo", "--output", "@/out", "--section", "5"}, 2, "--section");
    row("picture of no path", {"picture", "@/cube.burin", "-o", "@/x.png", "--path", "9"}, 2, "path");
    row("machine that is not there", {"machines", "show", "dmu-50"}, 2, "dmu-50");
    row("copy over a shipped machine", {"machines", "copy", "haas-mill", "grbl-router", "--replace"}, 2, "grbl-router");
    row("shipped machine deleted", {"machines", "remove", "haas-mill"}, 2, "haas-mill");
    row("machine of nonsense", {"machines", "add", "@/machine.json"}, 3, "rapid_feed_mm_per_min");
    row("nothing recorded yet", {"post", "@/cube.burin", "-o", "@/x.ngc"}, 2, "burin mill");
    row("restart without a program", {"post", "@/cube.burin", "-o", "@/x.ngc", "--from", "5"}, 2, "burin post");
    row("restart at line 0", {"post", "@/cube.burin", "-o", "@/x.ngc", "--from", "0"}, 2, "--from");
    row("interrupted program without a line", {"post", "@/cube.burin", "-o", "@/x.ngc", "--program", "@/wrong.ngc"}, 2,
        "--from");
    row("restart of nonsense", {"post", "@/cube.burin", "-o", "@/x.ngc", "--from", "2", "--program", "@/wrong.ngc"}, 2,
        "burin mill");
    row("word that no control knows", {"verify", "@/wrong.ngc", "--project", "@/cube.burin", "--tool", "ball-6"}, 3,
        "wrong.ngc");
}

void CommandLineTest::statusTellsWhatWentWrong() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QString, named);
    for (QString& argument : arguments) argument.replace("@", folder_.path());
    const ProgramRun run = runBurin(arguments);
    QVERIFY2(run.status == status, (QByteArray::number(run.status) + ": " + run.messages).constData());
    QVERIFY2(run.messages.contains(named.toUtf8()), run.messages.constData());
    QVERIFY2(!QFile::exists(folder_.filePath("x.burin")) && !QFile::exists(folder_.filePath("x.ngc")),
             "a file was left");
    const QStringList hidden = QDir(folder_.path()).entryList({".*"}, QDir::Files | QDir::Hidden);
    QVERIFY2(hidden.isEmpty(), qPrintable(hidden.join(' ')));
}

void CommandLineTest::jsonStaysJsonWhenItFails() {
    const ProgramRun run = runBurin({"import", folder_.filePath("empty.step"), "--json"});
    QCOMPARE(run.status, 3);
    QVERIFY(run.json()["error"].toObject()["sentence"].toString().contains("empty.step"));
}

void CommandLineTest::aPictureIsCutOpen_data() {
    QTest::addColumn<QString>("axis");
    QTest::addColumn<QString>("view");
    for (const char* view : {"left", "right"}) QTest::newRow(view) << "X" << view;
    for (const char* view : {"front", "back"}) QTest::newRow(view) << "Y" << view;
    QTest::newRow("top") << "Z"
                         << "top";
}

/// The cube in the middle of its stock: viewed at right angles, the cut face shows both at their true size.
void CommandLineTest::aPictureIsCutOpen() {
    QFETCH(QString, axis);
    QFETCH(QString, view);
    const QJsonArray box =
        runBurin({"import", folder_.filePath("cube.brep"), "--json"}).json()["bounding_box_mm"].toArray();
    const int number = axis[0].toLatin1() - 'X';
    const double low = box[0].toArray()[number].toDouble(), high = box[1].toArray()[number].toDouble();
    const double edge = high - low, stock = edge + 2.0 * 5.0; // the default margin of embed
    const QString file = folder_.filePath("cube.png");
    const auto picture = [&](const QStringList& more) {
        const ProgramRun run =
            runBurin(QStringList{"picture", folder_.filePath("cube.burin"), "-o", file, "--view", view} + more);
        if (run.status != 0 || !run.messages.isEmpty()) qWarning("%s", run.messages.constData());
        return run.status == 0 && run.messages.isEmpty() ? QImage(file, "PNG") : QImage();
    };
    /// The numbers of columns in the middle row that show the part, and that show part or stock: neither background nor
    /// the outline of the plane.
    const auto widths = [](const QImage& image) {
        int part = 0, all = 0;
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, image.height() / 2);
            if (colour.blue() > colour.red() + 60) ++part;
            if (colour.lightness() >= 75 && colour.red() < colour.green() + 15) ++all;
        }
        return std::pair(part, all);
    };
    const QImage closed = picture({});
    QVERIFY(!closed.isNull());
    QCOMPARE(widths(closed).first, 0);
    const QImage open = picture({"--section", axis + "=" + QString::number(0.5 * (low + high))});
    QVERIFY(!open.isNull());
    const auto [part, all] = widths(open);
    QVERIFY2(std::abs(part - all * edge / stock) < 0.01 * all,
             qPrintable(QString("%1 of %2, %3 / %4").arg(part).arg(all).arg(edge).arg(stock)));
}

/// A machine is exported to a file, changed by hand and imported again.
void CommandLineTest::aMachineIsCopiedChangedAndDeleted() {
    QCOMPARE(runBurin({"machines", "copy", "haas-mill", "vf-2", "--name", "VF-2 in the shop"}).status, 0);
    QVERIFY(QFile::exists(folder_.filePath("data/burin/machines/vf-2.json")));
    QByteArray text = runBurin({"machines", "show", "vf-2"}).output;
    QVERIFY(text.contains("\"maximum_spindle_speed_rpm\": 8100"));
    QFile file(folder_.filePath("changed.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text.replace("8100", "7500"));
    file.close();
    QCOMPARE(runBurin({"machines", "add", file.fileName()}).status, 2); // the ID exists already
    QCOMPARE(runBurin({"machines", "add", file.fileName(), "--replace"}).status, 0);
    const QJsonObject shown = runBurin({"machines", "show", "vf-2", "--json"}).json();
    QCOMPARE(shown["maximum_spindle_speed_rpm"].toDouble(), 7500.0);
    bool own = false, typical = false;
    for (const QJsonValue& one : runBurin({"machines", "list", "--json"}).json()["machines"].toArray()) {
        if (one["id"] == "vf-2") own = !one["typical"].toBool() && one["name"] == "VF-2 in the shop";
        if (one["id"] == "haas-mill") typical = one["typical"].toBool();
    }
    QVERIFY(own && typical);
    QCOMPARE(runBurin({"machines", "remove", "vf-2"}).status, 0);
    QVERIFY(!runBurin({"machines", "list"}).output.contains("vf-2"));
}

/// The machine was deleted, or the project comes from another computer: one sentence names the replacement, and work
/// goes on.
void CommandLineTest::aProjectOutlivesItsMachine() {
    const QString project = folder_.filePath("moved.burin");
    QVERIFY(QFile::copy(folder_.filePath("cube.burin"), project));
    QCOMPARE(runBurin({"machines", "copy", "haas-mill", "gone"}).status, 0);
    QCOMPARE(runBurin({"setup", project, "--machine", "gone"}).status, 0);
    QCOMPARE(runBurin({"machines", "remove", "gone"}).status, 0);
    const ProgramRun run = runBurin({"mill", project, "--seconds", "0.2"});
    QVERIFY2(run.status == 0, run.messages.constData());
    QVERIFY2(run.messages.contains("\"gone\"") && run.messages.contains("\"linuxcnc-mill\""), run.messages.constData());
}

/// The import doubted the unit of the part, and embedding found that nothing of it is protected.
void CommandLineTest::whatIsDoubtfulOfAPartIsRepeated() {
    const QString project = folder_.filePath("speck.burin"), program = folder_.filePath("air.ngc");
    QFile file(program);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("G21 G90 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 X0 Y0\nG0 Z20\nM2\n");
    file.close();
    const auto doubts = [](const ProgramRun& run, const char* key) {
        const QJsonArray texts = run.json()[QLatin1String(key)].toArray();
        return texts.size() == 2 && texts[0].toString().contains("unit") && texts[1].toString().contains("protected");
    };
    const QString part = BURIN_FIXTURES "/models/of-others/s14b-20-micrometre.stl";
    // A part without any protection is refused unless this is overridden.
    const QStringList embed{"embed", part, "-o", project, "--voxel", "0.5", "--json"};
    const ProgramRun refused = runBurin(embed);
    QCOMPARE(refused.status, 1);
    QVERIFY(doubts(refused, "warnings") && refused.messages.contains("--override") && !QFile::exists(project));
    const ProgramRun made = runBurin(embed + QStringList{"--override"});
    QCOMPARE(made.status, 0);
    QVERIFY(doubts(made, "warnings"));
    const QStringList mill{"mill", project, "--seconds", "0.2", "--json"};
    QCOMPARE(runBurin(mill).status, 1);
    QVERIFY(doubts(runBurin(mill), "part_warnings"));
    const ProgramRun milled = runBurin(mill + QStringList{"--override"});
    QCOMPARE(milled.status, 0);
    QVERIFY(doubts(milled, "part_warnings"));
    const ProgramRun verified = runBurin({"verify", program, "--project", project, "--tool", "ball-6", "--json"});
    QCOMPARE(verified.status, 1);
    QVERIFY(doubts(verified, "part_warnings"));
    QCOMPARE(verified.json()["findings"].toArray()[0].toObject()["kind"].toString(), "part_not_protected");
    QVERIFY(runBurin({"verify", program, "--project", project, "--tool", "ball-6"}).output.contains("\nwarning: "));
}

/// The stock consists of the part alone.
void CommandLineTest::anOperatorThatReachesNothingSaysSo() {
    const QString project = folder_.filePath("whole.burin");
    QCOMPARE(runBurin({"embed", folder_.filePath("cube.brep"), "-o", project, "--voxel", "1", "--margin", "0"}).status,
             0);
    const ProgramRun idle = runBurin({"mill", project});
    QCOMPARE(idle.status, 1);
    QVERIFY2(idle.messages.contains("can't reach anything"), idle.messages.constData());
    QCOMPARE(runBurin({"mill", project, "--override"}).status, 0);
}

void CommandLineTest::fullDiskKeepsTheOldProject() {
    const QString project = folder_.filePath("cube.burin");
    const ProgramRun before = runBurin({"info", project, "--json"});
    QCOMPARE(statusOnFullDisk({"mill", project, "--tool", "ball-6"}), 4);
    const ProgramRun after = runBurin({"info", project, "--json"});
    QCOMPARE(after.status, 0);
    QCOMPARE(after.json()["model"], before.json()["model"]);
}

void CommandLineTest::fullDiskLeavesNothingOfANewProject() {
    const QTemporaryDir folder;
    const QString project = folder.filePath("new.burin");
    QCOMPARE(statusOnFullDisk({"embed", folder_.filePath("cube.brep"), "-o", project, "--voxel", "1"}), 4);
    const QStringList left = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
    QVERIFY2(left.isEmpty(), qPrintable(left.join(' ')));
}

void CommandLineTest::stopsWhenAsked() {
    const QString project = folder_.filePath("stop.burin");
    QCOMPARE(runBurin({"embed", folder_.filePath("cube.brep"), "-o", project, "--voxel", "1"}).status, 0);
    QProcess process;
    process.start(burinProgram(), {"mill", project, "--realtime", "--tool", "ball-6", "--json"});
    QVERIFY(process.waitForStarted());
    QTest::qWait(4000);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 5);
    const ProgramRun info = runBurin({"info", project, "--json"});
    QCOMPARE(info.status, 0);
    QCOMPARE(info.json()["recovered"].toBool(), false);
}

BURIN_TEST(CommandLineTest, QCoreApplication)

} // namespace burin::tst_command_line

#include "tst_command_line.moc"

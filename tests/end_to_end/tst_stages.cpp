// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "program_run.h"

#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_stages {

/// The job stage by stage, one command each, on a block with pockets (100 × 100 × 18 mm).
class StagesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void imports();
    void embeds();
    void mills();
    void editsPaths();
    void posts();
    void verifiesWhatItPosted();
    void refusesAProgramThatGouges();
    void replaysATraceToTheSameCut();
    void replaysATakeThatWasSwitchedOff();
    void keepsShankAndHolderFromTheStock();
    void millsThePapersBlock();

private:
    static void loadsAgree(const QJsonObject& answer);
    QString inFolder(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
    QString model_ = BURIN_FIXTURES "/models/pocket-test.stl";
    QString project_, program_;
};

void StagesTest::initTestCase() {
    project_ = inFolder("pocket.burin");
    program_ = inFolder("pocket.ngc");
}

void StagesTest::imports() {
    const ProgramRun run = runBurin({"import", model_, "--json"});
    QCOMPARE(run.status, 0);
    const QJsonObject model = run.json();
    QCOMPARE(model["bodies"].toArray().size(), 1);
    QVERIFY(std::abs(model["volume_mm3"].toDouble() - 167'200.0) < 1e-6);
    const QJsonArray high = model["bounding_box_mm"].toArray()[1].toArray();
    QCOMPARE(high[2].toDouble(), 18.0);
}

void StagesTest::embeds() {
    const ProgramRun run = runBurin(
        {"embed", model_, "-o", project_, "--voxel", "1", "--margin", "3", "--material", "tooling-board", "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonObject answer = run.json();
    QCOMPARE(answer["voxels"].toArray(), (QJsonArray{106, 106, 24}));
    // Every face of this part lies on a voxel face: the embedded volume is exact.
    QVERIFY(std::abs(answer["part_volume_mm3"].toDouble() - 167'200.0) < 1e-6);
    QVERIFY(std::abs(answer["stock_volume_mm3"].toDouble() - (106.0 * 106.0 * 24.0 - 167'200.0)) < 1e-6);
    QCOMPARE(answer["project"].toString(), project_);
}

void StagesTest::mills() {
    const ProgramRun run =
        runBurin({"mill", project_, "--tool", "ball-6", "--step-over", testing::inLongRun("1", "2"), "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonArray takes = run.json()["takes"].toArray();
    QCOMPARE(takes.size(), 2);
    for (const auto& take : takes) {
        const QJsonObject figures = take.toObject();
        QCOMPARE(figures["samples"].toInteger(), figures["ticks"].toInteger());
        const double removed = figures["removed_mm3"].toDouble(), drop = figures["workpiece_drop_mm3"].toDouble();
        QVERIFY(removed > 100.0);
        QVERIFY(std::abs(removed - drop) <= 1e-9 * drop);
        // A ball of 6 mm, whatever its direction: the area is at most its width times the sum of depth and width.
        const QJsonObject cut = figures["heaviest_cut"].toObject();
        QCOMPARE(cut["material"].toString(), QString("tooling-board"));
        const double depth = cut["depth_mm"].toDouble(), area = cut["area_mm2"].toDouble();
        QVERIFY2(area > 0.0 && area <= 6.0 * (depth + 6.0), qPrintable(QStringLiteral("%1 %2").arg(area).arg(depth)));
        QVERIFY(cut["feed_mm_per_min"].toDouble() > 0.0 && cut["spindle_speed_rpm"].toDouble() > 0.0);
    }
}

void StagesTest::editsPaths() {
    QCOMPARE(runBurin({"path", project_, "new", "--name", "first", "--json"}).status, 0);
    const ProgramRun listed = runBurin({"path", project_, "list", "--json"});
    QCOMPARE(listed.status, 0);
    const QJsonObject path = listed.json()["paths"].toArray()[0].toObject();
    QCOMPARE(path["name"].toString(), QString("first"));
    const qsizetype edits = path["edits"].toArray().size();
    QVERIFY(edits >= 7);
    const QString smooth = R"({"edit":"smooth","enabled":true,"cut_off_hz":4.0,"tolerance_mm":0.01})";
    QVERIFY2(runBurin({"path", project_, "apply", "1", "--edit", smooth, "--place", "0"}).status == 0, "apply");
    QCOMPARE(runBurin({"path", project_, "--json"}).json()["paths"].toArray()[0].toObject()["edits"].toArray().size(),
             edits + 1);
    // An edit of an earlier version stays as it is until its update is requested.
    QCOMPARE(runBurin({"path", project_, "update", "1", "--place", "0"}).status, 0);
    QCOMPARE(runBurin({"path", project_, "--json"})
                 .json()["paths"]
                 .toArray()[0]
                 .toObject()["edits"]
                 .toArray()[0]
                 .toObject()["edit"]
                 .toString(),
             QString("smooth-shape"));
    QCOMPARE(runBurin({"path", project_, "update", "1", "--place", "0"}).status, 2);
    QCOMPARE(runBurin({"path", project_, "undo", "1", "--place", "0"}).status, 0);
    QCOMPARE(runBurin({"path", project_, "undo", "1", "--place", "99"}).status, 2);
    QCOMPARE(runBurin({"path", project_, "apply", "1", "--edit", "{}", "--place", "0"}).status == 0, false);
    const ProgramRun shown = runBurin({"path", project_, "show", "1", "--csv", inFolder("path.csv"), "--json"});
    QVERIFY2(shown.status == 0, shown.messages.constData());
    QCOMPARE(shown.json()["reports"].toArray().size(), edits);
    QVERIFY(QFileInfo(inFolder("path.csv")).size() > 1000);
}

void StagesTest::posts() {
    const ProgramRun run = runBurin({"post", project_, "-o", program_, "--json"});
    QVERIFY2(run.status == 0, run.messages + run.output);
    const QJsonObject answer = run.json();
    QVERIFY(answer["gouge_max_mm"].toDouble() <= 0.02);
    QCOMPARE(answer["findings"].toArray().size(), 0);
    const auto moves = canonicalMoves(program_, folder_.path(), answer["tool"].toObject()["number"].toInt(), 6.0);
    QVERIFY2(moves && moves->size() > 100, "rs274 refused the program");
    // A later `info` reports that the program passed, as long as nothing that was checked has changed.
    const auto verdict = [](const QString& project) {
        return runBurin({"info", project, "--json"}).json()["verdict"].toObject();
    };
    QCOMPARE(verdict(project_)["state"].toString(), QString("passed"));
    QCOMPARE(verdict(project_)["gouge_max_mm"].toDouble(), answer["gouge_max_mm"].toDouble());
    const QString changed = inFolder("changed.burin");
    QVERIFY(QFile::copy(project_, changed) && runBurin({"path", changed, "new"}).status == 0);
    QCOMPARE(verdict(changed)["state"].toString(), QString("out_of_date"));
    QCOMPARE(verdict(changed)["passed"].toBool(), false);
}

/// The loads by block, over time and at the peak agree, and the blocks add up to the removed volume and the time.
void StagesTest::loadsAgree(const QJsonObject& answer) {
    double removed = 0.0, force = 0.0, cutting = 0.0;
    const QJsonArray blocks = answer["load_by_block"].toArray();
    QVERIFY(!blocks.isEmpty());
    for (const QJsonValue& block : blocks) {
        removed += block["removed_mm3"].toDouble();
        cutting += block["duration_s"].toDouble();
        force = std::max(force, block["peak"]["force_n"].toDouble());
        QVERIFY(block["mean_force_n"].toDouble() <= block["peak"]["force_n"].toDouble() * 1.001);
    }
    QVERIFY(std::abs(removed - answer["removed_mm3"].toDouble()) < 1e-3 * removed);
    QVERIFY(force > 0.0);
    QCOMPARE(answer["peak_load"]["force_n"].toDouble(), force);
    const QJsonObject chart = answer["load_over_time"].toObject();
    double most = 0.0;
    for (const QJsonValue& one : chart["force_n"].toArray()) most = std::max(most, one.toDouble());
    QVERIFY(std::abs(most - force) < 1e-4 * force);
    const double whole = answer["machining_s"].toDouble();
    QVERIFY(std::abs(chart["interval_s"].toDouble() * double(chart["force_n"].toArray().size() - 1) - whole) <
            1e-6 * whole);
    QVERIFY(cutting > 0.0 && cutting <= whole);
    QVERIFY(answer["machining_contains"].toArray().contains("tool_changes"));
}

void StagesTest::verifiesWhatItPosted() {
    const ProgramRun run =
        runBurin({"verify", program_, "--project", project_, "--map", inFolder("map.vtp"), "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonObject answer = run.json();
    QVERIFY(answer["passed"].toBool());
    loadsAgree(answer);
    QFile map(inFolder("map.vtp"));
    QVERIFY(map.open(QIODevice::ReadOnly));
    const QByteArray text = map.readAll();
    QVERIFY(text.contains("PolyData") && text.contains("excess_mm"));
    QVERIFY(text.contains("deviation_mm") && text.contains("colour"));
    const QJsonArray scale = run.json()["map_scale"].toArray();
    QVERIFY(scale.size() >= 3 && scale.first().toObject()["deviation_mm"].toDouble() < -0.02);
    QCOMPARE(scale.last().toObject()["deviation_mm"].toDouble(), 2.0);
    QCOMPARE(scale.last().toObject()["colour"].toArray().size(), 3);
}

void StagesTest::refusesAProgramThatGouges() {
    QFile good(program_);
    QVERIFY(good.open(QIODevice::ReadOnly));
    QByteArray text = good.readAll();
    // A plunge into the middle of the part, before the spindle stops.
    const qsizetype stop = text.lastIndexOf("M5");
    QVERIFY(stop > 0);
    text.insert(stop, "G0 X45 Y45\nG1 Z-6 F300\nG1 Z5\n");
    QFile bad(inFolder("bad.ngc"));
    QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write(text) == text.size());
    bad.close();
    const ProgramRun run = runBurin({"verify", bad.fileName(), "--project", project_, "--json"});
    QCOMPARE(run.status, 1);
    const QJsonObject answer = run.json();
    QVERIFY(std::abs(answer["gouge_max_mm"].toDouble() - 3.0) < 0.01); // 3 mm of stock above the part, cut 6 mm deep
    QCOMPARE(answer["findings"].toArray()[0].toObject()["kind"].toString(), QString("gouge"));
}

void StagesTest::replaysATraceToTheSameCut() {
    const QString trace = inFolder("roughing.csv");
    QCOMPARE(runBurin({"path", project_, "trace", "1", "-o", trace}).status, 0);
    const QString second = inFolder("second.burin");
    QCOMPARE(runBurin({"embed", model_, "-o", second, "--voxel", "1", "--margin", "3", "--material", "tooling-board"})
                 .status,
             0);
    const ProgramRun run =
        runBurin({"mill", second, "--tool", "ball-6", "--stylus", "trace:" + trace, "--allowance", "0.5", "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const ProgramRun first = runBurin({"path", project_, "take", "1", "-o", inFolder("a.csv")});
    QCOMPARE(first.status, 0);
    QCOMPARE(runBurin({"path", second, "take", "1", "-o", inFolder("b.csv")}).status, 0);
    QFile a(inFolder("a.csv")), b(inFolder("b.csv"));
    QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    QVERIFY(a.size() > 100'000);
    QVERIFY2(a.readAll() == b.readAll(), "the replayed take differs");

    // A trace made from a take contains only readings; the assumed share of the felt force is stated as such, not
    // passed off as recorded.
    QCOMPARE(run.json()["felt"].toObject()["source"].toString(), QString("assumed"));
    QVERIFY2(run.messages.contains("felt") && run.messages.count('\n') == 1, run.messages.constData());
    const QStringList told{"mill",        second, "--tool",    "ball-6", "--stylus", "trace:" + trace,
                           "--allowance", "0.5",  "--seconds", "1",      "--json",   "--felt"};
    const ProgramRun soft = runBurin(told + QStringList{"0.02"});
    QVERIFY2(soft.status == 0 && soft.messages.isEmpty(), soft.messages.constData());
    const QJsonObject felt = soft.json()["felt"].toObject();
    QCOMPARE(felt["source"].toString(), QString("argument"));
    QCOMPARE(felt["gain"].toDouble(), 0.02);
    QCOMPARE(runBurin({"mill", second, "--felt", "0.5", "--seconds", "1"}).status, 2); // the operator has its own

    // A recording is not replaced by accident.
    const QStringList again{"embed", model_, "-o", second, "--voxel", "1", "--margin", "3"};
    const auto takes = [&] { return runBurin({"info", second, "--json"}).json()["takes"].toArray().size(); };
    const auto recorded = takes();
    QVERIFY(recorded > 0);
    const ProgramRun refused = runBurin(again);
    QCOMPARE(refused.status, 2);
    QVERIFY2(refused.messages.contains("--replace"), refused.messages.constData());
    QCOMPARE(takes(), recorded);
    QCOMPARE(runBurin(again + QStringList{"--replace"}).status, 0);
    QCOMPARE(takes(), 0);
}

/// The trace of a take that does not count mills it and undoes it where it ends: the workpiece is as at first.
void StagesTest::replaysATakeThatWasSwitchedOff() {
    const QString off = inFolder("off.burin"), trace = inFolder("off.csv"), fresh = inFolder("fresh.burin");
    QVERIFY(QFile::copy(project_, off));
    QCOMPARE(runBurin({"take", "off", off, "1"}).status, 0);
    QCOMPARE(runBurin({"path", off, "trace", "1", "-o", trace}).status, 0);
    QFile written(trace);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray text = written.readAll();
    QVERIFY(text.endsWith("!{\"stroke\":\"undone\"}\n"));
    QCOMPARE(text.count("undone"), 1);
    QCOMPARE(runBurin({"embed", model_, "-o", fresh, "--voxel", "1", "--margin", "3"}).status, 0);
    const ProgramRun run = runBurin({"mill", fresh, "--stylus", "trace:" + trace, "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonObject take = run.json()["takes"].toArray()[0].toObject();
    QVERIFY(take["samples"].toInt() > 1000);
    QCOMPARE(take["removed_mm3"].toDouble(), 0.0);
    QCOMPARE(take["workpiece_drop_mm3"].toDouble(), 0.0);
}

void StagesTest::keepsShankAndHolderFromTheStock() {
    const QString file = inFolder("kept-away.burin");
    QCOMPARE(
        runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", file, "--voxel", "1", "--margin", "5"}).status, 0);
    const QStringList mill{"mill", file, "--tool", "ball-6", "--intent", "scribble", "--seconds", "1", "--json"};
    const ProgramRun kept = runBurin(mill + QStringList{"--stock-distance", "1.5"}), touching = runBurin(mill);
    QVERIFY2(kept.status == 0, kept.messages.constData());
    QCOMPARE(kept.json()["stock_distance_mm"].toDouble(), 1.5);
    QVERIFY(kept.json()["takes"].toArray()[0].toObject()["stock_distance_ticks"].isDouble());
    QCOMPARE(touching.status, 0);
    QVERIFY(touching.json()["stock_distance_mm"].isNull());
}

void StagesTest::millsThePapersBlock() {
    const ProgramRun run = runBurin({"demo", "--block", "--json", "--output", inFolder("block")});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QJsonObject answer = run.json();
    QVERIFY(answer["removed_mm3"].toDouble() > 0.0);
    QCOMPARE(answer["tool"].toObject()["diameter_mm"].toDouble(), 1.0);
    // 40 × 32 × 40 voxels of 0.1 mm.
    QVERIFY(std::abs(answer["stock_volume_mm3"].toDouble() - 4.0 * 3.2 * 4.0) < 1e-9);
    QVERIFY(
        canonicalMoves(answer["program"].toString(), folder_.path(), answer["tool"].toObject()["number"].toInt(), 1.0));
}

BURIN_TEST(StagesTest, QCoreApplication)

} // namespace burin::tst_stages

#include "tst_stages.moc"

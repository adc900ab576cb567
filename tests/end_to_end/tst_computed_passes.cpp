// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "part_judge.h"
#include "program_run.h"

#include "core/base/units.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_computed_passes {

/// From a part to a checked program without a recording. Oracles: LinuxCNC's interpreter for the program, OpenCASCADE
/// for the part, the dimensions in the drawings.
class ComputedPassesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QCOMPARE(
            run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("p.burin"), "--voxel", "1"})
                .status,
            0);
    }

    void aPartIsRoughedAndFinished() {
        const ProgramRun rough =
            path({"new", "--pass", "levels", "--tool", "flat-10", "--allowance", "0.3", "--bottom", "18"});
        QVERIFY2(rough.status == 0, rough.messages.constData());
        QVERIFY(rough.json()["strokes"].toInt() > 10);
        const ProgramRun fine = path({"new", "--pass", "parallel", "--tool", "ball-6", "--step-over", "1.2",
                                      "--steepest", "50", "--bottom", "18"});
        QVERIFY2(fine.status == 0, fine.messages.constData());
        const ProgramRun steep =
            path({"apply", "2", "--pass", "waterline", "--step-over", "1.2", "--flattest", "40", "--bottom", "18"});
        QVERIFY2(steep.status == 0, steep.messages.constData());
        QCOMPARE(steep.json()["passes"].toArray().size(), 2);
        const QJsonObject shown = path({"show", "2"}).json();
        for (const QJsonValue& pass : shown["passes"].toArray()) {
            QVERIFY(pass["length_mm"].toDouble() > 1000.0);
            QVERIFY(pass["time_s"].toDouble() > 10.0);
            QVERIFY(pass["left_over"].toObject()["reachable_mm2"].toDouble() > 100.0);
        }
        const QJsonObject left = shown["passes"].toArray().last().toObject()["left_over"].toObject();
        // Contours 1.2 mm apart are 1.87 mm apart on a slope of 40 degrees; between them a ball of 6 mm leaves this
        // ridge.
        const double ridge = std::hypot(0.6 / std::sin(glm::radians(40.0)), 3.0) - 3.0;
        QVERIFY2(left["most_mm"].toDouble() < ridge + 0.002, QJsonDocument(left).toJson().constData());
        QVERIFY(left["within_99_percent_mm"].toDouble() > 0.03);
        const ProgramRun post = run({"post", in("p.burin"), "-o", in("p.ngc")});
        QVERIFY2(post.status == 0, post.messages.constData());
        const QJsonObject told = post.json();
        QVERIFY(told["passed"].toBool());
        QCOMPARE(told["findings"].toArray().size(), 0);
        QCOMPARE(told["tool_changes"].toInt(), 2);
    }

    /// The finishing program alone, judged by LinuxCNC's moves and OpenCASCADE's part.
    void theProgramKeepsOffThePart() {
        // Alone it cuts through stock that the other path removes, so its check refuses it rightly.
        const ProgramRun post =
            run({"post", in("p.burin"), "--path", "2", "-o", in("fine.ngc"), "--override", "a test reads it"});
        QVERIFY2(post.status == 0, post.messages.constData());
        const QJsonArray offset = post.json()["work_offset_mm"].toArray();
        const auto moves = canonicalMoves(in("fine.ngc"), folder_.path(), 3, 6.0);
        QVERIFY(moves && moves->size() > 500);
        const auto judge = PartJudge::of(BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", 3.0);
        QVERIFY(judge);
        const auto samples = judge->along(*moves, {offset[0].toDouble(), offset[1].toDouble(), offset[2].toDouble()});
        const std::optional<double> gouge = judge->exactGouge(samples, 100);
        QVERIFY2(gouge && *gouge <= 0.01, qPrintable(QString::number(gouge.value_or(99.0))));
        // It is a finishing pass: where it cuts, it touches the part.
        const auto touching = std::ranges::count_if(
            samples, [](const ToolSample& sample) { return sample.cutting && sample.clearance < 0.02; });
        const auto cutting = std::ranges::count_if(samples, &ToolSample::cutting);
        QVERIFY2(touching * 10 > cutting * 8, qPrintable(QString("%1 of %2").arg(touching).arg(cutting)));
    }

    /// A smaller tool after a larger one mills only where the larger one left stock.
    void aSmallerToolMillsTheRest() {
        const ProgramRun all = path({"new", "--pass", "levels", "--tool", "flat-6", "--allowance", "0.3",
                                     "--level-depth", "3", "--bottom", "18"});
        if (all.status == 0) {
            QVERIFY2(all.json()["length_mm"].toDouble() <
                         0.25 * path({"show", "1"}).json()["passes"][0]["length_mm"].toDouble(),
                     all.output.constData());
        } else {
            QVERIFY(all.messages.contains("stock")); // no stock is left
        }
    }

    void anAreaOfADrawingIsKept() {
        write("area.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='30mm' height='20mm' viewBox='0 0 30 20'>"
                          "<rect width='30' height='20'/></svg>");
        QCOMPARE(run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("a.burin"), "--voxel",
                      "1", "--margin", "1"})
                     .status,
                 0);
        const ProgramRun made = run({"path", in("a.burin"), "new", "--pass", "parallel", "--tool", "ball-4",
                                     "--step-over", "0.5", "--area", in("area.svg"), "--move", "-15,-10"});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(run({"path", in("a.burin"), "show", "1", "--csv", in("p.csv")}).status, 0);
        int cuts = 0;
        for (const QString& line : contentOf(in("p.csv")).split('\n').mid(1)) {
            const QStringList columns = line.split(',');
            if (columns.size() < 4 || columns[0] != "cut") continue;
            ++cuts;
            QVERIFY2(std::abs(columns[1].toDouble()) <= 15.02 && std::abs(columns[2].toDouble()) <= 10.02,
                     qPrintable(line));
        }
        QVERIFY(cuts > 20);
    }

    /// The area painted by a take is milled, then with another value, then again with the same request.
    void paintedStrokesAreMilled() {
        QCOMPARE(run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("f.burin"), "--voxel",
                      "1", "--margin", "1"})
                     .status,
                 0);
        const ProgramRun recorded = run({"mill", in("f.burin"), "--tool", "ball-6", "--seconds", "3"});
        QVERIFY2(recorded.status == 0, recorded.messages.constData());
        const ProgramRun painted = run({"path", in("f.burin"), "new", "--pass", "scallop", "--tool", "ball-4",
                                        "--scallop", "0.02", "--paint", "1", "--brush", "6"});
        QVERIFY2(painted.status == 0, painted.messages.constData());
        const QJsonObject request = painted.json()["passes"].toArray().last().toObject()["request"].toObject();
        QVERIFY(request["area_on_part"].toBool() && !request["area"].toArray().isEmpty());
        // In place of the first pass, with another value; then recomputed with the same request.
        const int id = painted.json()["pass"].toInt();
        const double length = painted.json()["length_mm"].toDouble();
        const QString path = QString::number(painted.json()["id"].toInt());
        const ProgramRun other = run({"path", in("f.burin"), "apply", path, "--pass", "scallop", "--scallop", "0.08",
                                      "--paint", "1", "--brush", "6", "--instead", QString::number(id)});
        QVERIFY2(other.status == 0, other.messages.constData());
        QCOMPARE(other.json()["passes"].toArray().size(), 1);
        // Ridges of four times the height are twice as far apart.
        QVERIFY2(std::abs(other.json()["length_mm"].toDouble() - 0.5 * length) < 0.1 * length,
                 other.output.constData());
        const ProgramRun again = run({"path", in("f.burin"), "recompute", path});
        QVERIFY2(again.status == 0, again.messages.constData());
        QCOMPARE(again.json()["passes"].toArray().size(), 1);
        QCOMPARE(again.json()["computed"][0]["length_mm"].toDouble(), other.json()["length_mm"].toDouble());
        const ProgramRun unknown = runBurin({"path", in("f.burin"), "recompute", path, "--pass", "-99"});
        QVERIFY(unknown.status != 0 && unknown.messages.contains("-99"));
        const ProgramRun beside =
            runBurin({"path", in("f.burin"), "new", "--pass", "parallel", "--tool", "ball-4", "--face", "900,0,0"});
        QVERIFY(beside.status != 0 && beside.messages.contains("point on the part"));
    }

    /// When the take that leads a pass changes, this pass is out of date and no other; it alone is computed again.
    void aChangedStrokeConcernsItsPassAlone() {
        QCOMPARE(
            run({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("l.burin"), "--voxel", "0.5", "--margin", "1"})
                .status,
            0);
        const ProgramRun recorded = run({"mill", in("l.burin"), "--tool", "ball-6", "--seconds", "2"});
        QVERIFY2(recorded.status == 0, recorded.messages.constData());
        const ProgramRun led = run({"path", in("l.burin"), "new", "--pass", "radial", "--tool", "ball-4", "--step-over",
                                    "2", "--steepest", "30", "--lead", "1"});
        QVERIFY2(led.status == 0, led.messages.constData());
        const QString path = QString::number(led.json()["id"].toInt());
        QCOMPARE(led.json()["passes"][0]["request"]["leads"][0]["take"].toInt(), 1);
        const ProgramRun plain =
            run({"path", in("l.burin"), "apply", path, "--pass", "parallel", "--step-over", "2", "--steepest", "30"});
        QVERIFY2(plain.status == 0, plain.messages.constData());
        const auto outdated = [&] {
            QList<bool> each;
            for (const QJsonValue& pass : run({"path", in("l.burin"), "show", path}).json()["passes"].toArray())
                each.append(pass["out_of_date"].toBool());
            return each;
        };
        QCOMPARE(outdated(), (QList<bool>{false, false}));
        const QString stored = contentOf(in("l.burin"));
        const ProgramRun nothing = run({"path", in("l.burin"), "recompute", path, "--outdated"});
        QVERIFY(contentOf(in("l.burin")) == stored); // nothing is saved
        QVERIFY2(nothing.status == 0, nothing.messages.constData());
        QVERIFY(nothing.json()["computed"].toArray().isEmpty());
        const QJsonArray before = nothing.json()["passes"].toArray();
        const ProgramRun off = run({"take", "off", in("l.burin"), "1", "--from", "1"});
        QVERIFY2(off.status == 0, off.messages.constData());
        QCOMPARE(outdated(), (QList<bool>{true, false}));
        const ProgramRun told = runBurin({"path", in("l.burin"), "show", path});
        QVERIFY2(told.output.contains("out of date"), told.output.constData());
        const ProgramRun again = run({"path", in("l.burin"), "recompute", path, "--outdated"});
        QVERIFY2(again.status == 0, again.messages.constData());
        QCOMPARE(again.json()["computed"].toArray().size(), 1);
        const QJsonArray after = again.json()["passes"].toArray();
        QVERIFY(after.at(0) != before.at(0));
        QCOMPARE(after.at(1), before.at(1)); // the same pass, not one like it
        QCOMPARE(outdated(), (QList<bool>{false, false}));
        QCOMPARE(run({"take", "on", in("l.burin"), "1"}).status, 0);
        QCOMPARE(outdated(), (QList<bool>{true, false}));
    }

    /// A pass heeds the takes before it in its path, and is out of date when they change.
    void handStrokesOfAPathAreHeeded() {
        const ProgramRun made = run({"path", in("l.burin"), "new", "--takes", "1"});
        QVERIFY2(made.status == 0, made.messages.constData());
        const QString path = QString::number(made.json()["id"].toInt());
        const ProgramRun kept = run({"path", in("l.burin"), "apply", path, "--pass", "parallel", "--step-over", "2",
                                     "--steepest", "30", "--hand", "keep-off", "--finished-within", "1"});
        QVERIFY2(kept.status == 0, kept.messages.constData());
        QVERIFY(kept.json().contains("left_to_hand_mm"));
        const QJsonObject request = kept.json()["passes"][0]["request"].toObject();
        QCOMPARE(request["hand"].toString(), QString("keep-off"));
        QCOMPARE(request["strokes_digest"].toString().size(), qsizetype(16));
        const auto outdated = [&] {
            return run({"path", in("l.burin"), "show", path}).json()["passes"][0]["out_of_date"].toBool();
        };
        QVERIFY(!outdated());
        QCOMPARE(run({"take", "off", in("l.burin"), "1", "--from", "0.5"}).status, 0);
        QVERIFY(outdated());
        QCOMPARE(run({"path", in("l.burin"), "recompute", path, "--outdated"}).status, 0);
        QVERIFY(!outdated());
        const ProgramRun wrong =
            runBurin({"path", in("l.burin"), "apply", path, "--pass", "parallel", "--hand", "extend"});
        QVERIFY(wrong.status != 0);
        QVERIFY2(wrong.messages.contains("only flow extends"), wrong.messages.constData());
    }

    /// A line of a drawing in inches is engraved on a plate: the tool moves along it at the requested depth.
    void linesAreEngraved() {
        QCOMPARE(
            run({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("e.burin"), "--voxel", "0.5", "--margin", "2"})
                .status,
            0);
        const QJsonObject info = run({"info", in("e.burin")}).json();
        const double top = info["model"]["bounding_box_mm"].toArray()[1].toArray()[2].toDouble() + 1.0;
        QVERIFY(top > 2.0); // a millimetre above the part and a millimetre below the top of the stock
        write("line.dxf",
              "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0"
              "\n20\n0\n11\n0.2\n21\n0.3\n0\nENDSEC\n0\nEOF\n");
        const ProgramRun made =
            run({"path", in("e.burin"), "new", "--pass", "engrave", "--tool", "flat-1", "--lines", in("line.dxf"),
                 "--top", QString::number(top), "--depth", "0.4", "--level-depth", "0.4"});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(run({"path", in("e.burin"), "show", "1", "--csv", in("e.csv")}).status, 0);
        glm::dvec3 farthest(-1e9);
        double lowest = 1e9;
        for (const QString& line : contentOf(in("e.csv")).split('\n').mid(1)) {
            const QStringList columns = line.split(',');
            if (columns.size() < 4 || columns[0] == "rapid") continue;
            farthest = glm::max(farthest, glm::dvec3(columns[1].toDouble(), columns[2].toDouble(), 0.0));
            lowest = std::min(lowest, columns[3].toDouble());
        }
        QVERIFY2(std::abs(farthest.x - 0.2 * 25.4) < 0.02 && std::abs(farthest.y - 0.3 * 25.4) < 0.02,
                 qPrintable(QString("%1 %2").arg(farthest.x).arg(farthest.y)));
        QVERIFY2(std::abs(lowest - (top - 0.4)) < 0.001, qPrintable(QString("%1 below %2").arg(lowest).arg(top)));
    }

    /// A slot of 6 mm, 1.5 mm deep: its volume by a closed formula, and half of the cutter's circumference engaged.
    void figuresOfAPassAreThoseOfItsSlot() {
        QCOMPARE(run({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("slot.burin"), "--voxel", "0.2", "--margin",
                      "2"})
                     .status,
                 0);
        const QJsonObject info = run({"info", in("slot.burin")}).json();
        const double part = info["model"]["bounding_box_mm"].toArray()[1].toArray()[2].toDouble();
        const ProgramRun made =
            run({"path", in("slot.burin"), "new", "--pass", "engrave", "--tool", "flat-6", "--lines", in("line.dxf"),
                 "--top", QString::number(part + 1.5), "--depth", "1", "--level-depth", "2", "--move", "1.5,1"});
        QVERIFY2(made.status == 0, made.messages.constData());
        const QJsonObject slot = run({"path", in("slot.burin"), "show", "1"}).json()["passes"][0].toObject();
        const QByteArray told = QJsonDocument(slot).toJson();
        const double volume = 1.5 * (6.0 * 25.4 * std::hypot(0.2, 0.3) + pi * 9.0);
        QVERIFY2(std::abs(slot["removed_mm3"].toDouble() - volume) < 0.02 * volume, told.constData());
        QVERIFY2(slot["engagement_95_rad"].toDouble() > pi - 0.5, told.constData());
        QVERIFY2(slot["air_share"].toDouble() > 0.0 && slot["air_share"].toDouble() < 0.7, told.constData());
    }

    /// A cube has no concave edges, which the answer states.
    void aPencilNeedsConcaveEdges() {
        const ProgramRun none = runBurin({"path", in("slot.burin"), "new", "--pass", "pencil", "--tool", "ball-3"});
        QVERIFY(none.status != 0);
        QVERIFY2(none.messages.contains("concave edge"), none.messages.constData());
    }

    /// Deleting a path deletes its passes; of two passes a single one can be deleted.
    void passesAreDeleted() {
        const auto passesOf = [&] {
            return run({"path", in("e.burin"), "list"}).json()["paths"][0]["passes"].toArray();
        };
        QCOMPARE(run({"path", in("e.burin"), "apply", "1", "--pass", "engrave", "--lines", in("line.dxf"), "--depth",
                      "0.2", "--move", "1,0"})
                     .status,
                 0);
        QCOMPARE(passesOf().size(), 2);
        // The user determines the order in which they are milled.
        const auto firstId = [&] { return passesOf().at(0).toObject()["id"].toInt(); };
        QCOMPARE(firstId(), -1);
        QCOMPARE(run({"path", in("e.burin"), "order", "1", "--pass", "-2", "--place", "0"}).status, 0);
        QCOMPARE(firstId(), -2);
        const ProgramRun beyond = runBurin({"path", in("e.burin"), "order", "1", "--pass", "-2", "--place", "2"});
        QVERIFY(beyond.status != 0 && beyond.messages.contains("0 to 1"));
        QVERIFY(runBurin({"path", in("e.burin"), "order", "1", "--pass", "-9", "--place", "0"}).status != 0);
        QCOMPARE(run({"path", in("e.burin"), "order", "1", "--pass", "-2", "--place", "1"}).status, 0);
        QCOMPARE(firstId(), -1);
        const ProgramRun unknown = runBurin({"path", in("e.burin"), "delete", "1", "--pass", "-9"});
        QVERIFY(unknown.status != 0 && unknown.messages.contains("-9"));
        QCOMPARE(run({"path", in("e.burin"), "delete", "1", "--pass", "-1"}).status, 0);
        QCOMPARE(passesOf().size(), 1);
        QCOMPARE(passesOf().at(0).toObject()["id"].toInt(), -2);
        QCOMPARE(run({"path", in("e.burin"), "delete", "1"}).status, 0);
        QCOMPARE(run({"path", in("e.burin"), "list"}).json()["paths"].toArray().size(), 0);
    }

    /// Passes of an older project do not contain their request; the answer is valid JSON nevertheless.
    void passesOfOlderProjectsAreListed() {
        QVERIFY(QFile::copy(BURIN_FIXTURES "/projects/v8/small.burin", in("old.burin")));
        const QJsonArray paths = run({"path", in("old.burin"), "list", "--setup", "2"}).json()["paths"].toArray();
        QCOMPARE(paths.size(), 1);
        const QJsonArray passes = paths.at(0).toObject()["passes"].toArray();
        QCOMPARE(passes.size(), 1);
        QVERIFY(passes.at(0).toObject()["request"].isNull());
    }

    void badRequestsAreOneSentence_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        QTest::newRow("no tool") << QStringList{"--pass", "levels"} << "tool";
        QTest::newRow("unknown tool") << QStringList{"--pass", "levels", "--tool", "spoon"} << "spoon";
        QTest::newRow("a drill") << QStringList{"--pass", "levels", "--tool", "drill-6"} << "sideways";
        QTest::newRow("wide step") << QStringList{"--pass", "levels", "--tool", "flat-6", "--step-over", "5"}
                                   << "radius";
        QTest::newRow("scallop of a sharp edge")
            << QStringList{"--pass", "parallel", "--tool", "flat-6", "--scallop", "0.01"} << "rounded";
        QTest::newRow("pocket without an area") << QStringList{"--pass", "pocket", "--tool", "flat-6"} << "area";
        QTest::newRow("no file") << QStringList{"--pass", "pocket", "--tool", "flat-6", "--area", "/nowhere/a.dxf"}
                                 << "a.dxf";
        QTest::newRow("no drawing") << QStringList{"--pass", "pocket", "--tool",
                                                   "flat-6", "--area", BURIN_FIXTURES "/models/cube.brep"}
                                    << "neither";
        QTest::newRow("overlap without blending")
            << QStringList{"--pass", "parallel", "--tool", "ball-6", "--overlap", "1"} << "blend";
        QTest::newRow("no such take") << QStringList{"--pass", "flow", "--tool", "ball-6", "--lead", "7"}
                                      << "recording";
    }
    void badRequestsAreOneSentence() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        const QByteArray before = run({"path", in("p.burin"), "list"}).output;
        const ProgramRun failed = runBurin(QStringList{"path", in("p.burin"), "new"} + arguments);
        QVERIFY(failed.status > 0 && failed.status < 10);
        QVERIFY2(failed.messages.contains(says.toUtf8()), failed.messages.constData());
        QCOMPARE(failed.messages.trimmed().count('\n'), 0);
        QCOMPARE(run({"path", in("p.burin"), "list"}).output, before);
    }

private:
    QString in(const QString& name) const { return folder_.filePath(name); }
    ProgramRun run(QStringList arguments) const { return runBurin(arguments << "--json"); }
    ProgramRun path(const QStringList& arguments) const { return run(QStringList{"path", in("p.burin")} + arguments); }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    QTemporaryDir folder_;
};

BURIN_TEST(ComputedPassesTest, QCoreApplication)

} // namespace burin::tst_computed_passes

#include "tst_computed_passes.moc"

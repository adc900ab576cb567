// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "part_judge.h"
#include "program_run.h"

#include "core/job/milling_context.h"
#include "tests/core/geometry/shapes.h"
#include "tests/oracles/tool_depth.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_surroundings {

namespace {

bool writeStl(const QString& name, const TriangleMesh& mesh) {
    const QByteArray text = testing::stlText(mesh);
    QFile file(name);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

QJsonObject layerCalled(const QJsonObject& take, const char* name) {
    for (const auto& layer : take["layers"].toArray())
        if (layer.toObject()["name"].toString() == name) return layer.toObject();
    return {};
}

bool nameIsKnown(const QJsonObject& answer, const char* name) {
    for (const auto& obstacle : answer["obstacles"].toArray())
        if (obstacle.toObject()["name"].toString() == name) return true;
    return false;
}

/// The largest depth, mm, by which the ball of a tool enters the exact B-rep at the worst `count` of a take's proxies,
/// with any axes; nullopt if OpenCASCADE cannot compute it.
std::optional<double> exactGouge(const PartJudge& judge, const Take& take, double radius, std::size_t count) {
    const RevolvedPiece ball{0.0, 60.0, radius, radius, radius};
    std::vector<std::pair<double, ToolPose>> poses;
    for (const Sample& sample : take.samples)
        poses.emplace_back(judge.part().clearance({&ball, 1}, sample.proxy, 2.0).clearance, sample.proxy);
    count = std::min(count, poses.size());
    std::partial_sort(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(count), poses.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<glm::dvec3> centres;
    for (std::size_t i = 0; i < count; ++i) centres.push_back(poses[i].second.tip + radius * poses[i].second.axis);
    Progress progress;
    const auto distances = exactSignedDistances(judge.model(), centres, PartJudge::importOptions(), progress);
    if (!distances) return std::nullopt;
    double gouge = 0.0;
    for (const double distance : *distances) gouge = std::max(gouge, radius - distance);
    return gouge;
}

} // namespace

/// A job with fixtures and with a tilted tool, run by the real program.
class SurroundingsTest : public QObject {
    Q_OBJECT
private slots:
    void noTickHasTheToolInAFixture();
    void theProjectKeepsWhatStandsAround();
    void aProgramThroughAFixtureIsRefused();
    void aLeaningToolDoesNotGouge();
    void aLeaningPathIsNotPosted();

private:
    QString inFolder(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
    QString block_ = BURIN_FIXTURES "/models/cube.brep"; // 10 mm
};

/// A clamp that reaches over the stock and obstructs the virtual operator.
void SurroundingsTest::noTickHasTheToolInAFixture() {
    const Box clamp{{-7.0, 2.0, 12.0}, {6.0, 7.0, 22.0}}, space{{7.5, 7.5, 8.0}, {20.0, 20.0, 30.0}};
    constexpr double clearance = 0.4; // mm
    QVERIFY(writeStl(inFolder("clamp.stl"), shapes::box(clamp.low, clamp.high)));
    const QString project = inFolder("clamped.burin");
    const ProgramRun embedded =
        runBurin({"embed", block_, "-o", project, "--voxel", "0.5", "--margin", "5", "--material", "machinable-wax",
                  "--fixture", inFolder("clamp.stl"), "--keep-out", "7.5,7.5,8,20,20,30", "--clearance", "0.4"});
    QVERIFY2(embedded.status == 0, embedded.messages.constData());
    const ProgramRun run = runBurin({"mill", project, "--tool", "ball-6", "--seconds", "12", "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());

    QCOMPARE(run.json()["machine_travel_mm"].toArray().size(), 2);

    const Result<Project> opened = Project::open(project.toStdString());
    QVERIFY(opened);
    const Result<Tool> tool = toolFor(*opened, "ball-6");
    QVERIFY(tool);
    const oracles::ToolDepth depth(pieces(tool->cutter), 0.25);
    for (const auto& figures : run.json()["takes"].toArray()) {
        const QJsonObject take = figures.toObject();
        const Result<Take> recorded = opened->take(take["take"].toInteger());
        QVERIFY(recorded);
        for (const Box& solid : {clamp, space}) {
            const auto grown = [&](const glm::dvec3& place) {
                return shapes::boxDistance(solid.low, solid.high, place) - clearance;
            };
            double deepest = -1e300;
            for (const Sample& sample : recorded->samples)
                deepest = std::max(deepest, depth.at(sample.proxy, grown, {}));
            QVERIFY2(deepest < 1e-3, qPrintable(QString::number(deepest)));
        }
        QVERIFY(layerCalled(take, "clamp")["ticks_held"].toInteger() +
                    layerCalled(take, "keep-out")["ticks_held"].toInteger() >
                0);
        QVERIFY(take["obstacle_ticks"].toInteger() > 0);
        QVERIFY(take["removed_mm3"].toDouble() > 50.0); // it milled where there was room
    }
}

void SurroundingsTest::theProjectKeepsWhatStandsAround() {
    const QString project = inFolder("kept.burin");
    QVERIFY(writeStl(inFolder("vise.stl"), shapes::box({-30, -30, -20}, {-10, 30, 5})));
    QCOMPARE(runBurin({"embed", block_, "-o", project, "--voxel", "1"}).status, 0);
    QVERIFY(runBurin({"info", project, "--json"}).json()["obstacles"].toArray().isEmpty());
    const ProgramRun set = runBurin({"setup", project, "--fixture", inFolder("vise.stl"), "--keep-out",
                                     "-1,-1,40,1,1,50", "--axis", "0,3,4", "--travel", "100,100,150", "--json"});
    QVERIFY2(set.status == 0, set.messages.constData());
    const QJsonObject info = runBurin({"info", project, "--json"}).json();
    QVERIFY(nameIsKnown(info, "vise") && nameIsKnown(info, "keep-out"));
    QCOMPARE(info["axis"].toObject()["mode"].toString(), QString("chosen"));
    QCOMPARE(info["axis"].toObject()["direction"].toArray(), (QJsonArray{0.0, 0.6, 0.8}));
    QCOMPARE(info["machine_travel"].toObject()["zero_mm"].toArray(), (QJsonArray{100.0, 100.0, 150.0}));
    QCOMPARE(runBurin({"setup", project, "--remove", "vise", "--switch-off", "keep-out"}).status, 0);
    const QJsonArray left = runBurin({"setup", project, "--json"}).json()["obstacles"].toArray();
    QCOMPARE(left.size(), 1);
    QCOMPARE(left[0].toObject()["on"].toBool(), false);
}

/// A clamp that was added after milling obstructs the milled path.
void SurroundingsTest::aProgramThroughAFixtureIsRefused() {
    const QString project = inFolder("later.burin"), program = inFolder("later.ngc");
    QCOMPARE(runBurin({"embed", block_, "-o", project, "--voxel", "0.5", "--material", "machinable-wax"}).status, 0);
    QCOMPARE(runBurin({"mill", project, "--tool", "ball-6", "--seconds", "8"}).status, 0);
    const ProgramRun free = runBurin({"post", project, "-o", program});
    QVERIFY2(free.status == 0, free.messages.constData());
    QCOMPARE(runBurin({"setup", project, "--keep-out", "3,3,11,5,5,30"}).status, 0);
    const ProgramRun verified = runBurin({"verify", program, "--project", project, "--json"});
    QCOMPARE(verified.status, 1);
    bool found = false;
    for (const auto& finding : verified.json()["findings"].toArray())
        found = found || finding.toObject()["kind"].toString() == "obstacle_collision";
    QVERIFY(found);
    QFile::remove(program);
    QCOMPARE(runBurin({"post", project, "-o", program}).status, 1);
    QVERIFY(!QFile::exists(program));
    const QString reason = "the clamp is taken off before line 60";
    const ProgramRun wanted = runBurin({"post", project, "-o", program, "--override", reason, "--json"});
    QCOMPARE(wanted.status, 0);
    QVERIFY(wanted.json()["overridden"].toBool() && !wanted.json()["passed"].toBool());
    const QString whole = contentOf(program);
    QVERIFY2(whole.contains("(Reason: the clamp is taken off before line 60)") &&
                 whole.contains("REFUSED BY THE CHECK") && whole.contains("x obstacle_collision, worst "),
             qPrintable(whole.left(600)));
    // The findings name the lines of the text that was written.
    QCOMPARE(runBurin({"verify", program, "--project", project, "--json"}).json()["findings"],
             wanted.json()["findings"]);
    QCOMPARE(runBurin({"setup", project, "--switch-off", "keep-out"}).status, 0);
    QCOMPARE(runBurin({"post", project, "-o", program, "--override", reason}).status, 0);
    const QString passed = contentOf(program);
    QVERIFY(passed.contains("M2") && !passed.contains("REFUSED"));
}

void SurroundingsTest::aLeaningToolDoesNotGouge() {
    const char* model = BURIN_FIXTURES "/models/cube.brep";
    const QString project = inFolder("leaning.burin");
    QCOMPARE(runBurin({"embed", model, "-o", project, "--voxel", "0.2", "--margin", "3", "--material", "machinable-wax",
                       "--axis", "0.4,0.2,1"})
                 .status,
             0);
    const ProgramRun run = runBurin({"mill", project, "--tool", "ball-6", "--seconds", "25", "--json"});
    QVERIFY2(run.status == 0, run.messages.constData());
    QCOMPARE(run.json()["axis"].toObject()["mode"].toString(), QString("chosen"));
    QVERIFY(run.json()["machine_travel_mm"].isNull()); // a three-axis machine's says nothing of a leaning tool
    const std::optional<PartJudge> judge = PartJudge::of(model, 3.0);
    const Result<Project> opened = Project::open(project.toStdString());
    QVERIFY(judge && opened);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.4, 0.2, 1.0));
    double removed = 0.0;
    std::size_t pressed = 0;
    for (const auto& figures : run.json()["takes"].toArray()) {
        const Result<Take> take = opened->take(figures.toObject()["take"].toInteger());
        QVERIFY(take);
        for (const Sample& sample : take->samples) {
            QVERIFY(glm::distance(sample.proxy.axis, axis) < 1e-12);
            if ((sample.flags & sampleOnBoundary) != 0) ++pressed;
        }
        removed += figures.toObject()["removed_mm3"].toDouble();
        const std::optional<double> gouge = exactGouge(*judge, *take, 3.0, 300);
        QVERIFY(gouge);
        QVERIFY2(*gouge <= 0.01, qPrintable(QString::number(*gouge)));
    }
    QVERIFY2(pressed > 1000 && removed > 300.0, qPrintable(QString("%1 ticks, %2 mm³").arg(pressed).arg(removed)));
}

void SurroundingsTest::aLeaningPathIsNotPosted() {
    const QString project = inFolder("leaning.burin"), program = inFolder("leaning.ngc");
    const ProgramRun run = runBurin({"post", project, "-o", program});
    QCOMPARE(run.status, 2);
    QVERIFY2(run.messages.contains("--axis fixed") && run.messages.count('\n') == 1, run.messages.constData());
    QVERIFY(!QFile::exists(program));
}

BURIN_TEST(SurroundingsTest, QCoreApplication)

} // namespace burin::tst_surroundings

#include "tst_surroundings.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/verify/deviation_scale.h"
#include "core/verify/load_chart.h"
#include "core/verify/tool_moves.h"
#include "core/verify/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace burin;

namespace {

/// A box as a closed mesh with outward triangles.
TriangleMesh boxMesh(const glm::dvec3& low, const glm::dvec3& high) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                   corner & 4 ? high.z : low.z);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A part of 30 × 20 × 10 mm with its low corner at the origin.
Model boxModel() {
    Model model;
    Body body;
    body.name = "box";
    body.mesh = boxMesh(glm::dvec3(0.0), {30.0, 20.0, 10.0});
    body.volume = 6000.0;
    body.box = boundingBox(body.mesh);
    model.bodies.push_back(body);
    return model;
}

MachineProfile machine() {
    MachineProfile profile;
    profile.id = "test";
    profile.travel = {300.0, 300.0, 100.0};
    profile.maximumFeed = 2000.0;
    profile.rapidFeed = 6000.0;
    profile.maximumSpindleSpeed = 20000.0;
    return profile;
}

/// A ball of 6 mm with 8 mm of flutes, a shank as thick as the flutes and a holder 30 mm up.
Tool ballTool() {
    Tool tool;
    tool.id = "ball";
    tool.cutter = {CutterType::ball, 6.0, 3.0, 8.0, 6.0, 30.0, {{20.0, 20.0, 15.0}}};
    tool.maximumDepthOfCut = 8.0;
    return tool;
}

/// 20 mm of stock above the part, 5 mm around; 0.25 mm voxels. Program zero: centre of the stock's top, (15, 10, 30).
struct Case {
    Model model = boxModel();
    MeshDistance part{model.bodies.front().mesh};
    VerifyRequest request;

    Case() {
        Setup setup;
        setup.voxel = 0.25;
        setup.marginLow = glm::dvec3(5.0);
        setup.marginHigh = {5.0, 5.0, 20.0};
        request.setup = placeStock(model, setup).value();
        request.model = &model;
        request.part = &part;
        request.tool = ballTool();
        request.machine = machine();
    }

    VerifyReport judge(const std::string& moves, VolumeSnapshot* machined = nullptr) {
        const ParsedProgram program = parseProgram(moves + "M2\n", "test.ngc").value();
        request.program = &program;
        Progress progress;
        return burin::verify(request, progress, machined).value();
    }
};

const std::string start = "G21 G90 G17 G54\nT1 M6\nS10000 M3\n";

int countOf(const VerifyReport& report, FindingKind kind) {
    return static_cast<int>(std::count_if(report.findings.begin(), report.findings.end(),
                                          [&](const Finding& finding) { return finding.kind == kind; }));
}

} // namespace

class VerifyTest : public QObject {
    Q_OBJECT
private slots:
    void aProgramInAirPasses();
    void gougeIsTheDepthInThePart_data();
    void gougeIsTheDepthInThePart();
    void removedVolumeIsTheGroove();
    void rapidThroughStockIsFound();
    void spindleThatStandsStillIsFound();
    void shankInADeepGrooveIsFound();
    void aToolInAFixtureIsFound_data();
    void aToolInAFixtureIsFound();
    void aHolderThatPassesNearIsToldAndIsNoFault_data();
    void aHolderThatPassesNearIsToldAndIsNoFault();
    void aShankBesideAWallOfStockIsTold();
    void aWallPassedOnManyLinesIsToldByPlaces();
    void limitsAreFound();
    void theEndOfTheTravelIsFoundWhereItIsKnown();
    void feedFromNowhereIsFound();
    void excessOverAFacedTopIsWhatWasLeft();
    void finishingMovesLieOnThePart();
    void anArcIsJudgedAsAnArc();
    void independentAxesBendARapid();
    void aBentRapidIsJudgedOnItsBend();
    void eachToolMakesItsOwnMoves();
    void theLoadIsThatOfWhatIsRemoved();
    void aPlaceOfThePartHasItsNumber();
    void theScaleTellsTheSidesApart();
    void aPointOfThePartHasTheValuesOfItsFace();
};

void VerifyTest::aProgramInAirPasses() {
    Case job;
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG1 X10 F600\nG0 Z10\n");
    QVERIFY(report.passed());
    QCOMPARE(report.removed, 0.0);
    QCOMPARE(report.gougeMax, 0.0);
    // 20 mm at 600 mm/min is 2 s; the rapids before it come from nowhere but for 5 mm up at 6000 mm/min.
    QVERIFY(std::abs(report.machiningSeconds - (2.0 + 0.05)) < 1e-9);
}

void VerifyTest::gougeIsTheDepthInThePart_data() {
    QTest::addColumn<double>("tip"); // program Z of the tip; the part's top is at Z = -20
    QTest::addColumn<double>("depth");
    QTest::newRow("a third of a millimetre in") << -20.3 << 0.3;
    QTest::newRow("within the tolerance") << -20.015 << 0.015;
    QTest::newRow("just on the part") << -20.0 << 0.0;
    QTest::newRow("clear of the part") << -19.5 << 0.0;
}

void VerifyTest::gougeIsTheDepthInThePart() {
    QFETCH(double, tip);
    QFETCH(double, depth);
    Case job;
    job.request.tool.cutter.fluteLength = 28.0; // so that the depth under the stock's top is no matter
    const std::string level = std::to_string(tip);
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG1 Z" + level + " F300\nG1 X10 F600\nG1 Z5\n");
    QVERIFY2(std::abs(report.gougeMax - depth) < 1e-6, qPrintable(QString::number(report.gougeMax)));
    QCOMPARE(countOf(report, FindingKind::gouge) > 0, depth > 0.02);
    QCOMPARE(report.passed(), depth <= 0.02);
}

void VerifyTest::removedVolumeIsTheGroove() {
    Case job;
    // A groove 3 mm deep in the middle of the stock's top: half a cylinder with a quarter sphere at either end.
    VolumeSnapshot machined;
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG1 Z-3 F300\nG1 X10 F600\nG1 Z5\n", &machined);
    const double groove = 0.5 * pi * 9.0 * 20.0 + 2.0 / 3.0 * pi * 27.0;
    QVERIFY2(std::abs(report.removed - groove) < 0.005 * groove, qPrintable(QString::number(report.removed)));
    QVERIFY(report.passed());
    const Grid& grid = machined.grid();
    const double stock = 40.0 * 30.0 * 35.0 - 6000.0;
    std::uint64_t left = 0;
    const RunAmounts amounts = machined.amounts();
    for (int i = 1; i < machined.properties().size(); ++i)
        if (!machined.properties().isProtected(static_cast<PropertyIndex>(i)))
            left += amounts.units[static_cast<std::size_t>(i)];
    QVERIFY(std::abs(stock - static_cast<double>(left) * grid.unitVolume() - report.removed) < 1e-9 * stock);
}

void VerifyTest::rapidThroughStockIsFound() {
    Case job;
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG0 Z-3\nG0 X10\nG0 Z5\n");
    QVERIFY(!report.passed());
    QCOMPARE(countOf(report, FindingKind::rapidInStock), 2);
    QCOMPARE(report.findings.front().line, 6U);
}

void VerifyTest::spindleThatStandsStillIsFound() {
    Case job;
    const VerifyReport report = job.judge("G21 G90 G17\nT1 M6\nG0 Z5\nG0 X-10 Y0\nG1 Z-2 F300\nG1 X10\nG1 Z5\n");
    QCOMPARE(countOf(report, FindingKind::spindleOff), 2);
}

void VerifyTest::shankInADeepGrooveIsFound() {
    Case job;
    // 12 mm deep with 8 mm of flutes: the shank rubs along the groove's uncut walls.
    const VerifyReport deep = job.judge(start + "G0 Z5\nG0 X-30 Y0\nG1 Z-12 F300\nG1 X0 F600\nG1 Z5\n");
    QVERIFY(countOf(deep, FindingKind::shankCollision) > 0);
    Case shallow;
    const VerifyReport fine = shallow.judge(start + "G0 Z5\nG0 X-30 Y0\nG1 Z-7.5 F300\nG1 X0 F600\nG1 Z5\n");
    QCOMPARE(countOf(fine, FindingKind::shankCollision), 0);
}

void VerifyTest::aToolInAFixtureIsFound_data() {
    QTest::addColumn<double>("x"); // program X that the tip goes to beside a block whose face is at X = -25
    QTest::addColumn<bool>("on");
    QTest::addColumn<double>("depth");
    QTest::newRow("a third of a millimetre in") << -22.3 << true << 0.3;
    QTest::newRow("within the tolerance") << -22.015 << true << 0.0;
    QTest::newRow("beside it") << -21.5 << true << 0.0;
    QTest::newRow("the block is not there") << -22.3 << false << 0.0;
}

void VerifyTest::aToolInAFixtureIsFound() {
    QFETCH(double, x);
    QFETCH(bool, on);
    QFETCH(double, depth);
    Case job;
    Obstacle block;
    block.name = "block";
    block.shape = Box{{-20.0, 5.0, 0.0}, {-10.0, 15.0, 45.0}};
    block.margin = 2.0; // the hand's alone
    block.on = on;
    job.request.obstacles = {block};
    for (const char* move : {"G0", "G1 F600"}) {
        const VerifyReport report =
            job.judge(start + "G0 Z5\nG0 X-10 Y0\n" + move + " X" + std::to_string(x) + "\nG0 X-10\nG0 Z10\n");
        QCOMPARE(report.passed(), depth == 0.0);
        QCOMPARE(countOf(report, FindingKind::obstacleCollision) > 0, depth > 0.0);
        if (depth == 0.0) continue;
        QVERIFY(std::abs(report.findings.front().amount - depth) < 1e-6);
        QVERIFY(std::abs(report.findings.front().place.x + 10.0) < 1e-6);
    }
}

/// The stock is the part, 10 mm high. The tool goes down beside it until its holder, 30 mm above the tip and 10 mm wide
/// all round, is so far above the part's top; and in another run beside a fixture of the same height.
void VerifyTest::aHolderThatPassesNearIsToldAndIsNoFault_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<bool>("told");
    QTest::newRow("well above") << 1.2 << false;
    QTest::newRow("near") << 0.7 << true;
    QTest::newRow("nearly touching") << 0.05 << true;
    QTest::newRow("in it") << -0.5 << false; // that is a finding
}

void VerifyTest::aHolderThatPassesNearIsToldAndIsNoFault() {
    QFETCH(double, gap);
    QFETCH(bool, told);
    Case job;
    Setup setup;
    setup.voxel = 0.25;
    setup.marginLow = setup.marginHigh = glm::dvec3(0.0);
    job.request.setup = placeStock(job.model, setup).value(); // program zero: (15, 10, 10)
    Obstacle clamp;
    clamp.shape = Box{{-40.0, 0.0, 0.0}, {-20.0, 20.0, 10.0 - 2.0 * gap}};
    job.request.obstacles = {clamp};
    // Over x = -6: 9 mm of stock and part lie under the holder, and none of the clamp; over x = -14 it is the other
    // way.
    const std::string depth = std::to_string(gap - 30.0), deeper = std::to_string(-gap - 30.0);
    const VerifyReport report =
        job.judge(start + "G0 Z50\nG0 X-21 Y0\nG1 Z" + depth + " F300\nG0 Z50\nX-29\nG1 Z" + deeper + "\nG0 Z50\n");
    const auto passOf = [&](const std::string& id) {
        return std::find_if(report.nearPasses.begin(), report.nearPasses.end(),
                            [&](const NearPass& pass) { return pass.line == 6 && idOf(pass) == id; });
    };
    const auto part = passOf("holder_near_part"), stock = passOf("holder_near_stock");
    QCOMPARE(part != report.nearPasses.end(), told);
    QCOMPARE(stock != report.nearPasses.end(), told);
    QCOMPARE(report.passed(), gap > 0.0);
    if (!told) return;
    QVERIFY(std::abs(part->distance - gap) < 1e-6);
    QVERIFY(std::abs(part->place.z - 10.0) < 1e-6 && part->place.x >= -1e-6 && part->place.x <= 4.0 + 1e-6);
    QVERIFY(stock->distance <= gap + 1e-6 && stock->distance >= gap - 1.0 / 32.0 - 0.25 / 256.0 - 1e-6);
    QVERIFY(std::abs(stock->place.x - 2.0) < 2.0 && stock->place.z < 10.0);
    const auto clampPass = std::find_if(report.nearPasses.begin(), report.nearPasses.end(),
                                        [](const NearPass& pass) { return pass.to == NearTo::obstacle; });
    QVERIFY(clampPass != report.nearPasses.end());
    QCOMPARE(clampPass->line, 9U);
    QVERIFY(std::abs(clampPass->distance - gap) < 1e-6);
}

/// A slot deeper than the flutes, milled in two passes: the shank, half a millimetre thinner all round, passes its
/// walls.
void VerifyTest::aShankBesideAWallOfStockIsTold() {
    Case job;
    job.request.tool.cutter.shankDiameter = 5.0;
    const std::string moves = "G0 Z5\nG0 X-25 Y0\nG1 Z-6 F300\nX25 F600\nZ-12 F300\nX-25 F600\nG0 Z5\n";
    const VerifyReport report = job.judge(start + moves);
    QVERIFY(report.passed());
    const auto pass = std::find_if(report.nearPasses.begin(), report.nearPasses.end(), [](const NearPass& one) {
        return one.to == NearTo::stock && one.section == ToolSection::shank && (one.line == 8 || one.line == 9);
    });
    QVERIFY(pass != report.nearPasses.end());
    QVERIFY2(std::abs(pass->distance - 0.5) <= 0.25, qPrintable(QString::number(pass->distance))); // to a voxel
    QVERIFY(std::none_of(report.nearPasses.begin(), report.nearPasses.end(),
                         [](const NearPass& one) { return one.line < 8; })); // the first pass keeps 2 mm
    job.request.nearDistance = 0.0;
    QVERIFY(job.judge(start + moves).nearPasses.empty());
}

/// A wall along 50 mm that the shank passes on a hundred lines: one warning every 10 to 20 mm, the nearest first, and
/// together they count every line.
void VerifyTest::aWallPassedOnManyLinesIsToldByPlaces() {
    Case job;
    job.request.tool.cutter.shankDiameter = 5.0;
    std::string moves = "G0 Z5\nG0 X-25 Y0\nG1 Z-6 F300\nX25 F600\nZ-12 F300\n";
    for (int i = 1; i <= 100; ++i) moves += "X" + std::to_string(25.0 - 0.5 * i) + " F600\n";
    const VerifyReport report = job.judge(start + moves + "G0 Z5\n");
    QVERIFY(report.passed());
    std::vector<NearPass> shank;
    for (const NearPass& pass : report.nearPasses)
        if (pass.to == NearTo::stock && pass.section == ToolSection::shank) shank.push_back(pass);
    QVERIFY2(shank.size() >= 2 && shank.size() <= 6, qPrintable(QString::number(shank.size())));
    unsigned lines = 0;
    for (const NearPass& pass : shank) lines += pass.lines;
    QVERIFY2(lines >= 80, qPrintable(QString::number(lines)));
    for (std::size_t i = 1; i < shank.size(); ++i) QVERIFY(shank[i - 1].distance <= shank[i].distance);
    for (const NearPass& one : shank)
        for (const NearPass& other : shank)
            QVERIFY(&one == &other || glm::distance(one.place, other.place) > nearPlace);
}

void VerifyTest::limitsAreFound() {
    Case job;
    const VerifyReport report = job.judge("G21 G90 G17\nT1 M6\nS30000 M3\nG0 Z5\nG0 X-200 Y0\nG1 X10 F5000\nG0 X150\n");
    QCOMPARE(countOf(report, FindingKind::feedLimit), 1);
    QCOMPARE(countOf(report, FindingKind::spindleLimit), 1);
    QCOMPARE(countOf(report, FindingKind::travelLimit), 1);
}

/// 300 mm are enough for the way, but the table does not stand in the middle.
void VerifyTest::theEndOfTheTravelIsFoundWhereItIsKnown() {
    Case job;
    const std::string moves = start + "G0 Z5\nG0 X-40 Y0\nG1 X10 F600\n";
    QVERIFY(job.judge(moves).passed());
    const glm::dvec3 zero = job.request.setup.workOffset;
    job.request.travel = {zero - glm::dvec3(30.0, 150.0, 50.0), zero + glm::dvec3(270.0, 150.0, 50.0)};
    const VerifyReport report = job.judge(moves);
    QCOMPARE(countOf(report, FindingKind::travelLimit), 1);
    QVERIFY(std::abs(report.findings.front().amount - 310.0) < 1e-9); // 10 mm beyond the low end
}

void VerifyTest::feedFromNowhereIsFound() {
    Case job;
    QCOMPARE(countOf(job.judge(start + "G1 X0 Y0 Z5 F100\n"), FindingKind::unknownStart), 1);
}

void VerifyTest::excessOverAFacedTopIsWhatWasLeft() {
    Case job;
    job.request.tool.cutter = {CutterType::flat, 10.0, 0.0, 28.0, 9.0, 40.0, {}};
    std::string rows = start + "G0 Z5\nG0 X-30 Y-20\nG1 Z-19.25 F1000\n"; // leaves 0.75 mm on the part
    for (int row = 0; row <= 8; ++row)
        rows += "G1 Y" + std::to_string(-20 + 5 * row) + "\nG1 X" + (row % 2 == 0 ? "30" : "-30") + "\n";
    const VerifyReport report = job.judge(rows + "G1 Z5\n");
    QVERIFY(report.passed());
    double overTop = 0.0;
    int places = 0;
    for (const DeviationSample& sample : report.deviations)
        if (sample.place.z == 10.0) {
            QVERIFY(sample.reachable);
            overTop = std::max(overTop, sample.excess);
            ++places;
        }
    QVERIFY(places > 1000);
    QVERIFY2(std::abs(overTop - 0.75) <= 0.25 / 8.0 + 1e-9, qPrintable(QString::number(overTop)));
}

void VerifyTest::finishingMovesLieOnThePart() {
    Case job;
    job.request.tool.cutter.fluteLength = 28.0;
    // Two passes over the part at the cutting feed, one on it and one 1 mm above it, equally long.
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y-3\nG1 Z-19 F300\nG1 X10 F600\nG1 Y3 F300\n"
                                                  "G1 Z-20 F300\nG1 X-10 F600\nG1 Z5 F300\n");
    QVERIFY(std::abs(report.onPartShare - 0.5) < 0.01);
    QCOMPARE(report.onPartSamples, std::size_t(400));
}

/// A ring with the profile of a half disc (Pappus).
void VerifyTest::anArcIsJudgedAsAnArc() {
    Case job;
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-8 Y0\nG1 Z-3 F300\nG2 I8 J0 F600\nG1 Z5\n");
    QVERIFY(report.passed());
    const double ring = 0.5 * pi * 9.0 * 2.0 * pi * 8.0;
    QVERIFY2(std::abs(report.removed - ring) < 0.005 * ring, qPrintable(QString::number(report.removed)));
    QCOMPARE(report.loads.size(), std::size_t(2)); // the plunge and the arc, however many chords it has
    QCOMPARE(report.loads.back().line, 7U);
}

/// To (60, 50, 10): Z is there first, then X, then Y, which is slow.
void VerifyTest::independentAxesBendARapid() {
    MachineProfile bent = machine();
    bent.rapids = RapidMode::independent;
    bent.axisRates = {6000.0, 3000.0, 6000.0};
    const std::vector<glm::dvec3> way = rapidWay(glm::dvec3(0.0), {60.0, 50.0, 10.0}, bent);
    QCOMPARE(way.size(), std::size_t(3));
    QVERIFY(glm::length(way[0] - glm::dvec3(10.0, 5.0, 10.0)) < 1e-9);
    QVERIFY(glm::length(way[1] - glm::dvec3(60.0, 30.0, 10.0)) < 1e-9);
    QCOMPARE(way[2], glm::dvec3(60.0, 50.0, 10.0));
    QCOMPARE(rapidWay(glm::dvec3(0.0), {30.0, 15.0, 30.0}, bent).size(), std::size_t(1)); // all at once
    bent.rapids = RapidMode::synchronised;
    QCOMPARE(rapidWay(glm::dvec3(0.0), {60.0, 50.0, 10.0}, bent).size(), std::size_t(1));
}

/// Straight up and away it clears the stock; with a slow Z it is dragged through its side.
void VerifyTest::aBentRapidIsJudgedOnItsBend() {
    const std::string moves = start + "G0 Z5\nG0 X40 Y0\nG0 Z-10\nG0 X0 Z20\n";
    Case straight;
    straight.request.machine.axisRates = {6000.0, 6000.0, 2000.0};
    QVERIFY(straight.judge(moves).passed());
    Case bent;
    bent.request.machine = straight.request.machine;
    bent.request.machine.rapids = RapidMode::independent;
    const VerifyReport report = bent.judge(moves);
    QVERIFY(report.rapids == RapidMode::independent);
    QCOMPARE(countOf(report, FindingKind::rapidInStock), 1);
    QCOMPARE(report.findings.front().line, 7U);
}

void VerifyTest::eachToolMakesItsOwnMoves() {
    const std::string moves = start + "G0 Z5\nG0 X-10 Y-8\nG1 Z-2 F300\nG1 X10 F600\nG0 Z5\nT2 M6\nS8000 M3\n"
                                      "G0 X-10 Y8 Z5\nG1 Z-2 F300\nG1 X10 F600\nG0 Z5\n";
    Case job;
    const ParsedProgram program = parseProgram(moves + "M2\n", "test.ngc").value();
    job.request.program = &program;
    Progress progress;
    const Result<VerifyReport> oneForAll = burin::verify(job.request, progress);
    QVERIFY(!oneForAll && oneForAll.error().code == ErrorCode::notSupported);

    Tool flat = ballTool();
    flat.number = 2;
    flat.cutter = {CutterType::flat, 4.0, 0.0, 8.0, 4.0, 30.0, {}};
    job.request.tools = {job.request.tool};
    const Result<VerifyReport> unknown = burin::verify(job.request, progress);
    QVERIFY(!unknown && unknown.error().code == ErrorCode::nameUnknown);
    QCOMPARE(unknown.error().place, std::string("T2"));

    job.request.tools = {flat, job.request.tool};
    const VerifyReport report = job.judge(moves);
    QVERIFY(report.passed());
    const double ballHeight = 2.0, segment = 9.0 * std::acos(1.0 - ballHeight / 3.0) -
                                             (3.0 - ballHeight) * std::sqrt(6.0 * ballHeight - ballHeight * ballHeight);
    const double cap = pi * ballHeight * ballHeight * (3.0 - ballHeight / 3.0);
    const double expected = segment * 20.0 + cap + 4.0 * 2.0 * 20.0 + pi * 4.0 * 2.0;
    QVERIFY2(std::abs(report.removed - expected) < 0.01 * expected, qPrintable(QString::number(report.removed)));
}

void VerifyTest::theLoadIsThatOfWhatIsRemoved() {
    Case job;
    job.request.machine.acceleration = 400.0;
    job.request.tool.fluteCount = 2;
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG1 Z-3 F300\nG1 X10 F600\nG1 Z5\n");
    QCOMPARE(report.loads.size(), std::size_t(2));
    const MotionLoad& groove = report.loads[1];
    QCOMPARE(groove.line, 7U);
    QVERIFY(std::abs(report.loads[0].volume + groove.volume - report.removed) < 1e-9 * report.removed);
    QVERIFY(std::abs(groove.volume - 0.5 * pi * 9.0 * 20.0) < 0.02 * groove.volume);
    QVERIFY(groove.duration > 2.0 && groove.duration < 2.1); // 20 mm at 10 mm/s, and its ramps
    QCOMPARE(groove.removalRate, groove.volume / groove.duration);
    QVERIFY(groove.power > 0.0);
    const double edgeSpeed = pi * 6.0 * 10000.0 / 60.0; // mm/s
    QVERIFY(std::abs(groove.force * edgeSpeed / 1000.0 - groove.power) < 1e-9 * groove.power);
    QCOMPARE(peakLoad(report.loads)->line, 7U);
    QVERIFY(std::abs(peakLoad(report.loads)->place.y - 10.0) < 0.1); // in the groove
    QVERIFY(peakLoad({}) == nullptr);
    QCOMPARE(report.times.size(), std::size_t(5));
}

void VerifyTest::aPlaceOfThePartHasItsNumber() {
    const glm::dvec3 middle(15.0, 10.0, 10.0); // of the part's top
    const DeviationTolerance tolerance{0.02, 0.1, 0.0};
    Case job;
    job.request.tool.cutter = {CutterType::flat, 10.0, 0.0, 28.0, 9.0, 40.0, {}};
    const auto pass = [&](const char* level) {
        return job.judge(start + "G0 Z5\nG0 X-30 Y0\nG1 Z" + level + " F1000\nG1 X30\nG1 Z5\n");
    };
    struct Row {
        const char* level;
        double deviation;
        DeviationBand band;
    };
    for (const Row& row : {Row{"-19.5", 0.5, DeviationBand::excess}, Row{"-20", 0.0, DeviationBand::inTolerance},
                           Row{"-20.3", -0.3, DeviationBand::gouge}}) {
        const VerifyReport report = pass(row.level);
        const DeviationMap map(report.deviations, job.request.setup.voxel);
        // Gouges are marked where the tool was found deepest: somewhere on the pass.
        std::size_t at = map.nearest(middle, 1.0).value();
        if (row.deviation < 0.0)
            for (std::size_t i = 0; i < report.deviations.size(); ++i)
                if (report.deviations[i].gouge > report.deviations[at].gouge) at = i;
        const DeviationSample& sample = report.deviations[at];
        QVERIFY2(std::abs(deviationOf(sample) - row.deviation) < 1e-3,
                 qPrintable(QString::number(deviationOf(sample))));
        QVERIFY(bandOf(sample, tolerance) == row.band);
        QCOMPARE(map.nearest(sample.place, 0.01).value(), at);
        QVERIFY(!map.nearest({15.0, 10.0, 30.0}, 1.0));
        const DeviationMap::Shares shares = map.shares(tolerance);
        QVERIFY(std::abs(shares.gouge + shares.inTolerance + shares.excess + shares.unreachable - 1.0) < 1e-9);
        QCOMPARE(shares.gouge > 0.0, row.deviation < 0.0);
    }
}

namespace {

/// CIE 1976 lightness of an sRGB colour, 0 … 100 (IEC 61966-2-1).
double lightness(const DeviationColour& colour) {
    std::array<double, 3> linear{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = colour[i] / 255.0;
        linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    const double y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    return 116.0 * std::cbrt(y) - 16.0;
}

} // namespace

/// The farther from nominal the darker, without a step, and blue against red, which no common colour blindness mixes
/// up.
void VerifyTest::theScaleTellsTheSidesApart() {
    for (const DeviationTolerance& tolerance :
         {DeviationTolerance{0.02, 0.1, 0.0}, DeviationTolerance{0.05, 0.1, 0.3}}) {
        const DeviationScale scale(tolerance);
        double before = lightness(scale.colourOf(tolerance.allowance));
        QVERIFY(before > 95.0);
        for (double left = tolerance.allowance; left < tolerance.allowance + 2.5; left += 0.005) {
            const double now = lightness(scale.colourOf(left));
            QVERIFY(now <= before + 0.2 && now > before - 4.0);
            before = now;
            if (left < tolerance.allowance + 0.1) continue;
            QVERIFY(scale.colourOf(left)[2] > scale.colourOf(left)[0] + 20);
        }
        before = lightness(scale.colourOf(0.0));
        for (double deep = 0.0; deep < 1.5; deep += 0.001) {
            const double now = lightness(scale.colourOf(-deep));
            QVERIFY(now <= before + 0.2 && now > before - 4.0);
            before = now;
            if (deep < tolerance.gouge) continue;
            QVERIFY(scale.colourOf(-deep)[0] > scale.colourOf(-deep)[2] + 20);
        }
        // The limits of the tolerance are marked.
        std::vector<double> limits;
        for (const DeviationScale::Mark& mark : scale.marks())
            if (mark.ofTolerance) limits.push_back(mark.deviation);
        QCOMPARE(limits.size(), std::size_t{2});
        QCOMPARE(limits.front(), -tolerance.gouge);
        QCOMPARE(limits.back(), tolerance.allowance + tolerance.excess);
    }
    DeviationSample overhang{{}, 3.0, 0.0, false};
    QVERIFY(colourOf(overhang, DeviationScale({}), {}) == unmeasuredColour);
}

/// A floor whose stock rises evenly, at a wall with 5 mm of stock: up to the edge the floor keeps its own value.
void VerifyTest::aPointOfThePartHasTheValuesOfItsFace() {
    constexpr double apart = 0.4;
    std::vector<DeviationSample> samples;
    for (double y = -8.0; y <= 8.0; y += apart) {
        for (double x = 0.1; x <= 10.0; x += apart) samples.push_back({{x, y, 0.0}, 0.1 + 0.05 * x, 0.0, true});
        for (double z = 0.1; z <= 10.0; z += apart) samples.push_back({{0.0, y, z}, 5.0, 0.0, true});
    }
    const DeviationMap map(samples, apart);
    const glm::dvec3 up(0.0, 0.0, 1.0), out(1.0, 0.0, 0.0);
    for (double x = 0.5; x < 9.5; x += 0.13) {
        const auto found = map.at({x, 0.17, 0.0}, up);
        QVERIFY(found && found->reachable && std::abs(found->excess - (0.1 + 0.05 * x)) < 0.01);
    }
    const auto onTheEdge = map.at({0.0, 0.0, 0.0}, up), onTheWall = map.at({0.0, 0.0, 3.0}, out);
    QVERIFY(onTheEdge && onTheEdge->excess < 2.5);
    QVERIFY(onTheWall && std::abs(onTheWall->excess - 5.0) < 1e-9);
    QVERIFY(!map.at({20.0, 0.0, 0.0}, up)); // nothing was measured there
}

QTEST_APPLESS_MAIN(VerifyTest)
#include "tst_verify.moc"

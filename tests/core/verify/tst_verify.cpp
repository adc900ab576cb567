// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "core/tool/hollow_tip.h"
#include "core/verify/deviation_scale.h"
#include "core/verify/load_chart.h"
#include "core/verify/load_limits.h"
#include "core/verify/report_json.h"
#include "core/verify/tool_moves.h"
#include "core/verify/verify.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

namespace burin::tst_verify {

namespace {

/// A box as a closed, outward-oriented mesh.
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
    tool.maximumDepthOfCut = 28.0; // some tests give it flutes of that length
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

/// Number of the line that contains the given words.
std::uint32_t lineOf(const std::string& program, const std::string& words) {
    const auto end = program.begin() + static_cast<std::ptrdiff_t>(program.find(words));
    return 1U + static_cast<std::uint32_t>(std::count(program.begin(), end, '\n'));
}

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
    void rapidThatGrazesLessThanAVoxelIsFound_data();
    void rapidThatGrazesLessThanAVoxelIsFound();
    void aRapidInWhatWasCutTouchesNothing();
    void blendedCornersGougeByTheFormula_data();
    void blendedCornersGougeByTheFormula();
    void mergedLinesGougeByTheFormula_data();
    void mergedLinesGougeByTheFormula();
    void theAllowanceIsComparedWithThePath_data();
    void theAllowanceIsComparedWithThePath();
    void stockEndsWithinAVoxel();
    void spindleThatStandsStillIsFound();
    void shankInADeepGrooveIsFound();
    void whatTheShankTouchesIsToldAsVoxels();
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
    void thePeakOfASlotDoesNotDependOnItsApproach();
    void partialCutsHaveTheForceOfTheClosedFormula_data();
    void partialCutsHaveTheForceOfTheClosedFormula();
    void aPlungeAndABallPushAlongTheAxis();
    void eachLimitIsFoundAtItsLine_data();
    void eachLimitIsFoundAtItsLine();
    void theFeedThatIsBorneIsThatOfTheClosedFormula();
    void estimatedLimitsWarn();
    void manyLinesMakeOneFinding();
    void noCutIsWiderThanTheTool();
    void aPlungeNeedsMaterialToBeOne_data();
    void aPlungeNeedsMaterialToBeOne();
    void aHollowToolPlungesWithAPinOnly();
    void theDeepestCutBendsTheToolByWhatItMay_data();
    void theDeepestCutBendsTheToolByWhatItMay();
    void aReportKeepsItsLoadFindings();
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
    // 20 mm at 600 mm/min is 2 s; the rapids before it have no known start except for 5 mm up at 6000 mm/min.
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
    job.request.tool.cutter.fluteLength = 28.0; // so that the depth below the stock's top is irrelevant
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
    QCOMPARE(countOf(report, FindingKind::rapidInStock), 1); // the move down and the one across are a single mistake
    QCOMPARE(report.findings.front().line, 6U);
    QCOMPARE(report.findings.front().count, 2U);
}

void VerifyTest::rapidThatGrazesLessThanAVoxelIsFound_data() {
    QTest::addColumn<double>("by");
    QTest::newRow("passes") << -0.02;
    QTest::newRow("less than rounding") << 0.005;
    QTest::newRow("a tenth of a voxel") << 0.025;
    QTest::newRow("less than to the first scanline") << 0.12;
    QTest::newRow("more") << 0.3;
}

/// Along the side of the block, which is at y = -5 mm, with 0.25 mm voxels.
void VerifyTest::rapidThatGrazesLessThanAVoxelIsFound() {
    QFETCH(const double, by);
    Case job;
    const std::string y = std::to_string(-15.0 - 3.0 + by);
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-40 Y" + y + "\nG0 Z-10\nG0 X40\nG0 Z5\n");
    QCOMPARE(countOf(report, FindingKind::rapidInStock), by > 0.01 ? 1 : 0);
    if (by > 0.01) QCOMPARE(report.findings.front().line, 7U);
}

/// Up and along in a groove that bends: rapids next to walls that were cut there touch nothing.
void VerifyTest::aRapidInWhatWasCutTouchesNothing() {
    Case job;
    const VerifyReport report =
        job.judge(start + "G0 Z5\nG0 X-40.3 Y0.123\nG0 Z-3.21\nG1 X-5.077 F600\nG3 X-1.077 Y4.123 I0 J4\nG1 Y40\n"
                          "G0 Y4.123\nG0 Z5\nG0 X-20.017 Y0.123\nG0 Z-3.21\nG0 X-40\nG0 Z5\n");
    QVERIFY2(report.passed(), report.findings.empty() ? "" : idOf(report.findings.front().kind));
}

void VerifyTest::blendedCornersGougeByTheFormula_data() {
    QTest::addColumn<QString>("mode");
    QTest::addColumn<double>("leaves");
    QTest::newRow("P 0.8") << "G64 P0.8" << 0.8;
    QTest::newRow("P 1.3") << "G64 P1.3" << 1.3;
    QTest::newRow("P 1.6") << "G64 P1.6" << 1.6;
    // Blocks of 16 mm: the parabola begins 8 mm before the corner, and deviates from it by half of 8 mm times the sine
    // of 45°.
    QTest::newRow("no tolerance") << "G64" << 0.5 * 8.0 * std::sqrt(0.5);
    QTest::newRow("exact") << "G61" << 0.0;
}

namespace {

/// The least distance from (0, 0) of the parabola that deviates from the corner at (-3, -3), between lines along the
/// axes, by `leaves`.
double nearestOfParabola(double leaves) {
    const double leg = 2.0 * leaves * std::sqrt(2.0);
    double nearest = 1e9;
    for (int i = 0; i <= 10000; ++i) {
        const double t = i / 10000.0;
        nearest = std::min(nearest, std::hypot(leg * t * t - 3.0, leg * (1.0 - t) * (1.0 - t) - 3.0));
    }
    return nearest;
}

} // namespace

/// A ball of 3 mm radius around the part's upright edge at (0, 0), 3 mm from both sides of it.
void VerifyTest::blendedCornersGougeByTheFormula() {
    QFETCH(const QString, mode);
    QFETCH(const double, leaves);
    Case job;
    const std::string text =
        start + mode.toStdString() + "\nG0 Z5\nG0 X-18 Y3\nG0 Z-28\nG1 Y-13 F600\nG1 X-2\nG61\nG1 Y-40\nG0 Z5\n";
    const VerifyReport report = job.judge(text);
    const double gouge = 3.0 - nearestOfParabola(leaves);
    QCOMPARE(countOf(report, FindingKind::cornerGouge), gouge > 0.02 ? 1 : 0);
    if (gouge <= 0.02) return;
    const auto found = std::ranges::find(report.findings, FindingKind::cornerGouge, &Finding::kind);
    QCOMPARE(found->line, lineOf(text, mode.toStdString()));
    QVERIFY2(std::abs(found->amount - gouge) < 0.01, qPrintable(QString::number(found->amount)));
}

void VerifyTest::mergedLinesGougeByTheFormula_data() {
    QTest::addColumn<QString>("mode");
    QTest::addColumn<double>("gouge");
    constexpr double radius = 3.3, degree = pi / 180.0;
    QTest::newRow("all are one") << "G64 P0.01 Q0.5" << 3.0 - radius * std::cos(30.0 * degree);
    QTest::newRow("P for both") << "G64 P0.5" << 3.0 - radius * std::cos(30.0 * degree);
    QTest::newRow("11 are one") << "G64 P0.01 Q0.25" << 3.0 - radius * std::cos(22.0 * degree);
    QTest::newRow("none") << "G64 P0.01 Q0" << 0.0;
}

/// 15 chords of 4° around the part's upright edge, 0.3 mm away from it.
void VerifyTest::mergedLinesGougeByTheFormula() {
    QFETCH(const QString, mode);
    QFETCH(const double, gouge);
    Case job;
    std::string text = start + "G61\nG0 Z5\n";
    for (int i = 0; i <= 15; ++i) {
        const double angle = (195.0 + 4.0 * i) * pi / 180.0;
        const std::string place =
            "X" + std::to_string(3.3 * std::cos(angle) - 15.0) + " Y" + std::to_string(3.3 * std::sin(angle) - 10.0);
        text += (i == 0 ? "G0 " : "G1 F600 ") + place + "\n";
        if (i == 0) text += "G0 Z-28\n" + mode.toStdString() + "\n";
    }
    const VerifyReport report = job.judge(text + "G61\nG1 Y-40\nG0 Z5\n");
    QCOMPARE(countOf(report, FindingKind::cornerGouge), gouge > 0.02 ? 1 : 0);
    if (gouge <= 0.02) return;
    const auto found = std::ranges::find(report.findings, FindingKind::cornerGouge, &Finding::kind);
    QCOMPARE(found->line, lineOf(text, mode.toStdString()));
    QVERIFY2(std::abs(found->amount - gouge) < 0.005, qPrintable(QString::number(found->amount)));
}

void VerifyTest::theAllowanceIsComparedWithThePath_data() {
    QTest::addColumn<double>("path");
    QTest::addColumn<double>("program");
    QTest::addColumn<bool>("found");
    QTest::newRow("as it is") << 0.0 << 0.0 << false;
    QTest::newRow("as it is, with allowance") << 0.5 << 0.5 << false;
    QTest::newRow("within the tolerance") << 0.5 << 0.58 << false;
    QTest::newRow("too much") << 0.0 << 0.3 << true;
    QTest::newRow("too much allowance") << 0.5 << 0.8 << true;
    QTest::newRow("allowance that is gone") << 0.5 << 0.2 << true;
}

/// Passes over the part's top, which is 20 mm below program zero.
void VerifyTest::theAllowanceIsComparedWithThePath() {
    QFETCH(const double, path);
    QFETCH(const double, program);
    QFETCH(const bool, found);
    Case job;
    job.request.tool.cutter.fluteLength = 28.0;
    Path promised;
    promised.toolId = job.request.tool.id;
    std::string text = start + "G0 Z5\nG0 X-40 Y-5\nG0 Z" + std::to_string(-20.0 + program) + "\nF600\n";
    promised.points.push_back({{{-25.0, 5.0, 10.0 + path}}, MoveKind::rapid});
    for (const double y : {5.0, 10.0, 15.0}) {
        const std::string lane = std::to_string(y - 10.0);
        promised.points.push_back({{{-25.0, y, 10.0 + path}}});
        promised.points.push_back({{{55.0, y, 10.0 + path}}});
        promised.points.push_back({{{-25.0, y, 10.0 + path}}});
        text += "G1 Y" + lane + "\nX40\nX-40\n";
    }
    const std::vector<Path> paths{promised};
    job.request.promised = &paths;
    const VerifyReport report = job.judge(text + "G0 Z5\n");
    QCOMPARE(countOf(report, FindingKind::allowanceDiffers), found ? 1 : 0);
    if (!found) return;
    const auto finding = std::ranges::find(report.findings, FindingKind::allowanceDiffers, &Finding::kind);
    QCOMPARE(finding->line, lineOf(text, "G1 Y"));
    QVERIFY(std::abs(finding->amount - program) < 0.002 && std::abs(finding->limit - path) < 0.002);
    job.request.excessTolerance = 0.0;
    QCOMPARE(countOf(job.judge(text + "G0 Z5\n"), FindingKind::allowanceDiffers), 0);
}

/// A flat cutter removes a strip from the side where the block ends within a voxel.
void VerifyTest::stockEndsWithinAVoxel() {
    for (const double margin : {5.0, 5.06, 5.1, 5.14, 5.2}) {
        Case job;
        Setup setup = job.request.setup;
        setup.marginLow = glm::dvec3(margin);
        setup.marginHigh = {margin, margin, 20.0};
        setup = placeStock(job.model, setup).value();
        job.request.setup = setup;
        job.request.tool.cutter = {CutterType::flat, 6.0, 0.0, 8.0, 6.0, 30.0, {{20.0, 20.0, 15.0}}};
        const double edge = setup.stock.low.x + 0.25 * std::floor((30.0 + margin) / 0.25); // of a voxel
        const std::string x = std::to_string(edge + 3.0 - setup.workOffset.x);
        const VerifyReport report = job.judge(start + "G0 Z5\nG0 X" + x + " Y-40\nG0 Z-3\nG1 Y40 F600\nG0 Z5\n");
        const double expected = (setup.stock.high.x - edge) * setup.stock.size().y * 3.0;
        QVERIFY2(std::abs(report.removed - expected) < 2e-3 * expected,
                 qPrintable(QStringLiteral("%1: %2 of %3").arg(margin).arg(report.removed).arg(expected)));
    }
}

void VerifyTest::spindleThatStandsStillIsFound() {
    Case job;
    const VerifyReport report = job.judge("G21 G90 G17\nT1 M6\nG0 Z5\nG0 X-10 Y0\nG1 Z-2 F300\nG1 X10\nG1 Z5\n");
    QCOMPARE(countOf(report, FindingKind::spindleOff), 1); // of a spindle that was never started
    QCOMPARE(report.findings.front().line, 5U);
    QCOMPARE(report.findings.front().count, 2U);
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

/// Eq. 4 of the paper for a plunge, voxel by voxel from closed formulas: a hole of 6 mm, and a shank of 10 mm that
/// begins 8 mm up, 2 mm deep in the stock.
void VerifyTest::whatTheShankTouchesIsToldAsVoxels() {
    Case job;
    job.request.tool.cutter = {CutterType::flat, 6.0, 0.0, 8.0, 10.0, 30.0, {{20.0, 20.0, 15.0}}};
    const std::string program = start + "G0 Z5\nG0 X0 Y0\nG1 Z-10 F300\nG1 Z5\n";
    const VerifyReport report = job.judge(program);
    QCOMPARE(report.touched.size(), std::size_t{2}); // down, and up again
    const TouchedVoxels& touched = report.touched.front();
    QCOMPARE(touched.line, lineOf(program, "G1 Z-10"));
    QCOMPARE(touched.pose.tip, glm::dvec3(15.0, 10.0, 20.0));
    QCOMPARE(touched.edge, 0.25);
    const Box& stock = job.request.setup.stock;
    const auto far = [](const glm::dvec3& at) { return std::hypot(at.x - 15.0, at.y - 10.0); };
    const auto inPart = [](const glm::dvec3& at) {
        return at.x > 0.0 && at.x < 30.0 && at.y > 0.0 && at.y < 20.0 && at.z > 0.0 && at.z < 10.0;
    };
    const auto inStock = [&](const glm::dvec3& at) {
        const bool inside = glm::all(glm::greaterThan(at, stock.low)) && glm::all(glm::lessThan(at, stock.high));
        return inside && (inPart(at) || far(at) > 3.0 || at.z < 20.0);
    };
    const auto inShank = [&](const glm::dvec3& at) { return far(at) <= 5.0 && at.z >= 28.0 && at.z <= 50.0; };
    const auto onSurface = [](const auto& holds, const glm::dvec3& at) {
        if (!holds(at)) return false;
        for (int i = 0; i < 27; ++i)
            if (!holds(at + 0.25 * glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1))) return true;
        return false;
    };
    std::size_t expected = 0;
    for (double x = 9.125; x < 21.0; x += 0.25)
        for (double y = 4.125; y < 16.0; y += 0.25)
            for (double z = 20.125; z < 30.0; z += 0.25)
                if (const glm::dvec3 at(x, y, z); onSurface(inStock, at) && onSurface(inShank, at)) {
                    ++expected;
                    QVERIFY(std::ranges::any_of(
                        touched.centres, [&](const glm::dvec3& centre) { return glm::length(centre - at) < 1e-9; }));
                }
    QCOMPARE(touched.centres.size(), expected);
    QVERIFY(expected > 100);
    const std::optional<VerifyReport> again = reportFromJson(toJson(report)); // as stored in a project
    QVERIFY(again && again->touched.size() == 2 && again->touched.front().centres == touched.centres);
    QVERIFY(job.judge(start + "G0 Z5\nG0 X0 Y0\nG1 Z-7 F300\nG1 Z5\n").touched.empty());
}

void VerifyTest::aToolInAFixtureIsFound_data() {
    QTest::addColumn<double>("x"); // program X of the tip next to a block whose face is at X = -25
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
    block.margin = 2.0; // only for the haptic boundary
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

/// The stock is the part, 10 mm high. The tool goes down next to it until its holder, which begins 30 mm above the tip
/// and has a radius of 10 mm, is the given distance above the part's top; and in another run next to a fixture of the
/// same height.
void VerifyTest::aHolderThatPassesNearIsToldAndIsNoFault_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<bool>("told");
    QTest::newRow("well above") << 1.2 << false;
    QTest::newRow("near") << 0.7 << true;
    QTest::newRow("nearly touching") << 0.05 << true;
    QTest::newRow("in it") << -0.5 << false; // contact, which is a finding
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
    // Over x = -6, 9 mm of stock and part are below the holder, and none of the clamp; over x = -14 it is the other way
    // round.
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

/// A slot deeper than the flutes, milled in two passes: the shank, half a millimetre smaller in radius, passes its
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

/// The shank passes a wall of 50 mm on a hundred lines: one warning every 10 to 20 mm, the nearest first, and together
/// they count every line.
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

/// 300 mm are enough for the distance, but the table is not centred.
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
    // Two passes over the part at the cutting feed, one on it and one 1 mm above it, of equal length.
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

/// To (60, 50, 10): Z arrives first, then X, then Y, which is slow.
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

/// Straight up and away the tool clears the stock; with a slow Z it is dragged through the side of the stock.
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
    const VerifyReport unknown = job.judge(moves);
    QCOMPARE(countOf(unknown, FindingKind::toolUnknown), 1);
    QCOMPARE(unknown.findings.front().line, lineOf(moves, "T2 M6"));
    QCOMPARE(unknown.findings.front().amount, 2.0);

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
    const VerifyReport report = job.judge(start + "G0 Z5\nG0 X-10 Y0\nG1 Z-3 F100\nG1 X10 F600\nG1 Z5\n");
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
    QVERIFY(std::abs(peakLoad(report.loads)->peak.place.y - 10.0) < 0.1); // in the groove
    QVERIFY(peakLoad({}) == nullptr);
    QCOMPARE(report.times.size(), std::size_t(5));
}

namespace {

constexpr double kc11 = 800.0, mc = 0.25, kr = 0.4, kte = 7.5, kre = 8.0; // N/mm², 1, 1, N/mm, N/mm

Property alloy() {
    Property property;
    property.id = "alloy";
    property.name = "alloy";
    for (const auto& [name, value, unit] : {std::tuple{specificCuttingEnergy, 0.9, "J/mm^3"},
                                            {radialForceRatio, kr, "1"},
                                            {kienzleForce, kc11, "N/mm^2"},
                                            {kienzleExponent, mc, "1"},
                                            {tangentialEdgeForce, kte, "N/mm"},
                                            {radialEdgeForce, kre, "N/mm"}})
        property.values[std::string(name)] = {value, unit, "test", false};
    return property;
}

/// A block of 150 × 40 × 20 mm with a margin only on top, cut in alloy by an end mill of 10 mm with 3 teeth. Program
/// zero: centre of its top, so that it extends from X-75 to X75, Y-20 to Y20.
struct Slotting {
    Model model;
    std::unique_ptr<MeshDistance> part;
    VerifyRequest request;

    Slotting() {
        Body body;
        body.name = "plate";
        body.mesh = boxMesh(glm::dvec3(0.0), {150.0, 40.0, 4.0});
        body.volume = 24000.0;
        body.box = boundingBox(body.mesh);
        model.bodies.push_back(body);
        part = std::make_unique<MeshDistance>(model.bodies.front().mesh);
        Setup setup;
        setup.voxel = 0.25;
        setup.marginLow = glm::dvec3(0.0);
        setup.marginHigh = {0.0, 0.0, 16.0};
        request.setup = placeStock(model, setup).value();
        request.setup.stockMaterial = "alloy";
        request.materials = {alloy()};
        request.model = &model;
        request.part = part.get();
        request.machine = machine();
        request.machine.acceleration = 2000.0;
        request.tool.id = "end mill";
        request.tool.source = "maker";
        request.tool.fluteCount = 3;
        request.tool.cutter = {CutterType::flat, 10.0, 0.0, 25.0, 10.0, 50.0, {}};
        request.tool.maximumDepthOfCut = 25.0;
    }
    VerifyReport judge(const std::string& moves) {
        const ParsedProgram program =
            parseProgram("G21 G90 G17 G54\nT1 M6\nS3800 M3\n" + moves + "M2\n", "test.ngc").value();
        request.program = &program;
        Progress progress;
        return burin::verify(request, progress).value();
    }
};

} // namespace

/// The slot of issue 29: 6 mm deep, F350, S3800, with approaches in air of 5, 20, 55 and 105 mm, in one block and in
/// many. K of the mean chip of a slot, 2 fz / pi, is 2.14 J/mm³; 350 mm³/s of it at 1.99 m/s are 376 N; the edge force
/// is added: 3 teeth, half a turn, 6 mm, 7.5 N/mm.
void VerifyTest::thePeakOfASlotDoesNotDependOnItsApproach() {
    const double expected = 376.4 + 3.0 * 0.5 * 6.0 * kte;
    for (const double approach : {5.0, 20.0, 55.0, 105.0})
        for (const bool inMany : {false, true}) {
            Slotting job;
            const double from = -75.0 - 5.0 - approach, to = from + approach + 40.0;
            std::string moves = "G0 X" + std::to_string(from) + " Y0 Z5\nG0 Z-6\n";
            const int blocks = inMany ? 60 : 1;
            for (int i = 1; i <= blocks; ++i)
                moves += "G1 X" + std::to_string(from + (to - from) * i / blocks) + " F350\n";
            const VerifyReport report = job.judge(moves + "G0 Z5\n");
            QVERIFY(peakLoad(report.loads) != nullptr);
            const CutLoad& peak = peakLoad(report.loads)->peak;
            QVERIFY2(std::abs(peak.force / expected - 1.0) < 0.02,
                     qPrintable(QStringLiteral("%1: %2 N").arg(approach).arg(peak.force)));
            // Over time: no load during the approach.
            const double entered = (approach - 0.5) / (350.0 / 60.0);
            QVERIFY(peak.at > entered && peak.place.x > 0.0);
            for (const LoadStep& step : report.loadSteps) QVERIFY(step.start > entered * 0.9);
        }
}

void VerifyTest::partialCutsHaveTheForceOfTheClosedFormula_data() {
    QTest::addColumn<double>("width");
    QTest::newRow("a quarter") << 2.5;
    QTest::newRow("half") << 5.0;
    QTest::newRow("three quarters") << 7.5;
    QTest::newRow("full") << 10.0;
}

/// Independent computation: arc acos(1 - 2 ae / D); a tooth's force integrated over it in small angles, for the mean
/// over a turn Kt(h) sin-weighted with K of the mean chip; sideways components by the same sum.
void VerifyTest::partialCutsHaveTheForceOfTheClosedFormula() {
    QFETCH(double, width);
    constexpr double diameter = 10.0, depth = 6.0, feed = 600.0, turns = 3800.0 / 60.0, teeth = 3.0;
    Slotting job;
    // The material is on the left of the move along +X, starting at Y-20.
    const std::string y = std::to_string(width >= 10.0 ? 0.0 : -20.0 - 5.0 + width);
    const VerifyReport report = job.judge("G0 X-85 Y" + y + " Z5\nG0 Z-6\nG1 X0 F600\nG0 Z5\n");
    const CutLoad& peak = peakLoad(report.loads)->peak;

    const double perTooth = feed / 60.0 / (turns * teeth), arc = std::acos(1.0 - 2.0 * width / diameter);
    const double chip = perTooth * width / (0.5 * diameter * arc); // mean over the arc
    const double energy = kc11 * std::pow(chip, -mc);
    // The +Y side of the cutter is in the stock; the teeth of a clockwise spindle move from +Y towards +X.
    double tangential = 0.0, radial = 0.0;
    glm::dvec2 force(0.0);
    constexpr int parts = 20000;
    for (int i = 0; i < parts; ++i) {
        const double turn = arc * (i + 0.5) / parts; // from the side of the material
        const double share = depth * arc / parts * teeth / (2.0 * pi);
        // Position of the tooth: +Y rotated towards +X.
        const glm::dvec2 out(std::sin(turn), std::cos(turn)), along(out.y, -out.x);
        const double thick = perTooth * out.x;
        const double t = (energy * thick + kte) * share, r = (kr * energy * thick + kre) * share;
        tangential += t;
        radial += r;
        force -= t * along + r * out;
    }
    const auto isNear = [](double a, double b) { return std::abs(a / b - 1.0) < 0.05; };
    QVERIFY2(isNear(peak.force, tangential), qPrintable(QStringLiteral("%1 %2").arg(peak.force).arg(tangential)));
    QVERIFY2(isNear(peak.radial, radial), qPrintable(QStringLiteral("%1 %2").arg(peak.radial).arg(radial)));
    QVERIFY(isNear(peak.chip, chip));
    QVERIFY(isNear(peak.power, tangential * pi * diameter * turns / 1000.0));
    QVERIFY(isNear(peak.torque, tangential * 0.5 * diameter / 1000.0));
    QVERIFY(std::abs(peak.depth - depth) < 0.01 && std::abs(peak.width - width) < 0.3);
    const glm::dvec2 told(peak.vector);
    QVERIFY2(glm::length(told - force) < 0.05 * glm::length(force),
             qPrintable(QStringLiteral("%1 %2, %3 %4").arg(told.x).arg(told.y).arg(force.x).arg(force.y)));
    QVERIFY(std::abs(peak.axial) < 0.02 * peak.force); // only walls
}

void VerifyTest::aPlungeAndABallPushAlongTheAxis() {
    Slotting job;
    const VerifyReport plunge = job.judge("G0 X0 Y0 Z5\nG1 Z-5 F100\nG0 Z5\n");
    const CutLoad& flat = peakLoad(plunge.loads)->peak;
    QVERIFY(flat.axial > 0.3 * flat.force && flat.side < 0.05 * flat.axial);
    // The whole disc of the bottom is engaged: R²pi of it, each mm² passed by all three teeth.
    QVERIFY(std::abs(flat.removalRate / (25.0 * pi * 100.0 / 60.0) - 1.0) < 0.02);
    job.request.tool.cutter = {CutterType::ball, 10.0, 5.0, 25.0, 10.0, 50.0, {}};
    const VerifyReport groove = job.judge("G0 X-85 Y0 Z5\nG0 Z-2\nG1 X0 F600\nG0 Z5\n");
    const CutLoad& ball = peakLoad(groove.loads)->peak;
    QVERIFY(ball.axial > 0.2 * ball.force); // its round bottom is pushed up
    QVERIFY(ball.vector.x < 0.0);           // and pushed back against the motion
}

void VerifyTest::eachLimitIsFoundAtItsLine_data() {
    QTest::addColumn<int>("kind");
    const auto row = [](const char* name, FindingKind kind) { QTest::newRow(name) << static_cast<int>(kind); };
    row("power", FindingKind::spindlePower);
    row("torque", FindingKind::spindleTorque);
    row("breakage", FindingKind::toolBreakage);
    row("chip", FindingKind::chipLoad);
    row("depth", FindingKind::depthOfCut);
    row("width", FindingKind::widthOfCut);
    row("bending", FindingKind::toolBending);
}

/// A light cut on line 6 and a heavy one on line 9, with limits between them.
void VerifyTest::eachLimitIsFoundAtItsLine() {
    QFETCH(int, kind);
    const auto wanted = static_cast<FindingKind>(kind);
    const std::string moves = "G0 X-85 Y-20 Z5\nG0 Z-2\nG1 X85 F200\nG0 Z5\nG0 X-85 Y5\nG0 Z-8\nG1 X-10 F1200\n"
                              "G0 Z5\n";
    Slotting job;
    job.request.gougeTolerance = 0.02;
    const VerifyReport free = job.judge(moves);
    QVERIFY(free.passed() && free.warnings.empty()); // without stated limits nothing is judged
    QCOMPARE(free.loads.size(), std::size_t(2));
    const CutLoad &light = free.loads[0].peak, &heavy = free.loads[1].peak;
    const auto between = [](double a, double b) { return std::sqrt(a * b); };
    Tool& tool = job.request.tool;
    MachineProfile& machine = job.request.machine;
    switch (wanted) {
    case FindingKind::spindlePower:
        machine.spindlePower = between(light.power, heavy.power);
        break;
    case FindingKind::spindleTorque:
        machine.spindleTorque = {{3800.0, between(light.torque, heavy.torque)}};
        break;
    case FindingKind::toolBreakage: // cantilever of 50 mm, flutes' core 8 mm over 25 mm, force 4 mm above the tip
        tool.strength = 3.0 * 0.9 * heavy.side * 21.0 / (pi / 32.0 * 512.0);
        break;
    case FindingKind::chipLoad:
        tool.maximumChipLoad = between(light.feedPerTooth, heavy.feedPerTooth);
        break;
    case FindingKind::depthOfCut:
        tool.maximumDepthOfCut = 5.0;
        break;
    case FindingKind::widthOfCut:
        tool.maximumWidthOfCut = 7.0; // line 6 cuts with half of the tool
        break;
    default:
        tool.modulus = heavy.side * std::pow(46.0, 3) / (3.0 * pi / 64.0 * 4096.0) / 0.08;
    }
    const VerifyReport report = job.judge(moves);
    const std::vector<Finding>& found = wanted == FindingKind::toolBending ? report.warnings : report.findings;
    QCOMPARE(report.passed(), wanted == FindingKind::toolBending);
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(found.front().kind == wanted);
    QCOMPARE(found.front().line, 10U);
    QVERIFY(found.front().amount > found.front().limit && found.front().limit > 0.0);
    QVERIFY(std::string(idOf(wanted)) != "unknown" && std::string(unitOf(wanted)) != "");
    if (wanted == FindingKind::toolBending) {
        // A cantilever of 8 mm from the force at 4 mm up to 25 mm, then of 10 mm up to 50 mm; one of 8 mm over the
        // whole length would bend by 0.08 mm.
        const double inner = std::pow(21.0, 3), whole = std::pow(46.0, 3);
        const double expected = 0.08 * (inner + (whole - inner) * std::pow(0.8, 4)) / whole;
        QVERIFY2(std::abs(found.front().amount / expected - 1.0) < 0.03,
                 qPrintable(QString::number(found.front().amount)));
    }
}

/// For a slot: P = (K(2 fz / pi) D ap v / edge speed + Kte z ap / 2) times the edge's speed; at 400 mm/min here.
void VerifyTest::theFeedThatIsBorneIsThatOfTheClosedFormula() {
    constexpr double depth = 8.0, turns = 3800.0 / 60.0, borne = 400.0 / 60.0, edgeSpeed = pi * 10.0 * turns;
    const double edge = 3.0 * 0.5 * depth * kte; // N
    const double chip = 2.0 / pi * borne / (turns * 3.0);
    const double force = kc11 * std::pow(chip, -mc) * 10.0 * depth * borne / edgeSpeed + edge;
    const std::string moves = "G0 X-85 Y-20 Z5\nG0 Z-2\nG1 X85 F200\nG0 Z5\nG0 X-85 Y5\nG0 Z-8\nG1 X-10 F1200\n"
                              "G0 Z5\n";
    Slotting job;
    QVERIFY(job.judge(moves).feedLimits.empty());
    job.request.machine.spindlePower = force * edgeSpeed / 1000.0;
    const VerifyReport report = job.judge(moves);
    QCOMPARE(report.feedLimits.size(), std::size_t(1));
    QCOMPARE(report.feedLimits.front().motion, report.loads.back().motion);
    QVERIFY2(std::abs(report.feedLimits.front().feed / 400.0 - 1.0) < 0.03,
             qPrintable(QString::number(report.feedLimits.front().feed)));
    job.request.machine.spindlePower = 0.9 * edge * edgeSpeed / 1000.0; // less than the edge force alone requires
    QVERIFY(job.judge(moves).feedLimits.back().feed < 1.0);
}

void VerifyTest::estimatedLimitsWarn() {
    const std::string moves = "G0 X-85 Y0 Z5\nG0 Z-8\nG1 X-10 F1200\nG0 Z5\n";
    Slotting job;
    job.request.tool.maximumChipLoad = 0.01;
    job.request.tool.sources["maximum_chip_load_mm"] = "estimate";
    job.request.machine.spindlePower = 10.0;
    job.request.machine.sources["spindle_power_w"] = "estimate of the shop";
    const VerifyReport report = job.judge(moves);
    QVERIFY(report.passed());
    QCOMPARE(report.warnings.size(), std::size_t(2));
    QVERIFY(report.warnings[0].amount / report.warnings[0].limit >=
            report.warnings[1].amount / report.warnings[1].limit); // the worst first
}

/// A slot in 300 blocks of 0.5 mm: one finding every 10 mm, with the lines that it represents.
void VerifyTest::manyLinesMakeOneFinding() {
    Slotting job;
    job.request.machine.spindlePower = 10.0;
    std::string moves = "G0 X-85 Y0 Z5\nG0 Z-6\n";
    for (int i = 1; i <= 300; ++i) moves += "G1 X" + std::to_string(-85.0 + 0.5 * i) + " F350\n";
    const VerifyReport report = job.judge(moves + "G0 Z5\n");
    std::uint32_t lines = 0;
    for (const Finding& finding : report.findings) lines += finding.count;
    QVERIFY(report.findings.size() <= 20 && !report.findings.empty());
    QVERIFY(lines > 270 && lines <= 300);
}

/// Steps of 0.04 mm with a sharp bend at each: less than a voxel, so that whole columns of voxels are removed at once.
/// However a tool moves, its cut is no wider than the tool.
void VerifyTest::noCutIsWiderThanTheTool() {
    Slotting job;
    std::string moves = "G0 X-85 Y0 Z5\nG0 Z-6\nG1 X-60 F350\n";
    for (int i = 1; i <= 200; ++i)
        moves += "G1 X" + std::to_string(-60.0 + 0.03 * i) + " Y" + (i % 2 == 0 ? "0" : "0.03") + "\n";
    const VerifyReport report = job.judge(moves + "G0 Z5\n");
    QVERIFY(report.loads.size() > 20);
    double most = 0.0; // mm², projected along the move
    for (const MotionLoad& load : report.loads) {
        QVERIFY(load.peak.width <= 10.0);
        most = std::max(most, load.peak.removalRate / (load.peak.feedPerTooth * 3.0 * 3800.0 / 60.0));
    }
    QVERIFY2(most > 57.0 && most < 60.0 * 1.02, qPrintable(QString::number(most)));
}

void VerifyTest::aPlungeNeedsMaterialToBeOne_data() {
    QTest::addColumn<QString>("moves");
    QTest::addColumn<bool>("centreCutting");
    QTest::addColumn<int>("line"); // 0: no message
    const QString above = "G0 X0 Y0 Z5\n", feed = " F200\n";
    QTest::newRow("in air") << above + "G1 Z0.5" + feed << false << 0;
    QTest::newRow("beside the stock") << "G0 X-85 Y0 Z5\nG1 Z-8" + feed + "G1 X-70\n" << false << 0;
    QTest::newRow("into what is cut") << "G0 X-85 Y0 Z5\nG0 Z-6\nG1 X0" + feed + "G0 Z5\nG1 Z-6\n" << false << 0;
    QTest::newRow("ramp") << above + "G1 Z0" + feed + "G1 X-20 Z-2\n" << false << 0;
    QTest::newRow("into the stock") << above + "G1 Z-2" + feed << false << 5;
    QTest::newRow("in small steps") << above + "G1 Z0" + feed + "Z-0.1\nZ-0.2\nZ-0.3\n" << false << 7;
    QTest::newRow("with a centre") << above + "G1 Z-2" + feed << true << 0;
}

void VerifyTest::aPlungeNeedsMaterialToBeOne() {
    QFETCH(QString, moves);
    QFETCH(bool, centreCutting);
    QFETCH(int, line);
    Slotting job;
    job.request.tool.centreCutting = centreCutting;
    const VerifyReport report = job.judge(moves.toStdString() + "G0 Z5\n");
    QCOMPARE(report.passed(), line == 0);
    if (line == 0) return;
    const Finding& found = report.findings.front();
    QVERIFY(found.kind == FindingKind::centrePlunge && found.amount > 0.15 && found.amount < 2.1);
    QCOMPARE(found.line, static_cast<std::uint32_t>(line));
}

/// 10 × 8 mm, hollow over 20 mm. A core stays; a pin of 2 mm in the middle meets it at once.
void VerifyTest::aHollowToolPlungesWithAPinOnly() {
    for (const bool pin : {false, true}) {
        Slotting job;
        job.request.tool.centreCutting = false;
        Cutter& cutter = job.request.tool.cutter;
        cutter.type = CutterType::profile;
        cutter.profile = {{5.0, 0.0}, {5.0, 25.0}};
        PlanRing ring{{4.0, 0.0}, {5.0, 0.0}, {5.0, 25.0}, {0.0, 25.0}, {0.0, 20.0}, {4.0, 20.0}};
        if (pin)
            ring = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 20.0}, {4.0, 20.0}, {4.0, 0.0}, {5.0, 0.0}, {5.0, 25.0}, {0.0, 25.0}};
        cutter.solid = std::make_shared<const ToolSolid>(turningSolid({{ring}}, cutter.profile));
        const VerifyReport report = job.judge("G0 X0 Y0 Z5\nG1 Z-2 F200\nG0 Z5\n");
        QCOMPARE(std::ranges::count(report.findings, FindingKind::centrePlunge, &Finding::kind), pin ? 1 : 0);
    }
}

void VerifyTest::theDeepestCutBendsTheToolByWhatItMay_data() {
    QTest::addColumn<double>("width");
    QTest::newRow("slot") << 10.0;
    QTest::newRow("half") << 5.0;
    QTest::newRow("a tenth") << 1.0;
}

/// A cantilever of constant thickness with the closed formula of a straight cut.
void VerifyTest::theDeepestCutBendsTheToolByWhatItMay() {
    QFETCH(double, width);
    Tool tool;
    tool.fluteCount = 3;
    tool.modulus = 600000.0;
    tool.cutter = {CutterType::flat, 10.0, 0.0, 50.0, 10.0, 50.0, {}};
    CuttingConditions conditions;
    conditions.spindleSpeed = 6000.0;
    conditions.feed = 1800.0;
    CuttingCoefficients::Entry material;
    material.specificEnergy = 1.2;
    material.radialRatio = 0.5;
    material.edgeForce = 10.0;
    material.radialEdgeForce = 6.0;
    const double bending = 0.05;
    const double depth = bearableDepth(tool, conditions, material, MachineProfile{}, {width, bending});
    const double edgeSpeed = pi * 10.0 * 100.0;                                // mm/s
    const double chip = 1200.0 * width * depth * 30.0 / edgeSpeed;             // N: K MRR / v
    const double edge = 3.0 * depth * std::acos(1.0 - width / 5.0) / (2 * pi); // mm, in the mean over a turn
    const double force = std::hypot(chip + 10.0 * edge, 0.5 * chip + 6.0 * edge);
    const double inertia = pi / 64.0 * std::pow(8.0, 4);
    const double expected = force * std::pow(50.0 - 0.5 * depth, 3) / (3.0 * 600000.0 * inertia);
    QVERIFY2(std::abs(expected / bending - 1.0) < 0.01, qPrintable(QString("%1 mm: %2").arg(depth).arg(expected)));
    MachineProfile weak;
    weak.spindlePower = 0.5 * (chip + 10.0 * edge) * edgeSpeed / 1000.0; // for half of the depth
    QVERIFY(std::abs(bearableDepth(tool, conditions, material, weak, {width, bending}) / depth - 0.5) < 0.01);
}

void VerifyTest::aReportKeepsItsLoadFindings() {
    VerifyReport report;
    report.findings = {{FindingKind::spindlePower, 7, {1.0, 2.0, 3.0}, 918.0, 900.0, 12}};
    report.warnings = {{FindingKind::toolBending, 9, glm::dvec3(0.0), 0.05, 0.02, 1}};
    report.untimedMoves = 3;
    const std::optional<VerifyReport> read = reportFromJson(toJson(report));
    QVERIFY(read.has_value());
    QCOMPARE(read->untimedMoves, 3);
    QVERIFY(read->findings.front().kind == FindingKind::spindlePower);
    QCOMPARE(read->findings.front().limit, 900.0);
    QCOMPARE(read->findings.front().count, 12U);
    QVERIFY(read->warnings.front().kind == FindingKind::toolBending);
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
        // Gouges are marked where the tool was deepest: somewhere on the pass.
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

/// The farther from nominal the darker, without a jump, and blue against red, which are distinguishable with all common
/// kinds of colour blindness.
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

/// A floor whose stock rises evenly, next to a wall with 5 mm of stock: up to the edge the floor keeps its own value.
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

BURIN_TEST(VerifyTest, NoApplication)

} // namespace burin::tst_verify

#include "tst_verify.moc"

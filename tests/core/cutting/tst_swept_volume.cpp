// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/removal.h"
#include "core/tool/span_rows.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/tool/cutters.h"
#include "tests/oracles/line_scatter.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace burin::tst_swept_volume {

using namespace burin::tests;

namespace {

using Moves = std::vector<std::pair<ToolPose, ToolPose>>;

/// The body that a cutter removes by some moves, with closed formulas.
struct Body {
    const char* name = "";
    Cutter cutter;
    Moves moves;                        ///< about the origin
    double volume = 0.0, surface = 0.0; ///< mm³, mm²
    int trials = 0;                     ///< flat faces and straight edges: small errors at most orientations
};

constexpr double radius = 2.0, ring = 3.0, tube = 1.5, length = 3.0; // mm
constexpr glm::dvec3 up(0.0, 0.0, 1.0);

/// One half of a ball, with its flutes ending at the equator, along moves of its centre; then its other half.
Moves bothHalves(double ballRadius, const std::vector<glm::dvec3>& centres) {
    Moves moves;
    for (const glm::dvec3& axis : {up, -up}) {
        const glm::dvec3 tip = -ballRadius * axis;
        moves.push_back({{centres.front() + tip, axis}, {centres.front() + tip, axis}});
        for (std::size_t i = 1; i < centres.size(); ++i)
            moves.push_back({{centres[i - 1] + tip, axis}, {centres[i] + tip, axis}});
    }
    return moves;
}

Body sphere() {
    return {"sphere",
            ball(2.0 * radius, radius),
            bothHalves(radius, {glm::dvec3(0.0)}),
            4.0 / 3.0 * pi * std::pow(radius, 3),
            4.0 * pi * radius * radius,
            240};
}

Body capsule() {
    const glm::dvec3 way = length * glm::normalize(glm::dvec3(1.0, 0.2, 0.3));
    return {"capsule",
            ball(2.0 * radius, radius),
            bothHalves(radius, {-0.5 * way, 0.5 * way}),
            4.0 / 3.0 * pi * std::pow(radius, 3) + pi * radius * radius * length,
            4.0 * pi * radius * radius + 2.0 * pi * radius * length,
            240};
}

/// A ball that moves around on the chords of a circle. At each bend the outer part of two cylinders up to the plane
/// between them, 4/3 tube³ tan(turn / 2), is replaced by a wedge of the ball, 2/3 tube³ turn.
Body torus() {
    constexpr int chords = 48;
    constexpr double turn = 2.0 * pi / chords;
    std::vector<glm::dvec3> centres;
    for (int i = 0; i <= chords; ++i) centres.push_back(ring * glm::dvec3(std::cos(i * turn), std::sin(i * turn), 0.0));
    const double way = chords * 2.0 * ring * std::sin(0.5 * turn);
    return {"torus",
            ball(2.0 * tube, tube),
            bothHalves(tube, centres),
            pi * tube * tube * way + chords * 2.0 / 3.0 * std::pow(tube, 3) * (turn - 2.0 * std::tan(0.5 * turn)),
            2.0 * pi * tube * way,
            45};
}

Body standing(const char* name, const Cutter& cutter, double volume, double surface, int trials) {
    const ToolPose pose{-0.5 * cutter.fluteLength * up, up};
    return {name, cutter, {{pose, pose}}, volume, surface, trials};
}

Body cone() {
    Cutter cutter = cutters::make(CutterType::drill, 2.0 * radius, 0.0, length);
    cutter.taperAngle = std::atan2(radius, length);
    return standing("cone", cutter, pi * radius * radius * length / 3.0,
                    pi * radius * (radius + std::hypot(radius, length)), 900);
}

Body cylinder() {
    return standing("cylinder", flat(2.0 * radius, length), pi * radius * radius * length,
                    2.0 * pi * radius * (radius + length), 900);
}

/// The outer half of a torus around a cylinder: pi times the integral of (tube + sqrt(tube² - z²))².
Body barrel() {
    Cutter cutter = cutters::make(CutterType::profile, 4.0 * tube, 0.0, 2.0 * tube);
    cutter.profile = {{tube, 0.0}, {2.0 * tube, tube, tube}, {tube, 2.0 * tube, tube}};
    return standing("barrel", cutter, std::pow(tube, 3) * pi * (2.0 + pi + 4.0 / 3.0),
                    tube * tube * pi * (2.0 + 2.0 * (pi + 2.0)), 120);
}

std::vector<Body> bodies() {
    return {sphere(), capsule(), torus(), cone(), cylinder(), barrel()};
}

/// Excess of the removed volume over the body's volume, at positions and orientations unrelated to the grid.
/// @param finest mm, edge of a voxel; others are up to a fifth larger, as the radii in voxels count as well
oracles::Scatter scatterOf(const Body& body, double finest, Writing writing) {
    std::mt19937 random(static_cast<unsigned>(1.0 / finest));
    oracles::Scatter scatter;
    for (const RunAxis runs : {RunAxis::x, RunAxis::y, RunAxis::z}) {
        const double edge = finest * (1.0 + 0.1 * static_cast<double>(runs));
        const int side = static_cast<int>(std::ceil(11.0 / edge));
        const Grid grid = Grid::make(glm::dvec3(-5.5), edge, glm::ivec3(side), runs).value();
        RunVolume workpiece = RunVolume::make(grid, materials(), 8'000'000).value();
        (void)workpiece.fillBlock({0, 0}, {side, side}, 0, grid.lineEnd(), softStock);
        const VolumeSnapshot full = workpiece.snapshot();
        const std::uint64_t before = workpiece.amounts().units[softStock];
        MaterialRemoval removal(body.cutter, grid, writing);
        for (int trial = 0; trial < body.trials / 3; ++trial) {
            const glm::dmat3 turn = oracles::anyTurn(random);
            const glm::dvec3 place = oracles::anyPlace(random, edge);
            const auto placed = [&](const ToolPose& pose) {
                return ToolPose{place + turn * pose.tip, turn * pose.axis};
            };
            workpiece.restore(full);
            removal.reset();
            for (const auto& [from, to] : body.moves) (void)removal.cut(workpiece, placed(from), placed(to));
            (void)removal.settle(workpiece);
            const std::uint64_t removed = before - workpiece.amounts().units[softStock];
            scatter.add(static_cast<double>(removed) * grid.unitVolume() - body.volume,
                        oracles::lineSamplingError(body.surface, edge));
        }
    }
    return scatter;
}

} // namespace

/// The volume removed by moves is compared with closed formulas, at random positions and orientations. An exact sweep
/// has no error except that of its lines: zero mean, and a deviation of second order and known magnitude
/// (line_scatter.h). Deferred cuts leave some of the sweep of a tilted piece, no deeper than stated: the mean is of
/// first order, the deviation is the same.
class SweptVolumeTest : public QObject {
    Q_OBJECT

private slots:
    void volumesConverge_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<bool>("deferred");
        for (int i = 0; i < static_cast<int>(bodies().size()); ++i)
            for (const bool deferred : {false, true})
                QTest::addRow("%s, %s", bodies()[static_cast<std::size_t>(i)].name, deferred ? "deferred" : "every cut")
                    << i << deferred;
    }
    void volumesConverge() {
        QFETCH(const int, index);
        QFETCH(const bool, deferred);
        const Body body = bodies()[static_cast<std::size_t>(index)];
        const bool moves =
            std::ranges::any_of(body.moves, [](const auto& move) { return move.first.tip != move.second.tip; });
        std::array<oracles::Scatter, 3> scatters;
        for (std::size_t i = 0; i < scatters.size(); ++i) {
            const double edge = std::ldexp(0.4, -static_cast<int>(i));
            scatters[i] = scatterOf(body, edge, deferred ? Writing::deferred : Writing::everyCut);
            const double mean = scatters[i].mean(), deviation = scatters[i].deviation();
            const double layer = deferred && moves ? SpanRows::leaningWayError * edge * body.surface : 0.0;
            const double left = layer / oracles::lineSamplingError(body.surface, edge);
            const double chance = 3.5 * scatters[i].standardError();
            qInfo("edge %g mm, of the error that lines make: mean %.3f +- %.3f, deviation %.2f", edge, mean,
                  scatters[i].standardError(), deviation);
            QVERIFY(mean < chance && mean > -chance - left);
            QVERIFY(deviation > 0.75 && deviation < 1.3);
        }
        const double order = oracles::orderOf(scatters[0].deviation(), scatters[2].deviation());
        qInfo("order %.2f", order);
        QVERIFY(order > 1.75 && order < 2.25);
    }
};

BURIN_TEST(SweptVolumeTest, NoApplication)

} // namespace burin::tst_swept_volume

#include "tst_swept_volume.moc"

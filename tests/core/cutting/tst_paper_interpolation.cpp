// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#define GLM_ENABLE_EXPERIMENTAL // glm::rotation
#include "core/cutting/removal.h"
#include "core/cutting/voxel_tool.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/tool/cutters.h"
#include "tests/oracles/swept_cutter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <glm/gtx/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

namespace burin::tst_paper_interpolation {

using namespace burin::tests;
using oracles::SweptCutter;
using Verdict = SweptCutter::Verdict;

namespace {

constexpr double side = 24.0; ///< mm, of the workpiece about the origin; no move leaves it

/// Two consecutive moves, the axis rotating on the second, in any direction and with any axes.
std::array<Pose, 3> someMoves(unsigned seed) {
    std::mt19937 random(seed);
    const auto direction = [&] {
        std::normal_distribution<double> any;
        const double x = any(random), y = any(random), z = any(random);
        return glm::normalize(glm::dvec3(x, y, z));
    };
    const glm::dvec3 axis = direction();
    std::array<Pose, 3> poses;
    poses[0] = {-5.0 * axis, glm::rotation(glm::dvec3(0.0, 0.0, 1.0), axis)};
    poses[1] = {poses[0].position + 2.5 * direction(), poses[0].rotation};
    // About a line perpendicular to the axis: a tool that does not spin rotates its axis the shortest way, as the sweep
    // does.
    const glm::dquat turn = glm::angleAxis(0.2, glm::normalize(glm::cross(axis, direction())));
    poses[2] = {poses[1].position + 2.5 * direction(), turn * poses[1].rotation};
    return poses;
}

/// The remains of a block after the same moves: cut by analytic sweeps, and by the paper's interpolation of a voxel
/// tool.
struct Cuts {
    RunVolume analytic, papers;

    Cuts(const Cutter& cutter, const std::array<Pose, 3>& poses, const Grid& grid)
        : analytic(smallBlock(grid)), papers(smallBlock(grid)) {
        const std::vector<RevolvedPiece> flutes = flutePieces(cutter);
        const VoxelTool tool = VoxelTool::ofPieces(flutes, flutes.size(), grid.edge()).value();
        MaterialRemoval removal(cutter, grid);
        for (std::size_t i = 1; i < poses.size(); ++i) {
            (void)removal.cut(analytic, toolPose(poses[i - 1]), toolPose(poses[i]));
            (void)tool.cut(papers, poses[i - 1], poses[i]);
        }
    }
    /// mm³, volume that the paper's method removes in addition.
    double difference() const {
        return (static_cast<double>(analytic.amounts().units[softStock]) -
                static_cast<double>(papers.amounts().units[softStock])) *
               analytic.grid().unitVolume();
    }

private:
    static RunVolume smallBlock(const Grid& grid) {
        RunVolume volume = RunVolume::make(grid, materials(), 4'000'000).value();
        (void)volume.fillBlock({0, 0}, {grid.lineCountU(), grid.lineCountV()}, 0, grid.lineEnd(), softStock);
        return volume;
    }
};

/// Examines all voxels on which the two methods differ. @return their number; empty: one lies beyond the bounds
std::optional<int> differingVoxels(const Cuts& cuts, const Cutter& cutter, const std::array<Pose, 3>& poses) {
    const Grid& grid = cuts.analytic.grid();
    const double halfDiagonal = 0.5 * std::sqrt(3.0) * grid.edge(), halfStep = 0.5 * grid.edge(),
                 spacing = 0.05 * grid.edge();
    std::vector<SweptCutter> outer, inner;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        const ToolPose from = toolPose(poses[i - 1]), to = toolPose(poses[i]);
        outer.emplace_back(flutePieces(cutter), from, to, halfDiagonal, spacing);
        inner.emplace_back(flutePieces(cutter), from, to, halfDiagonal + halfStep, spacing);
    }
    int differing = 0;
    for (VoxelIndex voxel; voxel.k < grid.count().z; ++voxel.k)
        for (voxel.j = 0; voxel.j < grid.count().y; ++voxel.j)
            for (voxel.i = 0; voxel.i < grid.count().x; ++voxel.i) {
                const bool papersTook = !cuts.papers.belongs(voxel);
                if (papersTook == !cuts.analytic.belongs(voxel)) continue;
                ++differing;
                const glm::dvec3 centre = grid.low() + grid.edge() * (glm::dvec3(voxel.i, voxel.j, voxel.k) + 0.5);
                const auto isBeyond = [&](const SweptCutter& sweep) { return sweep.at(centre) == Verdict::outside; };
                const auto isDeep = [&](const SweptCutter& sweep) { return sweep.at(centre) == Verdict::inside; };
                if (papersTook ? std::ranges::all_of(outer, isBeyond) : std::ranges::any_of(inner, isDeep)) return {};
            }
    return differing;
}

/// Root mean squares over trials, mm³, at three resolutions, each voxel half as large as the previous one.
struct Errors {
    std::array<double, 3> net{};    ///< of the difference of volumes
    std::array<double, 3> either{}; ///< of the volume that one method removed and the other did not

    /// Order of convergence, over both halvings.
    static double order(const std::array<double, 3>& errors) { return 0.5 * std::log2(errors[0] / errors[2]); }
};

/// Empty: a voxel lies beyond the bounds.
std::optional<Errors> errorsOf(const Cutter& cutter) {
    constexpr int trials = 6;
    Errors squares;
    for (std::size_t fineness = 0; fineness < 3; ++fineness)
        for (int trial = 0; trial < trials; ++trial) {
            const double finest = 0.25 * (1.0 + (trial + 0.5) / (2.0 * trials)); // mm
            const double edge = std::ldexp(finest, 2 - static_cast<int>(fineness));
            const Grid grid = Grid::make(glm::dvec3(-0.5 * side), edge, glm::ivec3(static_cast<int>(side / edge)),
                                         static_cast<RunAxis>(trial % 3))
                                  .value();
            const std::array<Pose, 3> poses = someMoves(static_cast<unsigned>(trial));
            const Cuts cuts(cutter, poses, grid);
            const std::optional<int> differing = differingVoxels(cuts, cutter, poses);
            if (!differing) return {};
            squares.net[fineness] += std::pow(cuts.difference(), 2) / trials;
            squares.either[fineness] += std::pow(*differing * edge * edge * edge, 2) / trials;
        }
    for (std::array<double, 3>* errors : {&squares.net, &squares.either})
        for (double& error : *errors) error = std::sqrt(error);
    return squares;
}

} // namespace

/// Compares the analytic sweep with the paper's interpolation (eqs. 3, 6–10): the same moves cut with both methods.
///
/// A voxel of the workpiece is removed at a pose if its centre, in the tool's frame, lies in a voxel whose own centre
/// lies in the tool: at most half a voxel's diagonal away. So
/// - a voxel removed by the paper's method has its centre at most that far outside the swept tool;
/// - between two poses no point moves a whole voxel (eq. 8), so at the nearer of them no point is farther than half a
/// voxel from its position at any moment: a voxel left by the paper's method has its centre no deeper in the swept tool
/// than half the diagonal plus half a voxel.
/// So the voxels that only one method removes form a layer, a fraction of a voxel thick, on the swept surface: first
/// order in the voxel, for every cutter. So does the difference of the volumes, in which both signs partly cancel: of
/// several poses that pass a point on a wall, the pose whose tool voxels protrude most removes the voxel, and how the
/// tool's dimensions relate to its voxels is random, from -1/2 to 1/2 voxel at each end. That averages out over edges
/// from one to one and a half times the finest one and over the cutters.
class PaperInterpolationTest : public QObject {
    Q_OBJECT

private slots:
    void bothWaysRemoveTheSameToFirstOrder() {
        std::array<double, 3> squares{};
        for (const cutters::Named& named : cutters::all()) {
            const std::optional<Errors> errors = errorsOf(named.cutter);
            QVERIFY2(errors, named.name);
            const auto& [net, either] = *errors;
            const double order = Errors::order(either);
            qInfo("%s: taken by one alone %.3g, %.3g, %.3g mm³, order %.2f; difference %.3g, %.3g, %.3g mm³",
                  named.name, either[0], either[1], either[2], order, net[0], net[1], net[2]);
            QVERIFY2(order > 0.85 && order < 1.15, named.name);
            for (std::size_t i = 0; i < squares.size(); ++i) squares[i] += net[i] * net[i];
        }
        const double order = 0.5 * Errors::order(squares);
        qInfo("difference over all cutters: order %.2f", order);
        QVERIFY(order > 0.8 && order < 1.25);
    }
};

BURIN_TEST(PaperInterpolationTest, NoApplication)

} // namespace burin::tst_paper_interpolation

#include "tst_paper_interpolation.moc"

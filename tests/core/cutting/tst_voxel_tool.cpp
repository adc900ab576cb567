// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/voxel_tool.h"
#include "tests/core/cutting/common_surface.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_voxel_tool {

using namespace burin::tests;
using random::real;

namespace {

constexpr double edge = 0.5; // mm, of the voxels of tools and workpieces alike
constexpr int side = 16;     // voxels of a workpiece, along each axis

/// A tool of any shape as a plain list of cubes.
struct ToolCubes {
    struct Cube {
        glm::dvec3 centre; ///< mm, tool frame
        PropertyIndex property;
    };
    glm::dvec3 low{0.0};
    glm::ivec3 count{1};
    std::vector<Cube> cubes;

    /// A few blocks of flutes and of shank at random positions, some of them separate.
    static ToolCubes any() {
        ToolCubes tool;
        tool.low = {real(-3.0, -0.5), real(-3.0, -0.5), real(-2.0, 1.0)};
        for (int axis = 0; axis < 3; ++axis) tool.count[axis] = *rc::gen::inRange(4, 9);
        std::vector<PropertyIndex> dense(static_cast<std::size_t>(tool.count.x * tool.count.y * tool.count.z));
        for (int block = *rc::gen::inRange(3, 7); block > 0; --block) {
            const PropertyIndex property = block % 2 == 0 ? VoxelTool::shank : VoxelTool::flutes;
            glm::ivec3 first, last;
            for (int axis = 0; axis < 3; ++axis) {
                first[axis] = *rc::gen::inRange(0, tool.count[axis]);
                last[axis] = *rc::gen::inRange(first[axis], tool.count[axis]);
            }
            for (int i = first.x; i <= last.x; ++i)
                for (int j = first.y; j <= last.y; ++j)
                    for (int k = first.z; k <= last.z; ++k) dense[tool.place({i, j, k})] = property;
        }
        for (int i = 0; i < tool.count.x; ++i)
            for (int j = 0; j < tool.count.y; ++j)
                for (int k = 0; k < tool.count.z; ++k)
                    if (const PropertyIndex property = dense[tool.place({i, j, k})]; property != airProperty)
                        tool.cubes.push_back({tool.low + (glm::dvec3(i, j, k) + 0.5) * edge, property});
        return tool;
    }
    VoxelTool voxelTool(RunAxis runs) const {
        RunVolume shape = RunVolume::make(Grid::make(low, edge, count, runs).value(), materials()).value();
        for (const Cube& cube : cubes) {
            const glm::ivec3 voxel(glm::floor((cube.centre - low) / edge));
            (void)shape.insert({voxel.x, voxel.y, voxel.z}, cube.property);
        }
        return VoxelTool::make(std::move(shape)).value();
    }

private:
    std::size_t place(const glm::ivec3& voxel) const {
        return static_cast<std::size_t>((voxel.x * count.y + voxel.y) * count.z + voxel.z);
    }
};

/// The cubes of a tool in the voxels of a workpiece, and in one more voxel all around it: each cube is moved by the
/// pose and compared with all voxel centres that it may contain.
class PlacedCubes {
public:
    PlacedCubes(const Grid& grid, const ToolCubes& tool, const Pose& pose)
        : inside_(static_cast<std::size_t>((side + 2) * (side + 2) * (side + 2))) {
        const glm::dmat3 turned = glm::mat3_cast(pose.rotation);
        const double around = 0.5 * std::sqrt(3.0) * edge;
        for (const ToolCubes::Cube& cube : tool.cubes) {
            const glm::dvec3 centre = pose.position + turned * cube.centre;
            const glm::ivec3 first(glm::floor((centre - around - grid.low()) / edge));
            const glm::ivec3 last(glm::floor((centre + around - grid.low()) / edge));
            for (int i = std::max(first.x, -1); i <= std::min(last.x, side); ++i)
                for (int j = std::max(first.y, -1); j <= std::min(last.y, side); ++j)
                    for (int k = std::max(first.z, -1); k <= std::min(last.z, side); ++k) {
                        const glm::dvec3 place = grid.low() + (glm::dvec3(i, j, k) + 0.5) * edge - centre;
                        bool held = true;
                        for (int axis = 0; axis < 3; ++axis)
                            held = held && std::abs(glm::dot(place, turned[axis])) <= 0.5 * edge;
                        if (held) inside_[index(i, j, k)] = cube.property;
                    }
        }
    }
    PropertyIndex at(int i, int j, int k) const {
        if (std::min({i, j, k}) < -1 || std::max({i, j, k}) > side) return airProperty;
        return inside_[index(i, j, k)];
    }

private:
    static std::size_t index(int i, int j, int k) {
        return static_cast<std::size_t>(((i + 1) * (side + 2) + j + 1) * (side + 2) + k + 1);
    }
    std::vector<PropertyIndex> inside_;
};

/// Soft stock, hard stock and a part in layers whose borders lie anywhere in a voxel, with air above.
RunVolume layers(RunAxis runs) {
    RunVolume volume =
        RunVolume::make(Grid::make(glm::dvec3(-0.5 * side * edge), edge, glm::ivec3(side), runs).value(), materials())
            .value();
    RunPosition from = 0;
    for (const PropertyIndex property : {part, hardStock, softStock}) {
        const auto to = static_cast<RunPosition>(std::min(*rc::gen::inRange(200, 1800) + int(from), side * 256));
        if (from < to) (void)volume.fillBlock({0, 0}, {side, side}, from, to, property);
        from = to;
    }
    (void)volume.fillBlock({0, 0}, {3, 7}, 0, side * 256, softStock);
    return volume;
}

RunAxis anyAxis() {
    return static_cast<RunAxis>(*rc::gen::inRange(0, 3));
}

Pose anyPose() {
    const glm::dvec3 axis(real(-1.0, 1.0), real(-1.0, 1.0), real(0.1, 1.0));
    return {{real(-2.0, 2.0), real(-2.0, 2.0), real(-2.0, 2.0)}, glm::angleAxis(real(0.01, 3.1), glm::normalize(axis))};
}

/// A move of a few voxels, a rotation, both or neither.
Pose after(const Pose& pose) {
    const glm::dvec3 move(real(-1.5, 1.5), real(-1.5, 1.5), real(-1.5, 1.5));
    const glm::dvec3 axis(real(-1.0, 1.0), real(-1.0, 1.0), real(0.1, 1.0));
    const bool moves = *rc::gen::inRange(0, 4) > 0, turns = *rc::gen::inRange(0, 4) > 0;
    return {pose.position + (moves ? move : glm::dvec3(0.0)),
            turns ? pose.rotation * glm::angleAxis(real(-0.8, 0.8), glm::normalize(axis)) : pose.rotation};
}

/// The pose after a part of the motion: the tip moves straight, the rotation between the ends grows evenly.
Pose between(const Pose& from, const Pose& to, double share) {
    glm::dquat turn = glm::conjugate(from.rotation) * to.rotation;
    if (turn.w < 0.0) turn = -turn;
    const double angle = glm::angle(turn);
    const glm::dquat part = angle > 0.0 ? glm::angleAxis(share * angle, glm::axis(turn)) : glm::dquat(1.0, 0, 0, 0);
    return {glm::mix(from.position, to.position, share), from.rotation * part};
}

/// The expected result of a cut, counted unit by unit.
struct CountedCut {
    RunAmounts removed, touched;
    glm::dvec3 moment{0.0}; ///< mm times units

    void add(oracles::DenseGrid& workpiece, const Grid& grid, const PlacedCubes& tool) {
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j)
                for (int k = 0; k < side; ++k)
                    if (const PropertyIndex property = tool.at(i, j, k); property != airProperty)
                        addVoxel(workpiece, grid, {i, j, k}, property);
    }
    std::uint64_t units() const { return totalOf(removed); }

private:
    void addVoxel(oracles::DenseGrid& workpiece, const Grid& grid, VoxelIndex voxel, PropertyIndex property) {
        const LineIndex line = grid.lineOf(voxel);
        const auto first = static_cast<RunPosition>(grid.alongOf(voxel)) * 256;
        for (RunPosition unit = first; unit < first + 256; ++unit) {
            PropertyIndex& here = workpiece.at(line, unit);
            if (here == airProperty) continue;
            if (property == VoxelTool::shank) ++touched.units[here];
            if (property != VoxelTool::flutes || here == part) continue;
            ++removed.units[here];
            glm::dvec3 place = grid.low() + (glm::dvec3(voxel.i, voxel.j, voxel.k) + 0.5) * edge;
            place[grid.axisOfRuns()] = grid.low()[grid.axisOfRuns()] + (unit + 0.5) / 256.0 * edge;
            moment += place;
            here = airProperty;
        }
    }
};

oracles::DenseGrid denseOf(const RunVolume& volume) {
    oracles::DenseGrid dense(volume.grid());
    for (LineIndex line; line.v < side; ++line.v)
        for (line.u = 0; line.u < side; ++line.u) {
            RunPosition from = 0;
            for (const Segment segment : volume.line(line)) {
                dense.fillSpan(line, from, segment.end(), segment.property());
                from = segment.end();
            }
        }
    return dense;
}

} // namespace

/// Tools of any shape, held as S-RLE (paper, eqs. 3, 4 and 6-10).
class VoxelToolTest : public QObject {
    Q_OBJECT

private slots:
    /// Volume of each material, centroid, shank contact and the remaining material, compared with cubes moved one by
    /// one.
    void aCutIsWhatItsCubesCount() {
        int removing = 0, touching = 0, several = 0;
        const bool held = rc::check("cubes, one by one", [&] {
            const ToolCubes cubes = ToolCubes::any();
            const VoxelTool tool = cubes.voxelTool(anyAxis());
            RunVolume workpiece = layers(anyAxis());
            const Grid& grid = workpiece.grid();
            oracles::DenseGrid dense = denseOf(workpiece);
            const Pose from = anyPose(), to = after(from);
            const VoxelCut cut = tool.cut(workpiece, from, to);
            CountedCut wanted;
            for (std::int32_t k = 0; k < cut.poses; ++k)
                wanted.add(dense, grid, {grid, cubes, between(from, to, k / std::max(1.0, cut.poses - 1.0))});
            RC_ASSERT(cut.poses == tool.posesFor(from, to) && !cut.outOfMemory);
            RC_ASSERT(cut.removed == wanted.removed);
            RC_ASSERT(cut.touched == wanted.touched);
            RC_ASSERT(dense.equals(workpiece));
            const double unit = edge * edge * edge / 256.0;
            for (const PropertyIndex property : {softStock, hardStock, part})
                RC_ASSERT(std::abs(cut.removedVolume(property) -
                                   static_cast<double>(wanted.removed.units[property]) * unit) < 1e-9);
            RC_ASSERT(std::abs(cut.volume - static_cast<double>(wanted.units()) * unit) < 1e-9);
            if (wanted.units() > 0)
                RC_ASSERT(glm::length(cut.centroid - wanted.moment / static_cast<double>(wanted.units())) < 1e-9);
            removing += wanted.units() > 0 ? 1 : 0;
            several += wanted.removed.units[softStock] > 0 && wanted.removed.units[hardStock] > 0 ? 1 : 0;
            touching += totalOf(wanted.touched) > 0 ? 1 : 0;
        });
        QVERIFY(held);
        QVERIFY2(removing > 50 && touching > 50 && several > 20,
                 qPrintable(QStringLiteral("%1, %2, %3").arg(removing).arg(touching).arg(several)));
    }

    /// Eq. 4 by brute force: surface voxels of the shank that are surface voxels of the workpiece, in order.
    void theCollisionAreaIsTheIntersectionOfTheSurfaces() {
        int touching = 0;
        const bool held = rc::check("collision area", [&] {
            const ToolCubes cubes = ToolCubes::any();
            const VoxelTool tool = cubes.voxelTool(anyAxis());
            RunVolume workpiece = layers(anyAxis());
            const Grid& grid = workpiece.grid();
            const Pose pose = anyPose();
            const PlacedCubes placed(grid, cubes, pose);
            const auto inShank = [&](int i, int j, int k) { return placed.at(i, j, k) == VoxelTool::shank; };
            const std::vector<VoxelIndex> wanted = commonSurface(workpiece, inShank);
            RC_ASSERT(collisionArea(workpiece.snapshot(), tool, pose) == wanted);
            touching += wanted.empty() ? 0 : 1;
        });
        QVERIFY(held);
        QVERIFY2(touching > 10, qPrintable(QString::number(touching)));
    }

    void aPoseThatIsNotFiniteDoesNothing() {
        const VoxelTool tool = VoxelTool::ofPieces(pieces(cutters::flat()), 1, edge).value();
        RunVolume workpiece = solid({-4.0, -4.0, -4.0}, edge, {side, side, side}, RunAxis::z);
        const Pose lost{{0.0, std::nan(""), 0.0}, {}}, turnedAway{{}, {std::nan(""), 0.0, 0.0, 0.0}};
        for (const Pose& pose : {lost, turnedAway}) {
            QVERIFY(collisionArea(workpiece.snapshot(), tool, pose).empty());
            QCOMPARE(tool.cut(workpiece, {}, pose).volume, 0.0);
            QCOMPARE(tool.cut(workpiece, pose, {}).poses, 0);
        }
        QCOMPARE(workpiece.amounts().units[softStock], std::uint64_t{side} * side * side * 256);
    }

    /// Eq. 8, from the poses themselves: no voxel of the tool moves a whole voxel from one to the next, whatever the
    /// move and the rotation; the first and the last are the motion's ends.
    void noVoxelMovesAWholeVoxelBetweenTwoPoses() {
        double most = 0.0;
        const bool held = rc::check("poses in between", [&] {
            const ToolCubes cubes = ToolCubes::any();
            const VoxelTool tool = cubes.voxelTool(RunAxis::z);
            const Pose from = anyPose();
            Pose to = after(from);
            if (*rc::gen::inRange(0, 3) == 0) to.rotation = -anyPose().rotation; // far, and with the quaternion negated
            const std::int32_t poses = tool.posesFor(from, to);
            RC_ASSERT(poses == tool.posesFor(from, {to.position, -to.rotation}));
            const auto placeOf = [&](const ToolCubes::Cube& cube, std::int32_t k) {
                const Pose pose = VoxelTool::poseOf(from, to, k, poses);
                return pose.position + pose.rotation * cube.centre;
            };
            for (const ToolCubes::Cube& cube : cubes.cubes) {
                RC_ASSERT(glm::length(placeOf(cube, 0) - (from.position + from.rotation * cube.centre)) < 1e-9);
                RC_ASSERT(glm::length(placeOf(cube, poses - 1) - (to.position + to.rotation * cube.centre)) < 1e-9);
                for (std::int32_t k = 1; k < poses; ++k) {
                    const double way = glm::length(placeOf(cube, k) - placeOf(cube, k - 1));
                    RC_ASSERT(way < edge);
                    most = std::max(most, way);
                }
            }
        });
        QVERIFY(held);
        QVERIFY(most > 0.9 * edge); // and not many more poses than necessary
    }

    /// Eq. 8, with numbers.
    void thereAreAsManyPosesAsTheWayHasVoxels() {
        const std::vector<RevolvedPiece> flutes = flutePieces(cutters::flat());
        const VoxelTool tool = VoxelTool::ofPieces(flutes, 1, 0.5).value();
        const Pose still;
        QCOMPARE(tool.posesFor(still, still), 1);
        QCOMPARE(tool.posesFor(still, {{0.49, 0.0, 0.0}, {}}), 2);
        QCOMPARE(tool.posesFor(still, {{0.5, 0.0, 0.0}, {}}), 3);
        QCOMPARE(tool.posesFor(still, {{5.2, 0.0, 0.0}, {}}), 12);
        // A rotation by 0.2 rad about the tip moves the farthest voxel, 12 mm up and 3 to the side, by some 2.4 mm.
        const std::int32_t poses = tool.posesFor(still, {{}, glm::angleAxis(0.2, glm::dvec3(1.0, 0.0, 0.0))});
        QVERIFY(poses >= 6 && poses <= 7);
    }

    /// A tool that is no solid of revolution: a square bar, rotated about its own axis, leaves a round hole.
    void aSquareToolTurnedLeavesARoundHole() {
        const double fine = 0.25;
        RunVolume shape =
            RunVolume::make(Grid::make({-2.0, -2.0, 0.0}, fine, {16, 16, 16}).value(), materials()).value();
        QVERIFY(shape.fillBlock({0, 0}, {16, 16}, 0, 8 * 256, VoxelTool::flutes));
        QVERIFY(shape.fillBlock({4, 4}, {12, 12}, 8 * 256, 16 * 256, VoxelTool::shank));
        const VoxelTool tool = VoxelTool::make(std::move(shape)).value();
        RunVolume workpiece = solid({-5.0, -5.0, -5.0}, fine, {40, 40, 40}, RunAxis::z);
        RunAmounts removed, touched;
        glm::dquat turned(1.0, 0.0, 0.0, 0.0);
        for (int quarter = 0; quarter < 8; ++quarter) {
            const glm::dquat next = glm::angleAxis(pi / 16.0 * (quarter + 1), glm::dvec3(0.0, 0.0, 1.0));
            const VoxelCut cut = tool.cut(workpiece, {{}, turned}, {{}, next});
            QVERIFY(cut.poses >= 2);
            removed.units[softStock] += cut.removed.units[softStock];
            touched.units[softStock] += cut.touched.units[softStock];
            turned = next;
        }
        const double volume = static_cast<double>(totalOf(removed)) * workpiece.grid().unitVolume();
        const double round = pi * 8.0 * 2.0; // radius² = 2² + 2², height 2
        QVERIFY2(std::abs(volume / round - 1.0) < 0.06, qPrintable(QString::number(volume / round)));
        QVERIFY(touched.units[softStock] > 0); // the shank overlaps stock that it does not cut
        QCOMPARE(totalOf(workpiece.amounts()) + totalOf(removed), std::uint64_t{40} * 40 * 40 * 256);
    }

    void toolsWithoutVoxelsAreRefused() {
        RunVolume empty = RunVolume::make(Grid::make(glm::dvec3(0.0), 1.0, {4, 4, 4}).value(), materials()).value();
        QVERIFY(!VoxelTool::make(std::move(empty)).hasValue());
        RunVolume other = RunVolume::make(Grid::make(glm::dvec3(0.0), 1.0, {4, 4, 4}).value(), materials()).value();
        QVERIFY(other.insert({1, 1, 1}, part));
        QVERIFY(!VoxelTool::make(std::move(other)).hasValue());
        QVERIFY(!VoxelTool::ofPieces({}, 0, 0.5).hasValue());
    }
};

BURIN_TEST(VoxelToolTest, NoApplication)

} // namespace burin::tst_voxel_tool

#include "tst_voxel_tool.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"
#include "core/tool/span_rows.h"
#include "tests/core/cutting/scalar_cutter.h"
#include "tests/core/cutting/swept_bounds.h"
#include "tests/oracles/swept_cutter.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <iomanip>
#include <limits>
#include <sstream>

namespace burin::tst_deferred_leaning {

using namespace burin::tests;

namespace {

std::ostream& operator<<(std::ostream& out, const glm::dvec3& v) {
    return out << "{" << v.x << ", " << v.y << ", " << v.z << "}";
}

/// Any direction, and directions parallel, perpendicular and nearly parallel or perpendicular to the grid's axes.
glm::dvec3 anyAxis() {
    const glm::dvec3 any(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
    glm::dvec3 axis = any;
    const int first = *rc::gen::inRange(0, 3), second = (first + 1) % 3;
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
        axis[first] = 0.0; // perpendicular
        break;
    case 1:
        axis[first] = axis[second] = 0.0; // parallel
        break;
    case 2:
        axis[first] *= 1e-5;
        break;
    case 3:
        axis[first] *= 1e-4;
        axis[second] *= 1e-3;
        break;
    default:
        break;
    }
    return glm::length(axis) > 1e-3 ? glm::normalize(axis) : glm::dvec3(0.0, 0.0, -1.0);
}

/// Any direction, parallel and perpendicular to the axis, and parallel and perpendicular to one of the grid's axes.
glm::dvec3 anyWay(const glm::dvec3& axis) {
    const glm::dvec3 any(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
    glm::dvec3 along(0.0);
    along[*rc::gen::inRange(0, 3)] = 1.0;
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
        return axis * any.x;
    case 1:
        return any - glm::dot(any, axis) * axis;
    case 2:
        return along * any.x;
    case 3:
        return any - glm::dot(any, along) * along;
    default:
        return any;
    }
}

/// Ball, flat or bull nose, with long or short flutes. @param radius mm
Cutter anyCutter(double radius) {
    const double straight = radius * real(0.1, 2.0);
    switch (*rc::gen::inRange(0, 3)) {
    case 0:
        return ball(2.0 * radius, radius + straight);
    case 1:
        return flat(2.0 * radius, straight);
    default:
        const double corner = radius * real(0.1, 0.9);
        return bullNose(2.0 * radius, corner, corner + straight);
    }
}

RunAxis anyRunAxis() {
    return *rc::gen::element(RunAxis::x, RunAxis::y, RunAxis::z);
}

/// Half of the points lie at whole voxels of the grid, as a program's often do.
glm::dvec3 placeIn(const Grid& grid) {
    const glm::dvec3 low = grid.box().low, size = grid.box().high - low;
    const glm::dvec3 share(real(0.0, 1.0), real(0.0, 1.0), real(0.0, 1.0));
    if (*rc::gen::inRange(0, 2) == 0) return low + size * share;
    return low + grid.edge() * (glm::floor(size * share / grid.edge()) + 0.5);
}

/// The nearest point at a multiple of a quarter of a voxel, or of a whole voxel, from the grid's corner.
glm::dvec3 quartered(const Grid& grid, const glm::dvec3& place) {
    const double quarter = 0.25 * grid.edge();
    return grid.low() + quarter * glm::round((place - grid.low()) / quarter);
}

/// Parallel to one of the grid's axes.
glm::dvec3 squareAxis() {
    glm::dvec3 axis(0.0);
    axis[*rc::gen::inRange(0, 3)] = *rc::gen::element(-1.0, 1.0);
    return axis;
}

/// In voxels: two coordinates perpendicular to the lines, and one along the runs.
glm::dvec3 inLines(const Grid& grid, const glm::dvec3& place) {
    return inLineFrame(grid, (place - grid.low()) / grid.edge()) - glm::dvec3(0.5, 0.5, 0.0);
}

} // namespace

class DeferredLeaningTest : public QObject {
    Q_OBJECT

private slots:
    /// With a fixed axis of any direction, line by line against exact spans: everything is removed that is swept by a
    /// piece whose faces are offset inwards by the stated bound, and nothing that is not swept by a piece whose faces
    /// are offset outwards, within the stated error of an end. The sums equal the loss of the lines. Some walks use
    /// round numbers, as programs do: ends of moves, axes and outlines then lie exactly on lines.
    void takesWhatExactSpansSay() {
        const bool held = holds("leaning walks", 2000, [] {
            const int side = *rc::gen::inRange(30, 60);
            const Grid fine =
                Grid::make({-1.0, 2.0, -3.0}, 0.5, glm::ivec3(side, side - 7, side - 12), anyRunAxis()).value();
            const bool round = *rc::gen::inRange(0, 3) == 0;
            const double any = real(1.5, 0.25 * side), radius = round ? 0.5 * std::floor(2.0 * any) : any,
                         step = *rc::gen::element(0.05, 0.3, 1.0, 5.0, 20.0, 40.0);
            const Cutter cutter = anyCutter(fine.edge() * radius);
            const RevolvedPiece piece = flutes(cutter);
            const double outline =
                4.0 * SpanRows::outlineError * (reachOf({{piece}}) / fine.edge() + step) + SpanRows::uprightError;
            const double slack = SpanRows::endError + 0.5;
            const double smaller = outline + SpanRows::leaningWayError;
            RunVolume workpiece = block(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            Intervals least(fine), all(fine);
            const auto somewhere = [&] {
                const glm::dvec3 place = placeIn(fine);
                return round ? ToolPose{quartered(fine, place), squareAxis()} : ToolPose{place, anyAxis()};
            };
            ToolPose pose = somewhere();
            glm::dvec3 way = anyWay(pose.axis);
            std::uint64_t taken = 0;
            std::ostringstream moves;
            moves << std::setprecision(17) << "radius " << piece.bottomRadius / fine.edge() << ", corner "
                  << piece.cornerRadius / fine.edge() << ", top " << piece.top / fine.edge() << "\n";
            for (int tick = 0; tick < 8; ++tick) {
                way = *rc::gen::inRange(0, 2) == 0 ? 0.6 * way + 0.4 * anyWay(pose.axis) : anyWay(pose.axis);
                glm::dvec3 next = pose.tip + way * (step * fine.edge() / std::max(glm::length(way), 0.1));
                if (round) next = quartered(fine, next);
                const CutResult cut = removal.cut(workpiece, pose, {next, pose.axis});
                RC_ASSERT(!cut.outOfMemory && !cut.putOff);
                taken += unitsOf(cut, softStock);
                moves << "from " << inLines(fine, pose.tip) << " to " << inLines(fine, next) << ", axis "
                      << inLineFrame(fine, pose.axis) << "\n";
                least.addSweep(grown(piece, -smaller * fine.edge()), pose, next, -slack);
                all.addSweep(grown(piece, outline * fine.edge()), pose, next, slack);
                pose.tip = next;
                if (tick % 3 == 1) (void)workpiece.snapshot();
                if (*rc::gen::inRange(0, 6) == 0) pose = somewhere(); // a new start at another pose
            }
            RC_ASSERT(removal.settle(workpiece).volume == 0.0);
            RC_ASSERT(isValid(workpiece));
            RC_ASSERT(taken == block(fine).amounts().units[softStock] - workpiece.amounts().units[softStock]);
            least.merge();
            all.merge();
            for (LineIndex line; line.v < fine.lineCountV(); ++line.v)
                for (line.u = 0; line.u < fine.lineCountU(); ++line.u) {
                    const std::vector<Span> air = airOf(workpiece.line(line));
                    const auto end = static_cast<double>(fine.lineEnd());
                    const double left = notHeld(least.of(line), air, end), excess = notHeld(air, all.of(line), end);
                    if (left > 0.0 || excess > 0.0)
                        RC_FAIL(moves.str() + "line " + std::to_string(line.u) + ", " + std::to_string(line.v) + ": " +
                                std::to_string(left) + " units left, " + std::to_string(excess) + " too many taken");
                }
        });
        QVERIFY(held);
    }

    /// With a rotating axis: everything deeper in the tool than the stated bound, at any moment of the motion, is
    /// removed; everything that stays farther away than that is kept.
    void turningTakesWhatTheMotionCovers() {
        int gone = 0, left = 0;
        const bool held = holds("turns", 2000, [&] {
            const Grid fine = Grid::make({-1.0, 2.0, -3.0}, 0.5, glm::ivec3(48, 45, 42), anyRunAxis()).value();
            const Cutter cutter = anyCutter(fine.edge() * real(1.5, 10.0));
            const RevolvedPiece piece = flutes(cutter);
            const double reach = reachOf({{piece}}), step = *rc::gen::element(0.05, 0.3, 1.0, 5.0, 20.0, 40.0);
            const glm::dvec3 upright = inSetupFrame(fine, {0.0, 0.0, 1.0});
            const bool rocks = *rc::gen::inRange(0, 4) == 0; // about the upright axis
            ToolPose pose{placeIn(fine), rocks ? glm::normalize(upright + 0.003 * anyAxis()) : anyAxis()};
            RunVolume workpiece = block(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            std::vector<ToolPose> poses;
            std::uint64_t taken = 0;
            constexpr double spacing = 0.1; // voxels, largest movement of any point of the tool between two samples
            for (int tick = 0; tick < 3; ++tick) {
                const double turn = *rc::gen::element(0.0, 0.001, 0.05, 0.5);
                const glm::dvec3 turned = glm::normalize(pose.axis + turn * anyAxis());
                const glm::dvec3 axis = rocks && tick != 1 ? upright : turned;
                const glm::dvec3 way = anyWay(axis);
                const ToolPose next{pose.tip + way * (step * fine.edge() / std::max(glm::length(way), 0.1)), axis};
                const CutResult cut = removal.cut(workpiece, pose, next);
                RC_ASSERT(!cut.outOfMemory);
                taken += unitsOf(cut, softStock);
                const double angle = std::acos(std::clamp(glm::dot(pose.axis, axis), -1.0, 1.0));
                const double moves = glm::length(next.tip - pose.tip) + angle * reach;
                const int samples = 1 + static_cast<int>(moves / (spacing * fine.edge()));
                for (int i = 0; i <= samples; ++i) poses.push_back(oracles::motionAt(pose, next, double(i) / samples));
                pose = next;
            }
            taken += unitsOf(removal.settle(workpiece), softStock);
            RC_ASSERT(taken == block(fine).amounts().units[softStock] - workpiece.amounts().units[softStock]);
            RC_ASSERT(isValid(workpiece));
            const double tolerance = fine.edge() * (0.1 + SpanRows::leaningWayError + 0.5 * spacing + 2.0 / 256.0);
            for (int i = 0; i < 150; ++i) {
                // Near the tool at some moment, on the nearest line.
                const ToolPose& moment = poses[*rc::gen::inRange<std::size_t>(0, poses.size())];
                const double radius = piece.bottomRadius + fine.edge(),
                             height = real(-fine.edge(), piece.top + fine.edge());
                const glm::dvec3 near =
                    moment.tip + height * moment.axis + radius * glm::dvec3(real(-1, 1), real(-1, 1), real(-1, 1));
                const glm::dvec3 voxels = inLineFrame(fine, (near - fine.low()) / fine.edge());
                const LineIndex line{static_cast<std::int32_t>(std::floor(voxels.x)),
                                     static_cast<std::int32_t>(std::floor(voxels.y))};
                const double unit = std::floor(voxels.z * unitsPerVoxel);
                if (!fine.contains(line) || unit < 0.0 || unit >= static_cast<double>(fine.lineEnd())) continue;
                const glm::dvec3 point = fine.low() + fine.edge() * inSetupFrame(fine, {line.u + 0.5, line.v + 0.5,
                                                                                        (unit + 0.5) / unitsPerVoxel});
                double beyond = std::numeric_limits<double>::infinity();
                for (const ToolPose& other : poses)
                    beyond = std::min(beyond, oracles::beyondSurface(piece, point - other.tip, other.axis));
                const auto segments = workpiece.line(line);
                const auto holds =
                    std::ranges::find_if(segments, [&](Segment segment) { return segment.end() > unit; });
                if (beyond < -tolerance) {
                    RC_ASSERT(holds->property() == airProperty);
                    ++gone;
                } else if (beyond > tolerance) {
                    RC_ASSERT(holds->property() == softStock);
                    ++left;
                }
            }
        });
        QVERIFY(held);
        QVERIFY(gone > 1000);
        QVERIFY(left > 1000);
    }

    /// A tool that stands still where it arrived, with any axis, removes nothing. Flutes shorter than a voxel may pass
    /// between two rows of lines and remove nothing during the motion either: most must.
    void standingStillTakesNothing() {
        int taken = 0;
        const bool held = holds("stands", 300, [&] {
            const Grid fine = Grid::make({-1.0, 2.0, -3.0}, 0.5, glm::ivec3(50, 47, 44), anyRunAxis()).value();
            const Cutter cutter = anyCutter(fine.edge() * real(2.0, 10.0));
            RunVolume workpiece = block(fine);
            MaterialRemoval removal(cutter, fine, Writing::deferred);
            const glm::dvec3 middle = 0.5 * (fine.box().low + fine.box().high);
            const ToolPose from{middle, anyAxis()}, to{middle + glm::dvec3(real(-2, 2), real(-2, 2), real(-2, 2)),
                                                       *rc::gen::inRange(0, 2) == 0 ? from.axis : anyAxis()};
            if (removal.cut(workpiece, from, to).volume > 0.0) ++taken;
            RC_ASSERT(removal.cut(workpiece, to, to).volume == 0.0);
            removal.settle(workpiece);
            RC_ASSERT(removal.cut(workpiece, to, to).volume == 0.0);
            removal.reset(); // a new cutter removes nothing either
            RC_ASSERT(removal.cut(workpiece, to, to).volume == 0.0);
        });
        QVERIFY(held);
        QVERIFY(taken > 250);
    }
};

BURIN_TEST(DeferredLeaningTest, NoApplication)

} // namespace burin::tst_deferred_leaning

#include "tst_deferred_leaning.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/row_replay.h"

#include "core/cutting/line_frame.h"
#include "core/cutting/solid_contact.h"
#include "core/geometry/grown_pieces.h"
#include "core/geometry/upright.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr std::size_t movesBetweenLooks = 256;

/// The part of a straight move whose position along one axis lies in an interval, as fractions of the move; low > high
/// if empty.
Span shareWithin(double from, double to, const Span& interval) noexcept {
    const double way = to - from;
    if (std::abs(way) < 1e-12) return from >= interval.low && from <= interval.high ? Span{0.0, 1.0} : Span{1.0, 0.0};
    const double a = (interval.low - from) / way, b = (interval.high - from) / way;
    return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

} // namespace

ReplayTool::ReplayTool(const Cutter& cutter, const Grid& grid, double nearDistance)
    : stack(pieces(cutter))
    , fluteCount(flutePieces(cutter).size())
    , upright(grid.axis() == RunAxis::z)
    , near(nearDistance)
    , filter(std::span(stack).first(fluteCount), grid) {
    if (cutter.solid != nullptr) {
        solid = columnsOf(cutter, grid);
        turns = cutter.turns();
        section = oriented(cutter.solid->section);
    }
    for (std::size_t i = 0; i < stack.size(); ++i) {
        if (i < fluteCount) {
            wider.push_back(thickened(stack[i], 0.75 * grid.edge())); // to the corners of a line's square
            fluteRadius = std::max(fluteRadius, stack[i].widestRadius());
        } else if (sectionOf(cutter, i) == ToolSection::shank) {
            ++shankCount;
        }
    }
    const glm::dvec3 axis = inLineFrame(grid, uprightAxis);
    guardBottom = guardBottomAt(axis);
    if (hasSolidShank()) { // it may begin within the flutes, and be wider there than the pieces of the shank
        const Box shank = boundingBox(cutter.solid->shank);
        const double widest = glm::length(glm::max(glm::abs(glm::dvec2(shank.low)), glm::abs(glm::dvec2(shank.high))));
        const double across = widest * std::sqrt(std::max(0.0, 1.0 - axis.z * axis.z));
        guardBottom = std::min(guardBottom, std::min(shank.low.z * axis.z, shank.high.z * axis.z) - across);
    }
}

double ReplayTool::guardBottomAt(const glm::dvec3& axis) const noexcept {
    double bottom = std::numeric_limits<double>::infinity();
    for (std::size_t i = fluteCount; i < stack.size(); ++i) {
        const double across = stack[i].widestRadius() * std::sqrt(std::max(0.0, 1.0 - axis.z * axis.z));
        bottom = std::min(bottom, std::min(stack[i].bottom * axis.z, stack[i].top * axis.z) - across);
    }
    return bottom;
}

std::uint32_t stepsOf(const ToolMove& move, double edge) noexcept {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(glm::length(move.to.tip - move.begin().tip) / edge)));
}

RowResult RowReplay::run(std::span<const std::uint32_t> turns, const Progress& progress) {
    for (std::size_t i = 0; i < turns.size(); ++i) {
        if (i % movesBetweenLooks == 0) {
            if (progress.cancelled()) break;
            reach_ = stock_.reach();
        }
        make(moves_[turns[i]], static_cast<std::uint32_t>(i));
    }
    return std::move(result_);
}

void RowReplay::make(const ToolMove& move, std::uint32_t number) {
    const ReplayTool& tool = tools_[move.tool];
    const glm::dvec3 from = inLineFrame(grid_, move.begin().tip), to = inLineFrame(grid_, move.to.tip);
    const bool tilted = move.tilted();
    axis_ = inLineFrame(grid_, move.middleAxis());
    guardBottom_ = tilted ? tool.guardBottomAt(axis_) : tool.guardBottom;
    UnitSum removed;
    metered_ = meters_ && !move.rapid && tool.turns;
    if (metered_) meter_.begin(number, std::span(tool.stack).first(tool.fluteCount), tool.section, from, to, axis_);
    const std::size_t contacts = result_.contacts.size();
    if (!mayTouch(tool, from, to)) {
        if (tool.upright && !tilted && !tool.solid)
            cutUpright(tool, from, to, removed);
        else
            cutSwept(tool, from, to, removed);
    } else {
        const std::uint32_t steps = stepsOf(move, grid_.edge());
        glm::dvec3 tip = from;
        for (std::uint32_t step = 1; step <= steps; ++step) {
            const glm::dvec3 next = step == steps ? to : glm::mix(from, to, static_cast<double>(step) / steps);
            cutSwept(tool, tip, next, removed);
            lookAt(tool, next, number, step);
            tip = next;
        }
    }
    if (grazes_ && move.rapid && tool.upright && !tilted && !tool.solid) lookGrazed(tool, from, to, number);
    if (removed.units > 0) result_.cuts.push_back({number, removed});
    if (metered_) meter_.finish(result_.steps);
    if (tool.near > 0.0 && result_.contacts.size() == contacts) lookNear(tool, from, to, number);
}

void RowReplay::take(LineIndex line, RunPosition from, RunPosition to, UnitSum& removed) {
    const std::uint64_t units = removed.units, along = removed.along;
    stock_.cut(line, from, to, removed);
    if (!metered_ || removed.units == units) return;
    const auto taken = static_cast<double>(removed.units - units);
    const double middle = 0.5 * static_cast<double>(removed.along - along) / taken;
    meter_.add(line, middle - 0.5 * taken, middle + 0.5 * taken);
}

void RowReplay::cutUpright(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed) {
    const Box box = inLineFrame(grid_, grid_.box());
    const double edge = grid_.edge(), radius = tool.fluteRadius;
    const double lowest = (std::min(from.z, to.z) - box.low.z) / edge * unitsPerVoxel;
    const Span band{box.low.y + stock_.firstV() * edge - radius,
                    box.low.y + (stock_.firstV() + stock_.lineCountV()) * edge + radius};
    const Span share = shareWithin(from.y, to.y, band);
    if (share.low > share.high) return;
    const double a = from.x + share.low * (to.x - from.x), b = from.x + share.high * (to.x - from.x);
    const LineInterval columns =
        linesWithin({std::min(a, b) - radius, std::max(a, b) + radius}, box.low.x, edge, grid_.lineCountU());
    if (columns.last < columns.first) return;
    const CutFilter::Way way = tool.filter.way(from, to);
    const auto stride = static_cast<std::size_t>(stock_.brickCount()) * brickSide;
    flutes_.clear();
    for (std::int32_t brick = columns.first / brickSide; brick <= columns.last / brickSide; ++brick) {
        if (lowest >= stock_.brickTop(brick)) continue;
        const LineIndex corner{brick * brickSide, stock_.firstV()};
        const std::uint64_t lines = tool.filter.mayCut(way, corner, stock_.tops(corner.v) + corner.u, stride);
        if (lines == 0) continue;
        if (flutes_.empty())
            for (const RevolvedPiece& piece : std::span(tool.stack).first(tool.fluteCount))
                flutes_.push_back({SweptPiece(piece, from, to), piece.topRadius == piece.widestRadius() &&
                                                                    std::min(from.z, to.z) + piece.top >= box.high.z});
        cutBrick(brick, lines, removed);
    }
}

void RowReplay::cutBrick(std::int32_t brick, std::uint64_t lines, UnitSum& removed) {
    const Box box = inLineFrame(grid_, grid_.box());
    const std::uint64_t before = removed.units;
    const auto positionOf = [&](double height) {
        return height <= box.low.z    ? RunPosition{0}
               : height >= box.high.z ? grid_.lineEnd()
                                      : grid_.toRunPosition(height);
    };
    for (; lines != 0; lines &= lines - 1) {
        const int place = std::countr_zero(lines);
        const LineIndex line{brick * brickSide + place % brickSide, stock_.firstV() + place / brickSide};
        const glm::dvec2 centre = grid_.lineCentre(line);
        for (const Flute& flute : flutes_) {
            RunPosition from = 0, to = grid_.lineEnd();
            if (flute.throughTop) {
                const std::optional<double> bottom = flute.swept.bottomAlong(centre.x, centre.y);
                if (!bottom) continue;
                from = positionOf(*bottom);
            } else {
                const std::optional<Span> span = flute.swept.along(centre.x, centre.y);
                if (!span) continue;
                from = positionOf(span->low);
                to = positionOf(span->high);
            }
            if (from < to) take(line, from, to, removed);
        }
    }
    if (removed.units > before) stock_.settle(brick);
}

void RowReplay::cutSwept(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed) {
    if (tool.solid) return cutSolid(*tool.solid, from, to, removed);
    for (std::size_t i = 0; i < tool.fluteCount; ++i) {
        std::int32_t brick = -1;
        const auto cut = [&](LineIndex line, RunPosition low, RunPosition high) {
            const std::uint64_t before = removed.units;
            take(line, low, high, removed);
            if (removed.units == before || line.u / brickSide == brick) return true;
            if (brick >= 0) stock_.settle(brick);
            brick = line.u / brickSide;
            return true;
        };
        forEachSpanInRows(SweptPiece(tool.stack[i], from, to, axis_), grid_, rows(), cut);
        if (brick >= 0) stock_.settle(brick);
    }
}

void RowReplay::lookGrazed(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, std::uint32_t number) {
    if (std::min(from.z, to.z) - inLineFrame(grid_, grid_.low()).z >= reach_ * grid_.edge() / unitsPerVoxel) return;
    for (const RevolvedPiece& piece : tool.wider)
        forEachSpanInRows(SweptPiece(piece, from, to), grid_, rows(),
                          [&](LineIndex line, RunPosition low, RunPosition high) {
                              UnitSum here;
                              if (static_cast<std::int32_t>(low) < stock_.brickReach(line.u / brickSide) &&
                                  stock_.overlap(line, low, high, here) > 0)
                                  result_.grazed.push_back({number, line});
                              return true;
                          });
}

bool RowReplay::mayTouch(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to) const {
    const double lowest = std::min(from.z, to.z) + guardBottom_ - inLineFrame(grid_, grid_.low()).z;
    if (lowest >= reach_ * grid_.edge() / unitsPerVoxel) return false;
    if (tool.hasSolidShank() && shankTouches(*tool.solid, from, to)) return true;
    for (std::size_t i = tool.guardFirst(); i < tool.stack.size(); ++i)
        if (touches(SweptPiece(tool.stack[i], from, to, axis_), contactTolerance(tool.stack[i], grid_))) return true;
    return false;
}

bool RowReplay::touches(const SweptPiece& piece, RunPosition tolerance) const {
    bool found = false;
    UnitSum sum;
    forEachSpanInRows(piece, grid_, rows(), [&](LineIndex line, RunPosition from, RunPosition to) {
        if (static_cast<std::int32_t>(from) < stock_.brickReach(line.u / brickSide))
            found = stock_.overlap(line, from, to, sum) > tolerance;
        return !found;
    });
    return found;
}

void RowReplay::lookNear(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, std::uint32_t number) {
    const double lowest = std::min(from.z, to.z) + guardBottom_ - tool.near - inLineFrame(grid_, grid_.low()).z;
    if (lowest >= reach_ * grid_.edge() / unitsPerVoxel) return;
    const auto guards = std::span(tool.stack).subspan(tool.fluteCount);
    if (!tool.hasSolidShank()) lookNear(guards.first(tool.shankCount), ToolSection::shank, tool.near, from, to, number);
    lookNear(guards.subspan(tool.shankCount), ToolSection::holder, tool.near, from, to, number);
}

void RowReplay::lookNear(std::span<const RevolvedPiece> section, ToolSection which, double near, const glm::dvec3& from,
                         const glm::dvec3& to, std::uint32_t number) {
    UnitSum nearest;
    if (section.empty() || !isNear(section, near, from, to, nearest)) return;
    double clear = 0.0;
    while (near - clear > passResolution) {
        const double middle = 0.5 * (clear + near);
        UnitSum sum;
        if (isNear(section, middle, from, to, sum)) {
            near = middle;
            nearest = sum;
        } else {
            clear = middle;
        }
    }
    result_.passes.push_back({number, which, clear, nearest});
}

/// Whether anything is within a distance of the sweep of a section; adds it to `sum`.
bool RowReplay::isNear(std::span<const RevolvedPiece> section, double by, const glm::dvec3& from, const glm::dvec3& to,
                       UnitSum& sum) const {
    for (const RevolvedPiece& piece : section)
        for (const RevolvedPiece& grown : grownPieces(piece, by))
            forEachSpanInRows(SweptPiece(grown, from, to, axis_), grid_, rows(),
                              [&](LineIndex line, RunPosition low, RunPosition high) {
                                  UnitSum here;
                                  if (static_cast<std::int32_t>(low) < stock_.brickReach(line.u / brickSide) &&
                                      stock_.overlap(line, low, high, here) > 0)
                                      sum.add(here);
                                  return true;
                              });
    return sum.units > 0;
}

void RowReplay::lookAt(const ReplayTool& tool, const glm::dvec3& tip, std::uint32_t number, std::uint32_t step) {
    if (tool.hasSolidShank()) lookAtShank(tool, tip, number, step);
    for (std::size_t i = tool.guardFirst(); i < tool.stack.size(); ++i) {
        UnitSum touched;
        const SweptPiece piece(tool.stack[i], tip, tip, axis_);
        const RunPosition tolerance = contactTolerance(tool.stack[i], grid_);
        forEachSpanInRows(piece, grid_, rows(), [&](LineIndex line, RunPosition from, RunPosition to) {
            UnitSum here;
            if (stock_.overlap(line, from, to, here) > tolerance) touched.add(here);
            return true;
        });
        if (touched.units > 0) result_.contacts.push_back({number, step, static_cast<std::uint32_t>(i), touched});
    }
}

} // namespace burin

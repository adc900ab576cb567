// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/contact.h"

#include "core/cutting/contact_overlap.h"
#include "core/cutting/footprint.h"
#include "core/cutting/line_frame.h"
#include "core/tool/piece_chord.h"
#include "core/tool/swept_span.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace burin {

namespace {

/// Returns a piece that contains every point within `margin` of another one.
RevolvedPiece grown(const RevolvedPiece& piece, double margin) noexcept {
    if (piece.bulges()) // the cylinder around it
        return {piece.bottom - margin, piece.top + margin, piece.widestRadius() + margin, piece.widestRadius() + margin,
                0.0};
    const double widening = (piece.topRadius - piece.bottomRadius) / (piece.top - piece.bottom);
    const double beside = margin * (std::sqrt(1.0 + widening * widening) + std::abs(widening));
    return {piece.bottom - margin, piece.top + margin, piece.bottomRadius + beside, piece.topRadius + beside, 0.0};
}

/// One piece of a tool that must not touch, at a pose in the line frame.
class GuardedPiece {
public:
    /// @param window  pending writes to the workpiece, or null
    GuardedPiece(const RunVolume& workpiece, const CutCache* window, const RevolvedPiece& piece,
                 const ToolPose& pose) noexcept
        : workpiece_(workpiece)
        , window_(window)
        , grid_(workpiece.grid())
        , piece_(piece)
        , pose_(pose)
        , tolerance_(contactTolerance(piece, workpiece.grid()))
        , nearBrick_(grown(piece, halfDiagonal(OccupiedBricks::brickSide)), pose.axis)
        , nearBlock_(grown(piece, halfDiagonal(OccupiedBricks::blockSide)), pose.axis) {
        const double widest = piece_.widestRadius();
        for (int i = 0; i < 3; ++i) {
            const double across = widest * std::sqrt(std::max(0.0, 1.0 - pose_.axis[i] * pose_.axis[i]));
            const double bottom = pose_.tip[i] + piece_.bottom * pose_.axis[i];
            const double top = pose_.tip[i] + piece_.top * pose_.axis[i];
            reach_.low[i] = std::min(bottom, top) - across;
            reach_.high[i] = std::max(bottom, top) + across;
        }
        const glm::dvec3 low = inLineFrame(grid_, grid_.low());
        alongLow_ = low.z;
        columns_ = linesWithin({reach_.low.x, reach_.high.x}, low.x, grid_.edge(), grid_.lineCountU());
        rows_ = linesWithin({reach_.low.y, reach_.high.y}, low.y, grid_.edge(), grid_.lineCountV());
    }

    /// Visits the bricks that may contain overlapped material, and adds the overlap.
    /// @param bricks  null: every brick may contain material
    void addTo(ContactOverlap& overlap, OccupiedBricks* bricks) noexcept {
        if (columns_.last < columns_.first || rows_.last < rows_.first) return;
        const auto& [lowCorner, highCorner] = grid_.box();
        if (reach_.high.z <= alongLow_ || reach_.low.z >= inLineFrame(grid_, highCorner).z) return;
        forEachSquare(
            OccupiedBricks::blockSide, columns_, rows_, [&](LineIndex block, LineInterval us, LineInterval vs) {
                if (bricks != nullptr && !mayTouch(nearBlock_, bricks->block(block), block, OccupiedBricks::blockSide))
                    return;
                forEachSquare(OccupiedBricks::brickSide, us, vs,
                              [&](LineIndex brick, LineInterval inner, LineInterval outer) {
                                  if (bricks != nullptr) {
                                      constexpr std::int32_t side = OccupiedBricks::brickSide;
                                      if (!mayTouch(nearBrick_, bricks->brick(brick), brick, side)) return;
                                      if (!mayTouch(nearBrick_, bricks->lookAt(workpiece_, brick), brick, side)) return;
                                  }
                                  addBrick(inner, outer, overlap);
                              });
            });
    }

private:
    double halfDiagonal(std::int32_t side) const noexcept { return 0.5 * std::numbers::sqrt2 * side * grid_.edge(); }
    /// Calls `visit(low corner, u range, v range)` for each square of a raster that overlaps two ranges of lines.
    template <class Visit>
    static void forEachSquare(std::int32_t side, LineInterval us, LineInterval vs, Visit&& visit) noexcept {
        for (std::int32_t v = vs.first - vs.first % side; v <= vs.last; v += side)
            for (std::int32_t u = us.first - us.first % side; u <= us.last; u += side)
                visit(LineIndex{u, v}, LineInterval{std::max(u, us.first), std::min(u + side - 1, us.last)},
                      LineInterval{std::max(v, vs.first), std::min(v + side - 1, vs.last)});
    }
    /// Whether the grown piece, above the middle of a square of scanlines, reaches into their occupied extent.
    bool mayTouch(const PieceChord& grownPiece, OccupiedBricks::Extent extent, LineIndex corner,
                  std::int32_t side) const noexcept {
        if (extent.empty()) return false;
        const double low = alongLow_ + extent.low * grid_.edge(), high = alongLow_ + extent.high * grid_.edge();
        if (high <= reach_.low.z || low >= reach_.high.z) return false;
        const glm::dvec2 middle = grid_.lineCentre(corner) + 0.5 * (side - 1) * grid_.edge() - glm::dvec2(pose_.tip);
        const std::optional<Span> span = grownPiece.along(middle.x, middle.y);
        return span && pose_.tip.z + span->low < high && pose_.tip.z + span->high > low;
    }
    void addBrick(LineInterval us, LineInterval vs, ContactOverlap& overlap) noexcept {
        if (!swept_) swept_.emplace(piece_, pose_.tip, pose_.tip, pose_.axis);
        for (LineIndex line{us.first, vs.first}; line.v <= vs.last; ++line.v)
            for (line.u = us.first; line.u <= us.last; ++line.u) {
                const glm::dvec2 centre = grid_.lineCentre(line);
                if (const std::optional<Span> span = swept_->along(centre.x, centre.y)) addLine(line, *span, overlap);
            }
    }
    void addLine(LineIndex line, const Span& span, ContactOverlap& overlap) const noexcept {
        const RunPosition from = grid_.toRunPosition(span.low), to = grid_.toRunPosition(span.high);
        if (from >= to) return;
        std::uint64_t units = 0;
        forEachPieceNotOwed(workpiece_, window_, line, from, to,
                            [&](PropertyIndex, RunPosition start, RunPosition end) { units += end - start; });
        if (units <= tolerance_) return;
        forEachPieceNotOwed(workpiece_, window_, line, from, to,
                            [&](PropertyIndex property, RunPosition start, RunPosition end) {
                                overlap.add(grid_, line, property, start, end);
                            });
    }

    const RunVolume& workpiece_;
    const CutCache* window_;
    const Grid& grid_;
    const RevolvedPiece& piece_;
    const ToolPose& pose_;
    const RunPosition tolerance_;
    PieceChord nearBrick_, nearBlock_;
    Box reach_;
    double alongLow_ = 0.0;
    LineInterval columns_, rows_;
    std::optional<SweptPiece> swept_; ///< only made when a brick may overlap the piece
};

ShankContact contactAt(const RunVolume& workpiece, const CutCache* window, std::span<const RevolvedPiece> tool,
                       std::size_t fluteCount, const ToolPose& setupPose, OccupiedBricks* bricks) noexcept {
    ShankContact contact;
    if (!isFinite(setupPose.tip) || !isFinite(setupPose.axis)) return contact;
    const Grid& grid = workpiece.grid();
    const ToolPose pose = inLineFrame(grid, setupPose);
    ContactOverlap overlap;
    std::uint64_t most = 0;
    for (std::size_t i = fluteCount; i < tool.size(); ++i) {
        const std::uint64_t before = overlap.units;
        GuardedPiece(workpiece, window, tool[i], pose).addTo(overlap, bricks);
        if (overlap.units - before <= most) continue;
        most = overlap.units - before;
        contact.piece = static_cast<std::uint32_t>(i);
    }
    overlap.describe(workpiece, contact);
    return contact;
}

} // namespace

ShankContact ContactCheck::at(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                              const ToolPose& pose, const CutCache* window) noexcept {
    return contactAt(workpiece, window, tool, fluteCount, pose, &bricks_);
}

ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool,
                          const glm::dvec3& tip) noexcept {
    return contactAt(workpiece, nullptr, tool, 1, {tip, {0.0, 0.0, 1.0}}, nullptr);
}

ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                          const ToolPose& pose) noexcept {
    return contactAt(workpiece, nullptr, tool, fluteCount, pose, nullptr);
}

} // namespace burin

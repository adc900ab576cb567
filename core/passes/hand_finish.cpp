// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/hand_finish.h"

#include "core/base/parallel.h"
#include "core/geometry/segment.h"
#include "core/passes/surface_trace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace burin {
namespace {

constexpr double handSpacing = 0.2;      // mm between examined points of strokes and of the pass
constexpr double borderWithin = 0.005;   // mm along the pass
constexpr double shortestPiece = 0.02;   // mm of a pass that is milled between two borders
constexpr double handTolerance = 1e-6;   // mm
constexpr std::size_t probedAtOnce = 64; // points that share a probe

/// The line with points at most a distance apart.
TipLine divided(const TipLine& line, double apart) {
    TipLine points;
    if (!line.empty()) points.push_back(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(line[i - 1], line[i]) / apart)));
        for (int k = 1; k <= steps; ++k)
            points.push_back(glm::mix(line[i - 1], line[i], static_cast<double>(k) / steps));
    }
    return points;
}

double roundedReach(const Cutter& cutter, double height) noexcept {
    const double radius = cutter.cornerRadius, used = std::min(height, radius);
    return std::sqrt(used * (2.0 * radius - used));
}

double flatReach(const Cutter& cutter) noexcept {
    const bool isFlat = cutter.type == CutterType::flat || cutter.type == CutterType::bullNose;
    return isFlat ? cutter.radius() - cutter.cornerRadius : 0.0;
}

/// A part of a stroke of the pass that lies either in or beside what the hand has finished.
struct Piece {
    TipLine line;
    bool inside = false;
};

/// Splits a stroke at the borders; neighbouring pieces share the point between them.
template <class Inside>
std::vector<Piece> piecesOf(const TipLine& line, const Inside& isInside) {
    std::vector<Piece> pieces;
    for (const glm::dvec3& tip : line) {
        const bool inside = isInside(tip);
        if (pieces.empty()) pieces.push_back({{}, inside});
        if (pieces.back().inside != inside) {
            glm::dvec3 before = pieces.back().line.back(), after = tip;
            while (glm::distance(before, after) > borderWithin) {
                const glm::dvec3 middle = 0.5 * (before + after);
                (isInside(middle) == inside ? after : before) = middle;
            }
            const glm::dvec3 border = inside ? before : after; // beside it
            pieces.back().line.push_back(border);
            pieces.push_back({{border}, inside});
        }
        pieces.back().line.push_back(tip);
    }
    return pieces;
}

/// Rises from the surface of tips to the height that the hand left. @param share of that height, 0 … 1
glm::dvec3 risen(glm::dvec3 tip, double share, const HandFinish& hand, double reach) {
    if (const auto near = hand.nearest(tip, reach)) tip.z += share * std::clamp(near->left, 0.0, hand.height());
    return tip;
}

/// The beginning of a line that lies inside, as long as the overlap, rising towards its end.
TipLine overlapOf(const TipLine& line, double overlap, const HandFinish& hand, double reach) {
    TipLine head{line.front()};
    double done = 0.0; // mm
    for (std::size_t i = 1; i < line.size() && done < overlap; ++i) {
        const double length = glm::distance(line[i - 1], line[i]);
        if (length == 0.0) continue;
        const double part = std::min(1.0, (overlap - done) / length);
        done += part * length;
        head.push_back(risen(glm::mix(line[i - 1], line[i], part), std::min(1.0, done / overlap), hand, reach));
    }
    return head;
}

/// A line inside that is shorter than two overlaps: the pass goes on over it, and is highest in its middle.
TipLine bridged(const TipLine& line, double overlap, const HandFinish& hand, double reach) {
    TipLine over;
    const double whole = lengthOf(line);
    double done = 0.0; // mm
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) done += glm::distance(line[i - 1], line[i]);
        over.push_back(risen(line[i], std::max(0.0, std::min(done, whole - done)) / overlap, hand, reach));
    }
    return over;
}

void append(TipLine& line, const TipLine& more) {
    line.insert(line.end(), more.begin() + (line.empty() ? 0 : 1), more.end());
}

/// What is milled of a stroke that was split. @param lost increased by what is not, mm
std::vector<TipLine> blended(const std::vector<Piece>& pieces, double overlap, const HandFinish& hand, double reach,
                             double& lost) {
    std::vector<TipLine> lines(1);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        const double length = lengthOf(piece.line);
        const bool before = i > 0, after = i + 1 < pieces.size();
        if (!piece.inside) {
            append(lines.back(), piece.line);
        } else if (before && after && length <= 2.0 * overlap) {
            append(lines.back(), bridged(piece.line, overlap, hand, reach));
        } else {
            if (before) append(lines.back(), overlapOf(piece.line, overlap, hand, reach));
            TipLine tail;
            if (after) {
                tail = overlapOf({piece.line.rbegin(), piece.line.rend()}, overlap, hand, reach);
                std::ranges::reverse(tail);
            }
            lines.push_back(tail);
            lost += std::max(0.0, length - (before ? overlap : 0.0) - (after ? overlap : 0.0));
        }
    }
    return lines;
}

std::vector<TipLine> besides(std::vector<Piece> pieces, double& lost) {
    std::vector<TipLine> lines;
    for (Piece& piece : pieces)
        if (piece.inside)
            lost += lengthOf(piece.line);
        else
            lines.push_back(std::move(piece.line));
    return lines;
}

} // namespace

HandFinish::HandFinish(const PassRequest& request, const PassGround& ground, const SurfaceTrace& trace,
                       const Progress& progress)
    : height_(request.finishedWithin > 0.0 ? request.finishedWithin : usualFinish)
    , rounded_(roundedReach(ground.tool.cutter, height_))
    , flat_(flatReach(ground.tool.cutter))
    , cell_(std::max(0.5, rounded_ + flat_)) {
    for (const TipLine& stroke : ground.handStrokes) {
        const TipLine tips = divided(stroke, handSpacing);
        std::vector<std::optional<double>> left(tips.size()); // where the tip counts
        parallelIntervals(std::size_t{0}, tips.size(), probedAtOnce, [&](std::size_t from, std::size_t to) {
            if (progress.cancelled()) return;
            TipDrop probe = trace.probe();
            for (std::size_t i = from; i < to; ++i) {
                const SurfacePlace place = trace.at(glm::dvec2(tips[i]), probe);
                const double above = tips[i].z - place.tip.z;
                if (place.onPart && above <= height_ + handTolerance) left[i] = above;
            }
        });
        for (std::size_t i = 1; i < tips.size(); ++i)
            if (left[i - 1] && left[i]) add({tips[i - 1], tips[i], *left[i - 1], *left[i]});
    }
}

std::int64_t HandFinish::cellOf(double x, double y) const noexcept {
    constexpr std::int64_t apart = std::int64_t{1} << 31; // more than there are cells in a row
    return static_cast<std::int64_t>(std::floor(x / cell_)) + apart * static_cast<std::int64_t>(std::floor(y / cell_));
}

/// In each cell that its box touches; a move is at most as long as the spacing.
void HandFinish::add(const Move& move) {
    const auto index = static_cast<std::uint32_t>(moves_.size());
    moves_.push_back(move);
    const glm::dvec3 low = glm::min(move.from, move.to), high = glm::max(move.from, move.to);
    std::vector<std::int64_t> touched;
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y})
            if (const std::int64_t cell = cellOf(x, y); std::ranges::find(touched, cell) == touched.end())
                touched.push_back(cell);
    for (const std::int64_t cell : touched) cells_[cell].push_back(index);
}

template <class Visit>
void HandFinish::visitNear(const glm::dvec3& tip, double within, const Visit& visit) const {
    const int reach = static_cast<int>(std::ceil(within / cell_));
    for (int right = -reach; right <= reach; ++right)
        for (int up = -reach; up <= reach; ++up) {
            const auto cell = cells_.find(cellOf(tip.x + right * cell_, tip.y + up * cell_));
            if (cell == cells_.end()) continue;
            for (const std::uint32_t index : cell->second)
                if (visit(moves_[index])) return;
        }
}

std::optional<HandFinish::Near> HandFinish::nearest(const glm::dvec3& tip, double within) const {
    std::optional<Near> found;
    visitNear(tip, within, [&](const Move& move) {
        const glm::dvec3 there = nearestOnSegment(tip, move.from, move.to);
        const double distance = glm::distance(tip, there), length = glm::distance(move.from, move.to);
        if (distance > within || (found && distance >= found->distance)) return false;
        const double share = length > 0.0 ? glm::distance(move.from, there) / length : 0.0;
        found = Near{distance, std::lerp(move.leftFrom, move.leftTo, share)};
        return false;
    });
    return found;
}

bool HandFinish::reaches(const glm::dvec3& tip, double widths) const {
    bool found = false;
    visitNear(tip, widths * (rounded_ + flat_), [&](const Move& move) {
        const glm::dvec3 there = nearestOnSegment(tip, move.from, move.to);
        found = glm::distance(tip, there) <= widths * rounded_ ||
                (flat_ > 0.0 && std::abs(tip.z - there.z) <= height_ &&
                 glm::distance(glm::dvec2(tip), glm::dvec2(there)) <= widths * (rounded_ + flat_));
        return found;
    });
    return found;
}

void heedHandStrokes(PlannedPass& planned, const PassRequest& request, const PassGround& ground, Progress& progress) {
    if (request.hand != HandStrokes::keepOff && request.hand != HandStrokes::blend) return;
    const SurfaceTrace trace(request, ground);
    const HandFinish hand(request, ground, trace, progress);
    if (hand.empty()) return;
    const double overlap = request.overlap > 0.0 ? request.overlap : usualOverlap;
    const double reach = ground.tool.cutter.diameter; // farther than anything that is finished
    const bool keepsOff = request.hand == HandStrokes::keepOff;
    std::vector<std::vector<TipLine>> lines(planned.strokes.size());
    std::vector<double> lost(lines.size(), 0.0);
    parallelFor(std::size_t{0}, lines.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        std::vector<Piece> pieces = piecesOf(divided(planned.strokes[i], handSpacing), [&](const glm::dvec3& tip) {
            return keepsOff ? hand.isDisturbedAt(tip) : hand.isFinishedAt(tip);
        });
        lines[i] = keepsOff ? besides(std::move(pieces), lost[i]) : blended(pieces, overlap, hand, reach, lost[i]);
    });
    planned.strokes.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        planned.leftToHand += lost[i];
        for (const TipLine& line : lines[i])
            if (line.size() > 1 && lengthOf(line) >= shortestPiece) planned.strokes.push_back(straightened(line));
    }
}

} // namespace burin

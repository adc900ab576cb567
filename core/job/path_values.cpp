// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/path_values.h"

#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "core/geometry/arc.h"
#include "core/geometry/segment.h"
#include "core/path/engagement_record.h"
#include "core/path/hand_interval.h"
#include "core/path/hand_trail.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr double drawnChord = 0.02; // mm, deviation of the pieces from an arc
constexpr double cutSampling = 0.5; // mm of a move between samples of the cut

struct QuantityRow {
    PathQuantity quantity;
    std::string_view id, unit;
    TextId title;
};
constexpr std::array rows{
    QuantityRow{PathQuantity::feed, "feed", "mm/min", BURIN_TEXT("PathQuantity", "Feed")},
    QuantityRow{PathQuantity::spindleSpeed, "spindle-speed", "1/min", BURIN_TEXT("PathQuantity", "Spindle speed")},
    QuantityRow{PathQuantity::height, "height", "mm", BURIN_TEXT("PathQuantity", "Height above zero")},
    QuantityRow{PathQuantity::removalRate, "removal-rate", "mm³/s", BURIN_TEXT("PathQuantity", "Removal rate")},
    QuantityRow{PathQuantity::force, "force", "N", BURIN_TEXT("PathQuantity", "Cutting force")},
    QuantityRow{PathQuantity::deviation, "deviation", "mm", BURIN_TEXT("PathQuantity", "Deviation from the recording")},
};

const QuantityRow& rowOf(PathQuantity quantity) noexcept {
    return *std::ranges::find(rows, quantity, &QuantityRow::quantity);
}

/// Returns the corners of a move after its start.
std::vector<glm::dvec3> cornersOf(const glm::dvec3& from, const PathPoint& to) {
    std::vector<glm::dvec3> corners{to.pose.tip};
    if (to.arc) flatten({from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise}, drawnChord, corners);
    return corners;
}

/// Calls `use(index of the point, from, corners)` for each feed move.
template <class Use>
void forEachFeedMove(const Path& path, const Use& use) {
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].kind != MoveKind::rapid)
            use(i, path.points[i - 1].pose.tip, cornersOf(path.points[i - 1].pose.tip, path.points[i]));
}

/// Returns pieces with one value for each move.
template <class ValueOf>
std::vector<ValuedPiece> byMove(const Path& path, const ValueOf& valueOf) {
    std::vector<ValuedPiece> pieces;
    forEachFeedMove(path, [&](std::size_t i, glm::dvec3 from, const std::vector<glm::dvec3>& corners) {
        const std::optional<double> value = valueOf(i, from, corners);
        for (const glm::dvec3& to : corners) pieces.push_back({std::exchange(from, to), to, value});
    });
    return pieces;
}

std::vector<ValuedPiece> heights(const Path& path, double zero) {
    std::vector<ValuedPiece> pieces = byMove(path, [](auto&&...) { return std::nullopt; });
    for (ValuedPiece& piece : pieces) piece.value = 0.5 * (piece.from.z + piece.to.z) - zero;
    return pieces;
}

/// The distance of the path from the motion of its source, move by move.
class Deviations {
public:
    Deviations(const Path& path, std::span<const SourceStrokes> sources) : path_(path), trail_(sources) {}

    std::optional<double> operator()(std::size_t i, const glm::dvec3& from,
                                     const std::vector<glm::dvec3>& corners) const {
        const Moment begin = momentOf(path_.points[i - 1]), end = momentOf(path_.points[i]);
        if (!hasMoment(path_.points[i - 1]) || !hasMoment(path_.points[i]) || begin.source != end.source)
            return std::nullopt;
        const std::span<const HandMark> marks = trail_.of(end.source);
        if (marks.empty()) return std::nullopt;
        const auto [low, high] = std::minmax(begin.tick, end.tick);
        double most = std::max(apart(marks, begin.tick, from), apart(marks, end.tick, corners.back()));
        for (auto mark = std::ranges::lower_bound(marks, low, {}, &HandMark::tick);
             mark != marks.end() && mark->tick <= high; ++mark)
            most = std::max(most, toMove(mark->tip, from, corners));
        return most;
    }

private:
    /// Returns the distance from the source's position at a tick, interpolated linearly between its marks.
    static double apart(std::span<const HandMark> marks, std::int64_t tick, const glm::dvec3& place) {
        const auto next = std::ranges::lower_bound(marks, tick, {}, &HandMark::tick);
        if (next == marks.end()) return glm::distance(place, marks.back().tip);
        if (next == marks.begin() || next->tick == tick) return glm::distance(place, next->tip);
        const HandMark& last = *(next - 1);
        return distanceToSegment(place, last.tip, next->tip);
    }
    static double toMove(const glm::dvec3& place, glm::dvec3 from, const std::vector<glm::dvec3>& corners) {
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& to : corners)
            least = std::min(least, distanceToSegment(place, std::exchange(from, to), to));
        return least;
    }

    const Path& path_;
    HandTrail trail_;
};

double loadOf(PathQuantity quantity, const MetInterval& met, const Path& path, const Tool& tool,
              const CuttingCoefficients& coefficients) {
    const PathPoint& point = path.points[met.move];
    if (!(met.length > 0.0) || !(met.reported > 0.0) || !(point.feed > 0.0)) return 0.0;
    const double period = met.length / point.feed * secondsPerMinute;
    if (quantity == PathQuantity::removalRate) return met.reported / period;
    const double edge = pi * tool.cutter.diameter * speedOf(path, point) / secondsPerMinute;
    if (!(edge > 0.0)) return 0.0;
    return cuttingForce(met.cut(), coefficients, spinningTool(tool, edge), ToolPose{met.from}, ToolPose{met.to}, period)
        .tangential;
}

/// Returns the removal rate or force of each interval; intervals without a cut have 0.
Result<std::vector<ValuedPiece>> loads(PathQuantity quantity, const MilledPath& milled,
                                       std::span<const MilledPath> before, const MillingContext& milling,
                                       Progress& progress) {
    const Path& path = milled.evaluated->path;
    std::vector<ValuedPiece> pieces;
    const auto cut = [&](RunVolume& stock) -> Result<void> {
        Result<std::vector<MetInterval>> record =
            recordEngagement(path.points, milled.tool, stock, cutSampling, progress);
        if (!record) return std::move(record).error();
        const CuttingCoefficients coefficients = cuttingCoefficients(stock.properties(), milled.tool.cutter.diameter);
        pieces.clear();
        for (const MetInterval& met : *record)
            pieces.push_back({met.from, met.to, loadOf(quantity, met, path, milled.tool, coefficients)});
        return {};
    };
    if (Result<void> lent = milling.stock->lend(before, cut, progress); !lent) return std::move(lent).error();
    return pieces;
}

Result<std::vector<ValuedPiece>> piecesOf(PathQuantity quantity, const MilledPath& milled,
                                          std::span<const MilledPath> before, std::span<const SourceStrokes> sources,
                                          const MillingContext& milling, Progress& progress) {
    const Path& path = milled.evaluated->path;
    switch (quantity) {
    case PathQuantity::feed:
        return byMove(path, [&](std::size_t i, auto&&...) { return std::optional(path.points[i].feed); });
    case PathQuantity::spindleSpeed:
        return byMove(path, [&](std::size_t i, auto&&...) { return std::optional(speedOf(path, path.points[i])); });
    case PathQuantity::height:
        return heights(path, milling.setup.workOffset.z);
    case PathQuantity::deviation:
        return byMove(path, Deviations(path, sources));
    case PathQuantity::removalRate:
    case PathQuantity::force:
        return loads(quantity, milled, before, milling, progress);
    }
    return std::vector<ValuedPiece>{};
}

} // namespace

std::string_view idOf(PathQuantity quantity) noexcept {
    return rowOf(quantity).id;
}

std::optional<PathQuantity> pathQuantityFromId(std::string_view id) noexcept {
    const auto found = std::ranges::find(rows, id, &QuantityRow::id);
    return found == rows.end() ? std::nullopt : std::optional(found->quantity);
}

TextId titleOf(PathQuantity quantity) noexcept {
    return rowOf(quantity).title;
}

std::string_view unitOf(PathQuantity quantity) noexcept {
    return rowOf(quantity).unit;
}

Result<PathValues> pathValues(PathQuantity quantity, const MilledPath& path, std::span<const MilledPath> before,
                              std::span<const SourceStrokes> sources, const MillingContext& milling,
                              Progress& progress) {
    Result<std::vector<ValuedPiece>> pieces = piecesOf(quantity, path, before, sources, milling, progress);
    if (!pieces) return std::move(pieces).error();
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", {}, {}};
    PathValues values{quantity, std::move(*pieces), 0.0, 0.0};
    bool any = false;
    for (const ValuedPiece& piece : values.pieces) {
        if (!piece.value) continue;
        values.low = any ? std::min(values.low, *piece.value) : *piece.value;
        values.high = any ? std::max(values.high, *piece.value) : *piece.value;
        any = true;
    }
    return values;
}

} // namespace burin

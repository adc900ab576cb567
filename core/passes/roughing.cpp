// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/passes/stroke_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double beyondStock = 1.0;  // mm between the cutter and the stock where a row begins
constexpr double tolerance = 1e-6;   // mm
constexpr double longestLink = 20.0; // mm within a level
constexpr double liftCost = 60.0;    // mm of cutting that one retract is worth

/// An interval of a row that is cut on one level.
struct Piece {
    double y = 0.0;
    double low = 0.0, high = 0.0; ///< mm, x of its ends
    bool done = false;
};

/// A possible start of a piece.
struct Entry {
    std::size_t piece = 0;
    bool atHigh = false;
    std::vector<glm::dvec3> link; ///< within the level; empty: retract
    double cost = std::numeric_limits<double>::infinity();
};

class Roughing {
public:
    Roughing(const ClearanceField& field, const Tool& tool, const RoughingRequest& request, WorkpieceHeights& heights)
        : field_(field), tool_(tool), request_(request), heights_(heights), writer_(heights, request.speeds) {
        if (request_.stepOver <= 0.0) request_.stepOver = 0.75 * tool.cutter.diameter;
        if (request_.levelDepth <= 0.0) request_.levelDepth = 1.25 * tool.cutter.diameter;
        finishingDepth_ = request_.finishingDepth;
        if (tool.maximumDepthOfCut > 0.0) finishingDepth_ = std::min(finishingDepth_, tool.maximumDepthOfCut);
        // The error of the field and a little more: the hand should pass the part, not be dragged along it.
        keep_ = request_.allowance + field.errorBound() + 0.02 * tool.cutter.radius();
    }

    RoughingPlan plan() {
        RoughingPlan result;
        result.levels = levels();
        layRows(result.levels);
        double above = heights_.stock().high.z;
        for (const double level : result.levels) {
            millLevel(level, above);
            above = level;
        }
        writer_.finish();
        result.points = writer_.take();
        return result;
    }

private:
    /// Equal steps from the top of the stock to the bottom.
    std::vector<double> levels() const {
        const double height = heights_.stock().high.z - request_.bottom;
        std::vector<double> result;
        if (height <= tolerance) return result;
        const int count = static_cast<int>(std::ceil(height / deepest() - tolerance));
        for (int i = 1; i <= count; ++i) result.push_back(heights_.stock().high.z - height * i / count);
        result.back() = request_.bottom;
        return result;
    }

    /// Below a level, a ball leaves stock that rises towards its rim; stock within the width of the shank must not
    /// reach it.
    double deepest() const {
        const Cutter& cutter = tool_.cutter;
        const double shank = std::min(0.5 * cutter.shankDiameter + lateralMargin(cutter), cutter.radius());
        const double flutes = usableFlutes(cutter);
        double depth = std::min(request_.levelDepth, std::max(flutes - heights_.riseAt(shank), 0.25 * flutes));
        if (tool_.maximumDepthOfCut > 0.0) depth = std::min(depth, tool_.maximumDepthOfCut);
        return depth;
    }

    void layRows(const std::vector<double>& levels) {
        const Box& stock = heights_.stock();
        const double reach = tool_.cutter.radius() + beyondStock;
        const int intervals = std::max(1, static_cast<int>(std::ceil(stock.size().y / request_.stepOver - tolerance)));
        for (int i = 0; i <= intervals; ++i) rows_.push_back(stock.low.y + stock.size().y * i / intervals);
        const double length = stock.size().x + 2.0 * reach;
        const int steps = static_cast<int>(std::ceil(length / heights_.raster()));
        for (int i = 0; i <= steps; ++i) places_.push_back(stock.low.x - reach + length * i / steps);
        reached_.resize(levels.empty() ? 1 : tier(levels.back()) + 1);
        for (std::size_t i = 0; i < reached_.size(); ++i)
            for (const double y : rows_)
                for (const double x : places_)
                    reached_[i].push_back(
                        lowestFeasibleHeight(field_, x, y, keepAt(i), writer_.travelLevel(), request_.bottom));
        findNearby();
    }

    /// How many flute lengths fit between the top of the stock and a level.
    std::size_t tier(double level) const {
        const double depth = heights_.stock().high.z - level - tolerance;
        return static_cast<std::size_t>(std::max(0.0, std::floor(depth / usableFlutes(tool_.cutter))));
    }

    /// Clearance from the part. Below a wall higher than the flutes, the shank passes what the levels above have left
    /// standing, so each such tier keeps a little more distance.
    double keepAt(std::size_t tier) const {
        return keep_ + static_cast<double>(tier) * (lateralMargin(tool_.cutter) + trembleMargin(tool_.cutter));
    }

    /// For each point, the lowest and the highest height that the tool reaches around it: in its row and the
    /// neighbouring rows, within a cutter's reach.
    void findNearby() {
        const int around = static_cast<int>(std::ceil((tool_.cutter.radius() + beyondStock) / heights_.raster()));
        const int rowCount = static_cast<int>(rows_.size()), placeCount = static_cast<int>(places_.size());
        lowestNearby_.assign(reached_[0].size(), std::numeric_limits<double>::infinity());
        highestNearby_.assign(reached_[0].size(), -std::numeric_limits<double>::infinity());
        for (int row = 0; row < rowCount; ++row)
            for (int place = 0; place < placeCount; ++place)
                for (int r = std::max(0, row - 1); r <= std::min(rowCount - 1, row + 1); ++r)
                    for (int p = std::max(0, place - around); p <= std::min(placeCount - 1, place + around); ++p) {
                        const auto index = static_cast<std::size_t>(row * placeCount + place);
                        const double reached = reached_[0][static_cast<std::size_t>(r * placeCount + p)];
                        lowestNearby_[index] = std::min(lowestNearby_[index], reached);
                        highestNearby_[index] = std::max(highestNearby_[index], reached);
                    }
    }

    /// Whether a level cuts at a point: the part lets the tool down to it, and either the finishing passes could not
    /// remove what would be left, or the shank would touch it when the tool works next to it.
    bool cuts(std::size_t row, std::size_t place, double level, double above) const {
        const std::size_t index = row * places_.size() + place;
        const double reached = reached_[tier(level)][index];
        if (reached > level + tolerance) return false;
        if (request_.nearPartOnly && highestNearby_[index] <= request_.bottom + tolerance) return false;
        const bool floor = reached <= request_.bottom + tolerance;
        const double finishingDepth = std::max(finishingDepth_, above - level - tolerance);
        const double tallest = usableFlutes(tool_.cutter) - tool_.cutter.cornerRadius;
        return floor || above - reached > finishingDepth || above - lowestNearby_[index] > tallest;
    }

    /// The y coordinate of a piece at a point of its row: that of the row, or slightly beside it where stock that no
    /// level above could remove stands so close that the shank would touch it because of the hand's tremor. NaN if
    /// there is none.
    double clearOfShank(std::size_t row, std::size_t place, double level) const {
        const double x = places_[place], y = rows_[row], step = 0.5 * lateralMargin(tool_.cutter);
        for (const double aside : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0}) {
            const glm::dvec3 tip(x, y + aside * step, level);
            if (heights_.safeHeight(tip) > level + tolerance) continue;
            if (aside == 0.0 || field_.at(tip).clearance >= keepAt(tier(level))) return tip.y;
        }
        return std::numeric_limits<double>::quiet_NaN();
    }

    /// The points of a row at which stock is left, extended by what the cutter needs to enter from the side.
    std::vector<bool> worthwhile(std::size_t row, double level) const {
        std::vector<bool> worth(places_.size(), !request_.restOnly);
        if (!request_.restOnly) return worth;
        const auto around = static_cast<std::size_t>((tool_.cutter.radius() + beyondStock) / heights_.raster());
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (!heights_.hasRest({places_[i], rows_[row], level})) continue;
            const std::size_t first = i > around ? i - around : 0, last = std::min(places_.size(), i + around + 1);
            std::fill(worth.begin() + static_cast<std::ptrdiff_t>(first),
                      worth.begin() + static_cast<std::ptrdiff_t>(last), true);
        }
        return worth;
    }

    std::vector<Piece> pieces(double level, double above) const {
        std::vector<Piece> result;
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            bool open = false;
            const std::vector<bool> worth = worthwhile(row, level);
            for (std::size_t i = 0; i < places_.size(); ++i) {
                const double y = worth[i] && cuts(row, i, level, above) ? clearOfShank(row, i, level)
                                                                        : std::numeric_limits<double>::quiet_NaN();
                if (!std::isfinite(y)) {
                    open = false;
                    continue;
                }
                if (!open || y != result.back().y) result.push_back({y, places_[i], places_[i], false});
                result.back().high = places_[i];
                open = true;
            }
        }
        std::erase_if(result, [&](const Piece& piece) { return piece.high - piece.low < heights_.raster(); });
        return result;
    }

    void millLevel(double level, double above) {
        std::vector<Piece> open = pieces(level, above);
        for (std::size_t left = open.size(); left > 0; --left) {
            const Entry entry = cheapestEntry(open, level);
            Piece& piece = open[entry.piece];
            const double y = piece.y;
            const glm::dvec3 low(piece.low, y, level), high(piece.high, y, level);
            if (entry.link.empty()) writer_.rampInto(entry.atHigh ? high : low, entry.atHigh ? low : high);
            for (const glm::dvec3& tip : entry.link) writer_.cutTo(tip);
            writer_.cutTo(entry.atHigh ? low : high);
            cameFrom_ = entry.atHigh ? 1.0 : -1.0;
            piece.done = true;
        }
    }

    Entry cheapestEntry(const std::vector<Piece>& open, double level) const {
        Entry best;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (open[i].done) continue;
            for (const bool atHigh : {false, true}) {
                Entry entry = entryAt(open[i], atHigh, level, best.cost);
                entry.piece = i;
                if (entry.cost < best.cost) best = std::move(entry);
            }
        }
        return best;
    }

    Entry entryAt(const Piece& piece, bool atHigh, double level, double bestCost) const {
        const glm::dvec3 end(atHigh ? piece.high : piece.low, piece.y, level);
        Entry entry;
        entry.atHigh = atHigh;
        const double into = std::max(0.0, heights_.freeTip(end.x, end.y) - level);
        if (writer_.empty()) { // the very first piece: from the low corner
            entry.cost = glm::distance(glm::dvec2(end), glm::dvec2(places_.front(), rows_.front())) + 3.0 * into;
            return entry;
        }
        const double distance = glm::distance(glm::dvec2(writer_.tip()), glm::dvec2(end));
        entry.cost = liftCost + distance + 3.0 * into; // plunging into stock is slow and hard on the cutter
        if (distance > longestLink || distance > bestCost) return entry;
        std::vector<glm::dvec3> link = linkTo(end, atHigh, piece);
        if (link.empty()) return entry;
        entry.cost = wayLength(link);
        entry.link = std::move(link);
        return entry;
    }

    double wayLength(const std::vector<glm::dvec3>& link) const {
        double length = 0.0;
        glm::dvec3 from = writer_.tip();
        for (const glm::dvec3& to : link) {
            length += glm::distance(from, to);
            from = to;
        }
        return length;
    }

    /// A path within the level to the end of a piece: straight, or first back along both rows, where they have cleared
    /// room for the shank. Empty if there is none.
    std::vector<glm::dvec3> linkTo(const glm::dvec3& end, bool atHigh, const Piece& piece) const {
        const glm::dvec3& tip = writer_.tip();
        const bool sameLevel = std::abs(tip.z - end.z) <= tolerance;
        const bool straightDown = glm::distance(glm::dvec2(tip), glm::dvec2(end)) <= tolerance;
        if (!sameLevel && !straightDown) return {};
        if (straightDown && writer_.depthAt(end) > plungeDepth) return {}; // enters along a ramp
        if (std::vector<glm::dvec3> straight{end}; allows(straight)) return straight;
        const double inward = atHigh ? -1.0 : 1.0;
        if (!sameLevel || inward != cameFrom_) return {};
        for (const double share : {0.5, 1.0, 2.0}) {
            const double outer = inward > 0.0 ? std::max(tip.x, end.x) : std::min(tip.x, end.x);
            const double x = outer + inward * share * tool_.cutter.radius();
            if (x < piece.low || x > piece.high) return {};
            std::vector<glm::dvec3> back{{x, tip.y, tip.z}, {x, end.y, end.z}, end};
            if (allows(back)) return back;
        }
        return {};
    }

    bool allows(const std::vector<glm::dvec3>& link) const {
        glm::dvec3 from = writer_.tip();
        for (const glm::dvec3& to : link) {
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / heights_.raster())));
            for (int i = 0; i <= steps; ++i) {
                const glm::dvec3 tip = glm::mix(from, to, static_cast<double>(i) / steps);
                if (!(field_.at(tip).clearance >= keepAt(tier(tip.z)) - 1e-3)) return false;
                if (heights_.safeHeight(tip) > tip.z + tolerance) return false;
            }
            from = to;
        }
        return true;
    }

    const ClearanceField& field_;
    const Tool& tool_;
    RoughingRequest request_;
    WorkpieceHeights& heights_;
    StrokeWriter writer_;
    double keep_ = 0.0;                        ///< mm of clearance
    double finishingDepth_ = 0.0;              ///< mm, limited by the tool
    std::vector<double> rows_;                 ///< y
    std::vector<double> places_;               ///< x of the samples of a row
    std::vector<std::vector<double>> reached_; ///< by tier, row and point: how far down the tip may go
    std::vector<double> lowestNearby_;         ///< by row and point
    std::vector<double> highestNearby_;        ///< by row and point
    double cameFrom_ = 0.0;                    ///< direction along x from the end of the last piece back into it
};

} // namespace

Result<RoughingPlan> planRoughing(const ClearanceField& field, const Tool& tool, const RoughingRequest& request,
                                  WorkpieceHeights& heights) {
    if (Result<void> valid = checkSpeeds(request.speeds); !valid) return valid.error();
    const Cutter& cutter = tool.cutter;
    if (Result<void> valid = checkAbove({{"cutter diameter", cutter.diameter}, {"flute length", cutter.fluteLength}});
        !valid)
        return valid.error();
    if (Result<void> valid = checkNotBelow({{"allowance", request.allowance},
                                            {"step-over", request.stepOver},
                                            {"level depth", request.levelDepth},
                                            {"finishing depth", request.finishingDepth}});
        !valid)
        return valid.error();
    if (!std::isfinite(request.bottom))
        return Error{ErrorCode::argumentInvalid, "bottom", formatShortest(request.bottom), "a finite number"};
    return Roughing(field, tool, request, heights).plan();
}

} // namespace burin

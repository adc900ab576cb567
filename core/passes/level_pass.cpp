// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/level_pass.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/passes/bounded_cut.h"
#include "core/passes/holding_tabs.h"
#include "core/passes/level_order.h"
#include "core/passes/tip_raster.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double tolerance = 1e-6;     // mm
constexpr double startHeight = 1.0;    // mm above stock and part at which tips start to come down
constexpr double beyondStock = 1.0;    // mm between cutter and stock beyond which a loop has nothing to cut
constexpr double insetShare = 0.05;    // of the radius: stock that only the rim of the cutter would touch is ignored
constexpr double longestGap = 1.0;     // diameters of a loop without stock that are traversed at feed and not by a link
constexpr double seedHalfWidth = 0.01; // mm
constexpr double loopTolerance = 0.01; // mm between a loop's chords and its arcs
constexpr int mostLoops = 100'000;     // of one level, nested
constexpr double sharpTurn = 20.0;     // degrees: a cutter reaches far enough into a flatter corner
constexpr double mostAway = 2.0;       // radii from the centre of the cutter to a corner: 60 degrees between its sides
constexpr double atCorner = 0.05;      // mm between the point that a dogbone reaches and the corner of the area
// of the cutter's diameter squared: smaller level faces get no level of their own
constexpr double levelFaceShare = 0.25;

/// mm
double loopStepOf(const PassRequest& request, const PassGround& ground) noexcept {
    if (request.stepOver > 0.0) return request.stepOver;
    return ground.loopStep > 0.0 ? ground.loopStep : usualRoughStep * ground.tool.cutter.diameter;
}

class LevelPlanner {
public:
    LevelPlanner(const PassRequest& request, const PassGround& ground, Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , heights_(ground.stock, ground.tool.cutter, ground.coarseness)
        , stepOver_(loopStepOf(request, ground))
        // Above the whole part, the error of the field is no reason to keep away from it.
        , keep_(request.allowance + (request.kind == PassKind::face ? -1.0 : 1.0) * ground.field->errorBound())
        , top_(request.top.value_or(ground.stock.high.z))
        , bottom_(bottomOf(request, ground))
        , tabs_(request, ground.tool.cutter.diameter, bottom_, heights_.raster()) {
        heights_.lowerTo(ground.standing);
    }

    Result<PlannedPass> plan() {
        if (stepOver_ > ground_.tool.cutter.radius() + tolerance)
            return Error{ErrorCode::argumentInvalid, "step_over_mm", formatShortest(stepOver_),
                         "at most the cutter's radius, " + formatShortest(ground_.tool.cutter.radius()) + " mm"};
        if (!(bottom_ < top_))
            return Error{ErrorCode::argumentInvalid, "bottom_mm", formatShortest(bottom_),
                         "below the top of what is to be taken away, " + formatShortest(top_) + " mm"};
        const TipRaster raster = rasterOf();
        const std::vector<double> levels = levelsOf(raster);
        if (request_.kind == PassKind::profile && request_.tabs > 0) tabs_.place(nearStock(roomOn(raster, bottom_)));
        for (std::size_t i = 0; i < levels.size(); ++i) {
            progress_.report(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(levels.size()));
            const double above = i == 0 ? top_ : levels[i - 1];
            millLevel(raster, levels[i], above - levels[i]);
            millStairs(raster, above, levels[i]);
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
        }
        return std::move(planned_);
    }

private:
    static double bottomOf(const PassRequest& request, const PassGround& ground) {
        if (request.bottom) return *request.bottom;
        const Box part = ground.part.bounds();
        if (part.empty()) return ground.stock.low.z;
        return request.kind == PassKind::face ? part.high.z + request.allowance : part.low.z;
    }

    TipRaster rasterOf() {
        const double reach = ground_.tool.cutter.radius() + beyondStock + heights_.raster();
        const PlanBounds bounds{glm::dvec2(ground_.stock.low) - reach, glm::dvec2(ground_.stock.high) + reach};
        progress_.report(0.0);
        return {*ground_.field,
                bounds,
                heights_.raster(),
                keep_,
                std::max(top_, ground_.part.bounds().high.z) + startHeight,
                bottom_,
                progress_};
    }

    /// Equal steps between the level faces, descending.
    std::vector<double> levelsOf(const TipRaster& raster) const {
        std::vector<double> stops;
        const double diameter = ground_.tool.cutter.diameter;
        for (const double face : raster.levelFaces(levelFaceShare * diameter * diameter))
            if (face < top_ - tolerance && face > bottom_ + tolerance) stops.push_back(face);
        stops.push_back(bottom_);
        std::vector<double> levels;
        double above = top_;
        for (const double stop : stops) {
            const int count = std::max(1, static_cast<int>(std::ceil((above - stop) / levelDepth() - tolerance)));
            for (int i = 1; i <= count; ++i) levels.push_back(above + (stop - above) * i / count);
            above = stop;
        }
        return levels;
    }

    /// Reduces the steps between two levels by lower ones, from below, so that each removes as little as possible.
    void millStairs(const TipRaster& raster, double above, double level) {
        if (request_.kind != PassKind::levels) return;
        const double height = request_.stairs > 0.0 ? request_.stairs : usualStairs * ground_.tool.cutter.diameter;
        const int count = static_cast<int>(std::ceil((above - level) / height - tolerance));
        for (int i = 1; i < count && !progress_.cancelled(); ++i)
            millLevel(raster, level + (above - level) * i / count, std::nullopt);
    }

    double levelDepth() const {
        double depth = request_.levelDepth > 0.0 ? request_.levelDepth : ground_.levelDepth;
        if (ground_.tool.maximumDepthOfCut > 0.0) depth = std::min(depth, ground_.tool.maximumDepthOfCut);
        return std::min(depth, usableFlutes(ground_.tool.cutter));
    }

    /// The region in which the tip may be on a level, and from which loops start at even distances.
    PlanRegion roomOn(const TipRaster& raster, double level) const {
        const double radius = ground_.tool.cutter.radius();
        const PlanRegion blocked = cleaned(raster.blockedAt(level), loopTolerance);
        if (request_.kind == PassKind::profile) {
            if (request_.area.empty()) return without(frame(), blocked);
            const PlanRegion room = request_.inside
                                        ? grown(request_.area, -radius - request_.allowance)
                                        : without(frame(), grown(request_.area, radius + request_.allowance));
            return without(room, blocked);
        }
        if (request_.kind == PassKind::pocket)
            return without(grown(request_.area, -radius - request_.allowance), blocked);
        if (!request_.area.empty()) return without(request_.area, blocked);
        // Where the part is nowhere near, loops go around the middle of the stock.
        return without(frame(), blocked.empty() ? middleOfStock() : blocked);
    }

    double frameWidth() const noexcept {
        return 3.0 * glm::length(glm::dvec2(ground_.stock.size())) + 10.0 * ground_.tool.cutter.diameter;
    }
    /// So far around the stock that its inset never matters.
    PlanRegion frame() const {
        const double away = frameWidth();
        return rectangle(glm::dvec2(ground_.stock.low) - away, glm::dvec2(ground_.stock.high) + away);
    }

    PlanRegion middleOfStock() const {
        const glm::dvec2 size(ground_.stock.size()), centre(ground_.stock.centre());
        const glm::dvec2 half = 0.5 * (size - std::min(size.x, size.y)) + seedHalfWidth;
        return rectangle(centre - half, centre + half);
    }

    bool isNearStock(const PlanRing& ring) const {
        const double reach = ground_.tool.cutter.diameter + beyondStock;
        const glm::dvec2 low = glm::dvec2(ground_.stock.low) - reach, high = glm::dvec2(ground_.stock.high) + reach;
        return std::ranges::any_of(ring, [&](const glm::dvec2& place) {
            return place.x > low.x && place.y > low.y && place.x < high.x && place.y < high.y;
        });
    }

    PlanRegion nearStock(PlanRegion room) const {
        std::erase_if(room.rings, [&](const PlanRing& ring) { return !isNearStock(ring); });
        return room;
    }

    /// Adds a move into each inner corner of the area and back, until the cutter's edge reaches the corner, so that an
    /// object with a square corner fits in. Corners where the part is in the way, and those of less than 60 degrees,
    /// whose sides the move would cut away, stay round. @param ring with the free region to its left
    PlanRing withDogbones(const PlanRing& ring, double level) const {
        const double radius = ground_.tool.cutter.radius() + request_.allowance;
        PlanRing bones;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2& here = ring[i];
            bones.push_back(here);
            const glm::dvec2 in = here - ring[(i + ring.size() - 1) % ring.size()];
            const glm::dvec2 out = ring[(i + 1) % ring.size()] - here;
            const double turn = std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out));
            if (!(turn > glm::radians(sharpTurn))) continue; // a left turn: the corner lies to the right
            const double away = radius / std::cos(0.5 * turn);
            if (away > mostAway * radius + tolerance) continue;
            const glm::dvec2 back = glm::normalize(glm::normalize(in) - glm::normalize(out));
            const glm::dvec2 reached = here + (away - radius) * back;
            if (isCornerOfArea(here + away * back) && ground_.field->at({reached, level}).clearance >= keep_)
                bones.insert(bones.end(), {reached, here});
        }
        return bones;
    }

    bool isCornerOfArea(const glm::dvec2& place) const {
        return std::ranges::any_of(request_.area.rings, [&](const PlanRing& ring) {
            return std::ranges::any_of(
                ring, [&](const glm::dvec2& corner) { return glm::distance(corner, place) < atCorner; });
        });
    }

    /// The parts of loops that remove stock, with their number of steps from the border of the region.
    /// @param stairs stock is left only next to the part: stop at the first loop that removes nothing
    std::vector<LevelRun> runsIn(const PlanRegion& room, double level, bool stairs) {
        std::vector<LevelRun> runs;
        const int most = request_.kind == PassKind::profile ? 1 : mostLoops;
        for (int step = 0; step < most && !progress_.cancelled(); ++step) {
            const std::size_t before = runs.size();
            bool near = false;
            // Each loop is offset from the border itself: offsetting the previous loop would accumulate errors.
            for (PlanPiece& piece : piecesOf(step == 0 ? room : grown(room, -step * stepOver_, loopTolerance))) {
                piece.holes.push_back(std::move(piece.border)); // both have the free region on their left
                for (PlanRing& ring : piece.holes) {
                    if (!isNearStock(ring)) continue;
                    near = true;
                    if (request_.dogbones && step == 0) ring = withDogbones(ring, level);
                    addRuns({std::move(ring), step}, level, runs);
                }
            }
            if (!near || (stairs && runs.size() == before)) break;
        }
        return runs;
    }

    /// @param depth mm of the level, whose cuts are to be no wider than a step-over; empty: of steps on slopes, which
    /// are so low that their width doesn't matter
    void millLevel(const TipRaster& raster, double level, std::optional<double> depth) {
        const PlanRegion room = roomOn(raster, level);
        std::vector<LevelRun> runs = runsIn(room, level, !depth);
        std::optional<RowedRegion> rowed;
        std::optional<BoundedCut> bounded;
        if (depth && request_.kind != PassKind::profile && !runs.empty()) {
            rowed.emplace(room, ground_.stock.low.y - frameWidth(), ground_.stock.high.y + frameWidth());
            const auto hasRoom = [&](const glm::dvec2& centre, double circle) {
                return mayCircle(*rowed, {centre, level}, circle);
            };
            const double most = stepOver_ * std::max(1.0, levelDepth() / *depth);
            bounded.emplace(
                BoundedCut::Values{level, *depth, ground_.tool.cutter.radius(), stepOver_, most, heights_.raster()},
                heights_, hasRoom);
        }
        LevelOrder order(std::move(runs), stepOver_);
        bool open = false;
        while (std::optional<LevelRun> run = order.next(tip_ ? std::optional(glm::dvec2(*tip_)) : std::nullopt)) {
            if (bounded && run->step > 0 && !bounded->cuts(run->places)) continue; // circles have cut it
            TipLine tips = tabs_.over(*run, level);
            const bool joined = open && mayGo(*tip_, tips.front());
            if (bounded && !joined && run->closed) {
                const std::size_t entry = bounded->entryOf(run->places);
                *run = begunAt(std::move(*run), entry);
            }
            if (bounded && joined) run->places.insert(run->places.begin(), glm::dvec2(*tip_));
            if (bounded) tips = bounded->along(run->places, joined);
            if (!joined) planned_.strokes.emplace_back();
            open = true;
            glm::dvec3 before = joined ? *tip_ : tips.front();
            for (const glm::dvec3& tip : tips) {
                heights_.cut(before, tip);
                planned_.strokes.back().push_back(tip);
                before = tip;
            }
            tip_ = before;
        }
    }

    /// Adds the parts of a loop on which the flutes remove stock and nothing else touches it.
    void addRuns(const LevelLoop& loop, double level, std::vector<LevelRun>& runs) {
        const std::vector<glm::dvec2> places = spaced(loop.ring, heights_.raster());
        const std::size_t count = places.size();
        std::vector<LevelPlace> work(count, LevelPlace::idle);
        const double inset = insetShare * ground_.tool.cutter.radius();
        const double least = std::min(WorkpieceHeights::leastRest, 0.5 * levelDepth());
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2& place = places[i];
            if (heights_.safeHeight({place, level}) > level + tolerance) {
                work[i] = LevelPlace::forbidden;
                planned_.leftOut += glm::distance(place, places[(i + 1) % count]);
            } else if (heights_.freeTip(place.x, place.y, inset) > level + least) {
                work[i] = LevelPlace::cuts;
            }
        }
        const auto gap = static_cast<std::size_t>(longestGap * ground_.tool.cutter.diameter / heights_.raster());
        for (LevelRun& run : runsAlong(places, std::move(work), gap)) {
            run.step = loop.step;
            runs.push_back(std::move(run));
        }
    }

    /// Whether the tip may go round a circle in the room of its level.
    bool mayCircle(const RowedRegion& room, const glm::dvec3& centre, double radius) const {
        constexpr int looks = 16;
        constexpr double slack = 1e-3; // mm
        for (int i = 0; i < looks; ++i) {
            const double angle = 2.0 * pi * i / looks;
            // Slightly within: it touches the border of the room where a run follows that.
            const glm::dvec2 aside = 0.98 * radius * glm::dvec2(std::cos(angle), std::sin(angle));
            const glm::dvec3 tip = centre + glm::dvec3(aside, 0.0);
            if (!room.holds(glm::dvec2(tip)) || !(ground_.field->at(tip).clearance >= keep_ - slack)) return false;
        }
        const bool reaches = ground_.stock.high.z > centre.z + usableFlutes(ground_.tool.cutter);
        return !reaches || !(heights_.safeHeight(centre, radius) > centre.z + tolerance);
    }

    /// Whether the tool may move straight within its level: over up to three step-overs, or where no stock is left.
    bool mayGo(const glm::dvec3& from, const glm::dvec3& to) const {
        const double length = glm::distance(from, to), reach = 2.0 * ground_.tool.cutter.diameter;
        if (from.z != to.z || length > reach) return false;
        const bool cuts = length <= 3.0 * stepOver_;
        const int steps = std::max(1, static_cast<int>(std::ceil(length / heights_.raster())));
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec3 tip = glm::mix(from, to, static_cast<double>(i) / steps);
            if (!(ground_.field->at(tip).clearance >= keep_ - 1e-3)) return false;
            if (!request_.area.empty() && request_.kind == PassKind::levels && !holds(request_.area, glm::dvec2(tip)))
                return false;
            if (heights_.safeHeight(tip) > tip.z + tolerance) return false;
            if (!cuts && heights_.freeTip(tip.x, tip.y) > tip.z + tolerance) return false;
        }
        return true;
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    WorkpieceHeights heights_;
    double stepOver_, keep_, top_, bottom_;
    HoldingTabs tabs_;
    PlannedPass planned_;
    std::optional<glm::dvec3> tip_;
};

} // namespace

Result<PlannedPass> planLevels(const PassRequest& request, const PassGround& ground, Progress& progress) {
    return LevelPlanner(request, ground, progress).plan();
}

} // namespace burin

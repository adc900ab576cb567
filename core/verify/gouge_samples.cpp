// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/gouge_samples.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/geometry/piece_minimum.h"
#include "core/verify/gouge.h"

#include <algorithm>
#include <optional>

namespace burin {

namespace {

constexpr std::size_t samplesPerBatch = 256; // samples
constexpr std::size_t longestInterval = 16;  // samples
constexpr double straight = 5e-4;            // mm: samples of an interval are no farther from its chord
/// Gouges are reported exactly, positive clearances to 1e-4 mm: those are neither reported nor ranked more finely.
constexpr ClearanceTolerance answers{1e-4, 0.0, 1e-8};
constexpr double leastSearch = 0.5, greatestSearch = 8.0; // mm: beyond this distance from the part it is not measured

struct Place {
    std::uint32_t move = 0;
    glm::dvec3 tip{0.0};
};

/// Samples on one chord, made with one tool.
struct Interval {
    std::size_t first = 0, end = 0; ///< index in the batch
    double beside = 0.0;            ///< mm: largest distance from the chord
    double reach = 0.0;             ///< mm: largest distance from the middle sample
    ToolClearance clearance;        ///< of the middle sample, if it is near

    std::size_t middle() const noexcept { return first + (end - first) / 2; }
};

/// Consecutive samples, and the intervals of them that come near the part.
struct Batch {
    std::vector<Place> places;
    std::vector<Interval> near;
    std::vector<GougeSample> worst;
    std::size_t finishSamples = 0, onPart = 0;
};

double besideChord(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - from, way) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - from - share * way);
}

/// The longest sequence of samples from `first` on that lie on one chord.
Interval intervalFrom(std::size_t first, const std::vector<Place>& places, const std::vector<ToolMove>& moves) {
    Interval interval{first, first + 1, 0.0, 0.0, {}};
    const std::size_t most = std::min(first + longestInterval, places.size());
    const std::uint16_t tool = moves[places[first].move].tool;
    for (std::size_t last = first + 1; last < most && moves[places[last].move].tool == tool; ++last) {
        double beside = 0.0;
        for (std::size_t i = first + 1; i < last && beside <= straight; ++i)
            beside = std::max(beside, besideChord(places[i].tip, places[first].tip, places[last].tip));
        if (beside > straight) break;
        interval.end = last + 1;
        interval.beside = beside;
    }
    const glm::dvec3& middle = places[interval.middle()].tip;
    for (std::size_t i = interval.first; i < interval.end; ++i)
        interval.reach = std::max(interval.reach, glm::length(places[i].tip - middle));
    return interval;
}

/// Queries the clearance of a tool, pose after pose; starts anew with another tool.
class Asking {
public:
    Asking(const MeshDistance& part, std::span<const std::vector<RevolvedPiece>> stacks)
        : part_(part), stacks_(stacks) {}

    void take(std::uint16_t tool) {
        if (asker_ && tool == tool_) return;
        asker_.emplace(part_, stacks_[tool]);
        tool_ = tool;
        spare_ = -1.0;
    }
    /// Whether the tips queried so far make certain that no tip within `reach` of this one is near the part.
    bool isFar(const glm::dvec3& tip, double reach) const noexcept {
        return glm::length(tip - last_) + reach <= spare_;
    }
    ToolClearance ask(const glm::dvec3& tip, double reach) {
        const double within = std::max(within_, reach + 2.0 * onPartDistance);
        const ToolClearance found = asker_->ask(tip, within, answers);
        last_ = tip;
        spare_ = found.clearance - onPartDistance;
        within_ = found.clearance < within ? leastSearch : std::min(2.0 * within_, greatestSearch);
        return found;
    }
    bool keeps(const glm::dvec3& from, const glm::dvec3& to, double clearance) noexcept {
        return asker_->keeps(from, to, clearance);
    }

private:
    const MeshDistance& part_;
    std::span<const std::vector<RevolvedPiece>> stacks_;
    std::optional<ClearanceAsker> asker_;
    std::uint16_t tool_ = 0;
    glm::dvec3 last_{0.0};
    double spare_ = -1.0, within_ = leastSearch; // mm: radius around `last_` without anything near; search distance
};

/// Samples one batch after the other.
class Sampler {
public:
    Sampler(const std::vector<ToolMove>& moves, std::span<const Tool> tools, std::span<const ShrunkOutline> outlines,
            const VerifyRequest& request)
        : moves_(moves), outlines_(outlines), part_(*request.part), cuttingFeed_(tools.size()) {
        for (const Tool& tool : tools) {
            stacks_.push_back(pieces(tool.cutter));
            flutes_.push_back(flutePieces(tool.cutter));
        }
        for (const ToolMove& move : moves) // plunges are slower than the cutting feed
            if (!move.rapid) cuttingFeed_[move.tool] = std::max(cuttingFeed_[move.tool], move.feed);
    }

    /// Finds the intervals that come near the part, by their middles.
    Batch begin(const MoveSamples& samples, std::size_t first, std::size_t end) const {
        Batch batch;
        batch.places.reserve(end - first);
        samples.forEach(first, end, [&](std::uint32_t move, const glm::dvec3& tip) {
            batch.places.push_back({move, tip});
            if (isFinishing({move, tip})) ++batch.finishSamples;
        });
        Asking asking(part_, stacks_);
        for (std::size_t at = 0; at < batch.places.size();) {
            Interval interval = intervalFrom(at, batch.places, moves_);
            at = interval.end;
            const Place& middle = batch.places[interval.middle()];
            asking.take(toolOf(middle));
            if (asking.isFar(middle.tip, interval.reach)) continue;
            interval.clearance = asking.ask(middle.tip, interval.reach);
            if (!asking.isFar(middle.tip, interval.reach)) batch.near.push_back(interval);
        }
        if (batch.near.empty()) batch.places = {};
        return batch;
    }

    /// Finds all samples of the batch with a clearance below `limit`, mm, and those that touch the part.
    void finish(Batch& batch, double limit) const {
        Asking asking(part_, stacks_);
        for (const Interval& interval : batch.near) {
            asking.take(toolOf(batch.places[interval.middle()]));
            if (interval.clearance.clearance > limit)
                divide(batch, interval, interval.first, interval.end, limit, asking);
            else
                judgeEach(batch, interval.first, interval.end, asking);
        }
        batch.places = {}; // long programs have many
    }

private:
    /// Examines an interval as a whole, then by halves, then sample by sample.
    void divide(Batch& batch, const Interval& interval, std::size_t first, std::size_t end, double limit,
                Asking& asking) const {
        const glm::dvec3 &from = batch.places[first].tip, &to = batch.places[end - 1].tip;
        if (interval.clearance.clearance - answers.ordinary - interval.reach >= limit ||
            asking.keeps(from, to, limit + interval.beside)) {
            countOnPart(batch, interval, first, end, asking);
        } else if (end - first <= 2) {
            judgeEach(batch, first, end, asking);
        } else {
            const std::size_t half = first + (end - first) / 2;
            divide(batch, interval, first, half, limit, asking);
            divide(batch, interval, half, end, limit, asking);
        }
    }
    void judgeEach(Batch& batch, std::size_t first, std::size_t end, Asking& asking) const {
        for (std::size_t i = first; i < end; ++i) judge(batch, batch.places[i], asking);
    }
    /// Samples that stay clear of the part may still touch it, if they are near a point met by the middle of their
    /// interval.
    void countOnPart(Batch& batch, const Interval& interval, std::size_t first, std::size_t end, Asking& asking) const {
        for (std::size_t i = first; i < end; ++i) {
            const Place& place = batch.places[i];
            if (!isFinishing(place)) continue;
            if (touchesFlutes(place, interval.clearance.meshPoint))
                ++batch.onPart;
            else
                judge(batch, place, asking);
        }
    }

    void judge(Batch& batch, const Place& place, Asking& asking) const {
        if (asking.isFar(place.tip, 0.0)) return;
        const ToolClearance found = asking.ask(place.tip, 0.0);
        if (found.clearance > onPartDistance) return;
        batch.worst.push_back({place.move, place.tip, found});
        if (isFinishing(place) && isByFlutes(found, place)) ++batch.onPart;
    }

    std::uint16_t toolOf(const Place& place) const noexcept { return moves_[place.move].tool; }
    bool isFinishing(const Place& place) const noexcept {
        const ToolMove& move = moves_[place.move];
        return !move.rapid && move.startKnown && move.feed >= cuttingFeed_[move.tool] &&
               outlines_[move.tool].contains(place.tip.x, place.tip.y);
    }
    bool touchesFlutes(const Place& place, const glm::dvec3& point) const noexcept {
        return std::ranges::any_of(flutes_[toolOf(place)], [&](const RevolvedPiece& piece) {
            return PlacedPiece(piece, {place.tip, {0.0, 0.0, 1.0}}).at(point).distance <= onPartDistance;
        });
    }
    bool isByFlutes(const ToolClearance& found, const Place& place) const {
        const std::vector<RevolvedPiece>& flutes = flutes_[toolOf(place)];
        if (found.piece < flutes.size()) return true;
        const ToolPose pose{place.tip, {0.0, 0.0, 1.0}};
        return part_.clearance(flutes, pose, 2.0 * onPartDistance).clearance <= onPartDistance;
    }

    const std::vector<ToolMove>& moves_;
    std::span<const ShrunkOutline> outlines_;
    const MeshDistance& part_;
    std::vector<std::vector<RevolvedPiece>> stacks_, flutes_;
    std::vector<double> cuttingFeed_;
};

/// Clearance of the worst of the middles, mm: samples farther from the part are neither deeper than the tolerance nor
/// among the requested number of deepest ones.
double limitOf(const std::vector<Batch>& batches, std::size_t worst, double tolerance) {
    std::vector<double> clearances;
    for (const Batch& batch : batches)
        for (const Interval& interval : batch.near) clearances.push_back(interval.clearance.clearance);
    if (clearances.size() < worst) return onPartDistance;
    const auto last = clearances.begin() + static_cast<std::ptrdiff_t>(worst) - 1;
    std::nth_element(clearances.begin(), last, clearances.end());
    return std::max(std::min(*last, onPartDistance), -tolerance);
}

} // namespace

NearSamples nearSamples(const std::vector<ToolMove>& moves, const MoveSamples& places, std::span<const Tool> tools,
                        std::span<const ShrunkOutline> outlines, const VerifyRequest& request, std::size_t worst,
                        Progress& progress) {
    const Sampler sampler(moves, tools, outlines, request);
    std::vector<Batch> batches((places.count() + samplesPerBatch - 1) / samplesPerBatch);
    ParallelProgress shared(progress, 2 * batches.size());
    const auto forEachBatch = [&](const auto& work) {
        parallelFor(std::size_t{0}, batches.size(), [&](std::size_t i) {
            if (progress.cancelled()) return;
            work(i);
            shared.add();
        });
    };
    forEachBatch([&](std::size_t i) {
        batches[i] = sampler.begin(places, i * samplesPerBatch, std::min((i + 1) * samplesPerBatch, places.count()));
    });
    const double limit = limitOf(batches, worst, request.gougeTolerance);
    forEachBatch([&](std::size_t i) { sampler.finish(batches[i], limit); });
    NearSamples near;
    for (Batch& batch : batches) {
        near.worst.insert(near.worst.end(), batch.worst.begin(), batch.worst.end());
        near.finishSamples += batch.finishSamples;
        near.onPart += batch.onPart;
    }
    return near;
}

} // namespace burin

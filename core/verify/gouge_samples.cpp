// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/gouge_samples.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/geometry/piece_minimum.h"
#include "core/geometry/upright.h"
#include "core/verify/gouge.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t longestInterval = 16; // samples
constexpr double straight = 5e-4;           // mm: samples of an interval are no farther from its chord
/// Gouges are reported exactly, positive clearances to 1e-4 mm: those are neither reported nor ranked more finely.
constexpr ClearanceTolerance answers{1e-4, 0.0, 1e-8};
constexpr double leastSearch = 0.5, greatestSearch = 8.0; // mm: beyond this distance from the part it is not measured
/// mm: limits of the search are multiples of this, so that a change of a few samples seldom changes them.
constexpr double limitSteps = 1.0 / 2048.0;

struct Place {
    std::uint32_t move = 0;
    ToolPose pose;

    bool tilted() const noexcept { return !isUpright(pose.axis); }
};

} // namespace

/// Samples on one chord, made with one tool.
struct SampleInterval {
    std::size_t first = 0, end = 0; ///< index in the batch
    double beside = 0.0;            ///< mm: largest distance from the chord
    double reach = 0.0;             ///< mm: largest distance from the middle sample
    ToolClearance clearance;        ///< of the middle sample, if it is near

    std::size_t middle() const noexcept { return first + (end - first) / 2; }
};

/// Consecutive samples, and the intervals of them that come near the part.
struct SampleBatch {
    bool begun = false; ///< whether `near` and `finishSamples` are known
    std::vector<SampleInterval> near;
    std::size_t finishSamples = 0;
    /// mm, with which `worst` and `onPart` were found; empty: not yet
    std::optional<double> limit;
    std::vector<GougeSample> worst; ///< `move`: counted from that of the batch's first sample
    std::size_t onPart = 0;

    std::size_t bytes() const noexcept {
        return sizeof(SampleBatch) + near.capacity() * sizeof(SampleInterval) + worst.capacity() * sizeof(GougeSample);
    }
};

namespace {

double besideChord(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - from, way) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - from - share * way);
}

/// The longest sequence of samples of an upright tool from `first` on that lie on one chord; a sample of a tilted one
/// alone.
SampleInterval intervalFrom(std::size_t first, const std::vector<Place>& places, const std::vector<ToolMove>& moves) {
    SampleInterval interval{first, first + 1, 0.0, 0.0, {}};
    const std::size_t most = std::min(first + longestInterval, places.size());
    const std::uint16_t tool = moves[places[first].move].tool;
    for (std::size_t last = first + 1; last < most && moves[places[last].move].tool == tool; ++last) {
        if (places[first].tilted() || places[last].tilted()) break;
        double beside = 0.0;
        for (std::size_t i = first + 1; i < last && beside <= straight; ++i)
            beside = std::max(beside, besideChord(places[i].pose.tip, places[first].pose.tip, places[last].pose.tip));
        if (beside > straight) break;
        interval.end = last + 1;
        interval.beside = beside;
    }
    const glm::dvec3& middle = places[interval.middle()].pose.tip;
    for (std::size_t i = interval.first; i < interval.end; ++i)
        interval.reach = std::max(interval.reach, glm::length(places[i].pose.tip - middle));
    return interval;
}

using Places = std::vector<Place>;

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
    /// Whether the poses queried so far make certain that no tip within `reach` of this one, with the same axis, is
    /// near the part.
    bool isFar(const ToolPose& pose, double reach) const noexcept {
        return pose.axis == last_.axis && glm::length(pose.tip - last_.tip) + reach <= spare_;
    }
    ToolClearance ask(const ToolPose& pose, double reach) {
        const double within = std::max(within_, reach + 2.0 * onPartDistance);
        const ToolClearance found = asker_->ask(pose, within, answers);
        last_ = pose;
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
    ToolPose last_;
    double spare_ = -1.0,
           within_ = leastSearch; // mm: radius around the tip of `last_` without anything near; search distance
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

    /// Whether the samples of a move count as finishing where they are over the part.
    bool isAtCuttingFeed(const ToolMove& move) const noexcept {
        return !move.rapid && move.startKnown && move.feed >= cuttingFeed_[move.tool];
    }
    Places placesOf(const MoveSamples& samples, std::size_t first, std::size_t end) const {
        Places places;
        places.reserve(end - first);
        samples.forEach(first, end, [&](std::uint32_t move, const ToolPose& pose) { places.push_back({move, pose}); });
        return places;
    }

    /// Finds the intervals that come near the part, by their middles.
    void begin(SampleBatch& batch, const Places& places) const {
        for (const Place& place : places)
            if (isFinishing(place)) ++batch.finishSamples;
        Asking asking(part_, stacks_);
        for (std::size_t at = 0; at < places.size();) {
            SampleInterval interval = intervalFrom(at, places, moves_);
            at = interval.end;
            const Place& middle = places[interval.middle()];
            asking.take(toolOf(middle));
            if (asking.isFar(middle.pose, interval.reach)) continue;
            interval.clearance = asking.ask(middle.pose, interval.reach);
            if (!asking.isFar(middle.pose, interval.reach)) batch.near.push_back(interval);
        }
        batch.begun = true;
    }

    /// Finds all samples of the batch with a clearance below `limit`, mm, and those that touch the part.
    void finish(SampleBatch& batch, const Places& places, double limit) const {
        batch.limit.reset();
        batch.worst.clear();
        batch.onPart = 0;
        Asking asking(part_, stacks_);
        for (const SampleInterval& interval : batch.near) {
            asking.take(toolOf(places[interval.middle()]));
            Search search{batch, places, interval, limit, asking};
            if (interval.clearance.clearance > limit)
                divide(search, interval.first, interval.end);
            else
                judgeEach(search, interval.first, interval.end);
        }
        for (GougeSample& sample : batch.worst) sample.move -= places.front().move;
        batch.limit = limit;
    }

private:
    /// The search of one interval.
    struct Search {
        SampleBatch& batch;
        const Places& places;
        const SampleInterval& interval;
        double limit; ///< mm
        Asking& asking;
    };

    /// Examines an interval as a whole, then by halves, then sample by sample.
    void divide(Search& search, std::size_t first, std::size_t end) const {
        const SampleInterval& interval = search.interval;
        const glm::dvec3 &from = search.places[first].pose.tip, &to = search.places[end - 1].pose.tip;
        if (interval.clearance.clearance - answers.ordinary - interval.reach >= search.limit) {
            countOnPart(search, first, end);
        } else if (search.places[first].tilted()) {
            judgeEach(search, first, end);
        } else if (search.asking.keeps(from, to, search.limit + interval.beside)) {
            countOnPart(search, first, end);
        } else if (end - first <= 2) {
            judgeEach(search, first, end);
        } else {
            const std::size_t half = first + (end - first) / 2;
            divide(search, first, half);
            divide(search, half, end);
        }
    }
    void judgeEach(Search& search, std::size_t first, std::size_t end) const {
        for (std::size_t i = first; i < end; ++i) judge(search, search.places[i]);
    }
    /// Samples that stay clear of the part may still touch it, if they are near a point met by the middle of their
    /// interval.
    void countOnPart(Search& search, std::size_t first, std::size_t end) const {
        for (std::size_t i = first; i < end; ++i) {
            const Place& place = search.places[i];
            if (!isFinishing(place)) continue;
            if (touchesFlutes(place, search.interval.clearance.meshPoint))
                ++search.batch.onPart;
            else
                judge(search, place);
        }
    }

    void judge(Search& search, const Place& place) const {
        if (search.asking.isFar(place.pose, 0.0)) return;
        const ToolClearance found = search.asking.ask(place.pose, 0.0);
        if (found.clearance > onPartDistance) return;
        search.batch.worst.push_back({place.move, place.pose, found});
        if (isFinishing(place) && isByFlutes(found, place)) ++search.batch.onPart;
    }

    std::uint16_t toolOf(const Place& place) const noexcept { return moves_[place.move].tool; }
    bool isFinishing(const Place& place) const noexcept {
        const ToolMove& move = moves_[place.move];
        return isAtCuttingFeed(move) && outlines_[move.tool].contains(place.pose.tip.x, place.pose.tip.y);
    }
    bool touchesFlutes(const Place& place, const glm::dvec3& point) const noexcept {
        return std::ranges::any_of(flutes_[toolOf(place)], [&](const RevolvedPiece& piece) {
            return PlacedPiece(piece, place.pose).at(point).distance <= onPartDistance;
        });
    }
    bool isByFlutes(const ToolClearance& found, const Place& place) const {
        const std::vector<RevolvedPiece>& flutes = flutes_[toolOf(place)];
        if (found.piece < flutes.size()) return true;
        return part_.clearance(flutes, place.pose, 2.0 * onPartDistance).clearance <= onPartDistance;
    }

    const std::vector<ToolMove>& moves_;
    std::span<const ShrunkOutline> outlines_;
    const MeshDistance& part_;
    std::vector<std::vector<RevolvedPiece>> stacks_, flutes_;
    std::vector<double> cuttingFeed_;
};

/// Judges the samples of a program batch by batch; those with the same samples as a kept one are not judged again.
class BatchJudge {
public:
    BatchJudge(const std::vector<ToolMove>& moves, const MoveSamples& samples, const Sampler& sampler,
               std::span<const std::uint32_t> numbers, KeptSamples& kept)
        : samples_(samples), sampler_(sampler), borders_(batchBorders(moves, samples)) {
        std::vector<std::uint8_t> isFinishing(moves.size());
        for (std::size_t i = 0; i < moves.size(); ++i) isFinishing[i] = sampler.isAtCuttingFeed(moves[i]) ? 1 : 0;
        decltype(kept.batches) before = std::exchange(kept.batches, {});
        for (std::size_t i = 0; i + 1 < borders_.size(); ++i) {
            BatchKey key = batchKeyOf(moves, samples, numbers, isFinishing, borders_[i], borders_[i + 1]);
            const auto known = before.find(key);
            auto [entry, isNew] = kept.batches.try_emplace(std::move(key));
            if (isNew) {
                const bool isKnown = known != before.end() && known->second->begun;
                entry->second = isKnown ? known->second : std::make_shared<SampleBatch>();
                if (!isKnown) unknown_.push_back(i);
                distinct_.push_back(i);
            }
            batches_.push_back(entry->second);
        }
    }

    NearSamples run(std::size_t worst, double tolerance, Progress& progress) {
        ParallelProgress shared(progress, unknown_.size() + distinct_.size());
        forEachOf(unknown_, shared, progress, [&](std::size_t i) { sampler_.begin(*batches_[i], placesOf(i)); });
        const double limit = limitOf(worst, tolerance);
        forEachOf(distinct_, shared, progress, [&](std::size_t i) {
            if (batches_[i]->limit != limit) sampler_.finish(*batches_[i], placesOf(i), limit);
        });
        NearSamples near;
        for (std::size_t i = 0; i < batches_.size(); ++i) {
            const auto first = static_cast<std::uint32_t>(samples_.moveOf(borders_[i]));
            for (GougeSample sample : batches_[i]->worst) {
                sample.move += first;
                near.worst.push_back(sample);
            }
            near.finishSamples += batches_[i]->finishSamples;
            near.onPart += batches_[i]->onPart;
        }
        return near;
    }

private:
    template <class Work>
    static void forEachOf(const std::vector<std::size_t>& numbers, ParallelProgress& shared, const Progress& progress,
                          const Work& work) {
        parallelFor(std::size_t{0}, numbers.size(), [&](std::size_t i) {
            if (progress.cancelled()) return;
            work(numbers[i]);
            shared.add();
        });
    }
    Places placesOf(std::size_t batch) const {
        return sampler_.placesOf(samples_, borders_[batch], borders_[batch + 1]);
    }
    /// Clearance of the worst of the middles, mm, rounded up: samples farther from the part are neither deeper than the
    /// tolerance nor among the requested number of deepest ones.
    double limitOf(std::size_t worst, double tolerance) const {
        std::vector<double> clearances;
        for (const auto& batch : batches_)
            for (const SampleInterval& interval : batch->near) clearances.push_back(interval.clearance.clearance);
        if (clearances.size() < worst) return onPartDistance;
        const auto last = clearances.begin() + static_cast<std::ptrdiff_t>(worst) - 1;
        std::nth_element(clearances.begin(), last, clearances.end());
        const double least = std::max(std::min(*last, onPartDistance), -tolerance);
        return std::min(std::ceil(least / limitSteps) * limitSteps, onPartDistance);
    }

    const MoveSamples& samples_;
    const Sampler& sampler_;
    std::vector<std::size_t> borders_;
    std::vector<std::shared_ptr<SampleBatch>> batches_; ///< equal ones are the same
    std::vector<std::size_t> unknown_, distinct_;       ///< batches without intervals yet; one of each
};

} // namespace

std::size_t KeptSamples::Hash::operator()(const BatchKey& key) const noexcept {
    std::uint64_t hash = key.size();
    for (const std::uint64_t word : key) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

std::size_t KeptSamples::bytes() const noexcept {
    std::size_t bytes = batches.bucket_count() * sizeof(void*);
    for (const auto& [key, batch] : batches)
        bytes += sizeof(BatchKey) + 4 * sizeof(void*) + key.capacity() * sizeof(std::uint64_t) + batch->bytes();
    return bytes;
}

NearSamples nearSamples(const std::vector<ToolMove>& moves, const MoveSamples& places, std::span<const Tool> tools,
                        std::span<const ShrunkOutline> outlines, const VerifyRequest& request, std::size_t worst,
                        std::span<const std::uint32_t> numbers, KeptSamples& kept, Progress& progress) {
    const Sampler sampler(moves, tools, outlines, request);
    return BatchJudge(moves, places, sampler, numbers, kept).run(worst, request.gougeTolerance, progress);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/level_order.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace burin {
namespace {

constexpr double besideShare = 1.5; // step-overs: loops no farther apart than this are neighbours
constexpr double aheadShare = 2.0;  // step-overs that the tool moves forward while it changes to the next loop

std::size_t nearestTo(const std::vector<glm::dvec2>& places, const glm::dvec2& tip) {
    return static_cast<std::size_t>(
        std::ranges::min_element(places, {}, [&](const glm::dvec2& place) { return glm::distance(place, tip); }) -
        places.begin());
}

/// The index of the point of a closed run that lies the given distance along the run after another one.
std::size_t aheadOf(const LevelRun& run, std::size_t start, double way) {
    std::size_t i = start % (run.places.size() - 1);
    for (std::size_t looked = 0; way > 0.0 && looked + 1 < run.places.size(); ++looked) {
        way -= glm::distance(run.places[i], run.places[i + 1]);
        i = (i + 1) % (run.places.size() - 1);
    }
    return i;
}

} // namespace

LevelRun begunAt(LevelRun run, std::size_t start) {
    if (!run.closed || start == 0) return run;
    start %= run.places.size() - 1;
    run.places.pop_back(); // the same as the first
    std::ranges::rotate(run.places, run.places.begin() + static_cast<std::ptrdiff_t>(start));
    run.places.push_back(run.places.front());
    return run;
}

std::vector<glm::dvec2> spaced(const PlanRing& ring, double spacing) {
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / spacing)));
        for (int k = 0; k < steps; ++k) places.push_back(glm::mix(from, to, static_cast<double>(k) / steps));
    }
    return places;
}

std::vector<LevelRun> runsAlong(const std::vector<glm::dvec2>& places, std::vector<LevelPlace> work, std::size_t gap) {
    const std::size_t count = places.size();
    const auto first = std::ranges::find(work, LevelPlace::cuts);
    if (first == work.end()) return {};
    const auto begin = static_cast<std::size_t>(first - work.begin());
    for (std::size_t i = 1, idle = 0; i <= count; ++i) { // gaps, around the loop, starting at a point that cuts
        const std::size_t at = (begin + i) % count;
        if (work[at] == LevelPlace::idle) {
            ++idle;
            continue;
        }
        if (work[at] == LevelPlace::cuts && idle <= gap && work[(at + count - idle - 1) % count] == LevelPlace::cuts)
            for (std::size_t k = 1; k <= idle; ++k) work[(at + count - k) % count] = LevelPlace::cuts;
        idle = 0;
    }
    const auto rest = std::ranges::find_if(work, [](LevelPlace one) { return one != LevelPlace::cuts; });
    if (rest == work.end()) {
        LevelRun whole{places, true, 0};
        whole.places.push_back(places.front());
        return {std::move(whole)};
    }
    std::vector<LevelRun> runs;
    const auto start = static_cast<std::size_t>(rest - work.begin());
    for (std::size_t i = 0; i <= count; ++i) {
        const std::size_t at = (start + i) % count, before = (at + count - 1) % count;
        const bool cuts = work[at] == LevelPlace::cuts && i < count;
        const bool cutBefore = work[before] == LevelPlace::cuts && i > 0;
        if (cuts && !cutBefore) {
            runs.emplace_back();
            if (work[before] == LevelPlace::idle) runs.back().places.push_back(places[before]);
        }
        if (cuts || (cutBefore && work[at] == LevelPlace::idle)) runs.back().places.push_back(places[at]);
    }
    std::erase_if(runs, [](const LevelRun& run) { return run.places.size() < 2; });
    return runs;
}

LevelOrder::LevelOrder(std::vector<LevelRun> runs, double stepOver)
    : runs_(std::move(runs))
    , stepOver_(stepOver)
    , behind_(runs_.size())
    , waitsFor_(runs_.size(), 0)
    , done_(runs_.size(), false) {
    findWhatComesFirst();
}

void LevelOrder::findWhatComesFirst() {
    const double beside = besideShare * stepOver_;
    const auto squareOf = [&](double x, double y) {
        const auto whole = [&](double value) { return static_cast<std::int64_t>(std::floor(value / beside)); };
        return whole(x) * 0x100000000LL + (whole(y) & 0xffffffffLL);
    };
    struct Spot {
        std::size_t run;
        glm::dvec2 place;
    };
    std::unordered_map<std::int64_t, std::vector<Spot>> squares;
    const auto visitSpots = [&](std::size_t run, const auto& visit) { // points about a step apart suffice
        double way = stepOver_;
        for (std::size_t i = 0; i < runs_[run].places.size(); ++i) {
            if (i > 0) way += glm::distance(runs_[run].places[i - 1], runs_[run].places[i]);
            if (way < 0.4 * stepOver_) continue;
            way = 0.0;
            visit(runs_[run].places[i]);
        }
    };
    for (std::size_t run = 0; run < runs_.size(); ++run)
        visitSpots(run, [&](const glm::dvec2& place) { squares[squareOf(place.x, place.y)].push_back({run, place}); });
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        std::vector<bool> known(runs_.size(), false);
        visitSpots(run, [&](const glm::dvec2& place) {
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy) {
                    const auto square = squares.find(squareOf(place.x + dx * beside, place.y + dy * beside));
                    if (square == squares.end()) continue;
                    for (const Spot& spot : square->second) {
                        if (runs_[spot.run].step != runs_[run].step + 1 || known[spot.run] ||
                            glm::distance(spot.place, place) > beside)
                            continue;
                        known[spot.run] = true;
                        behind_[spot.run].push_back(run);
                        ++waitsFor_[run];
                    }
                }
        });
    }
}

std::optional<LevelRun> LevelOrder::next(std::optional<glm::dvec2> tip) {
    std::size_t best = runs_.size(), bestStart = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        if (done_[run] || waitsFor_[run] > 0) continue;
        const LevelRun& candidate = runs_[run];
        const std::size_t start = tip && candidate.closed ? nearestTo(candidate.places, *tip) : 0;
        const double distance = tip ? glm::distance(candidate.places[start], *tip) : 0.0;
        if (distance >= least) continue;
        least = distance;
        best = run;
        bestStart = start;
    }
    if (best == runs_.size()) return {};
    done_[best] = true;
    for (const std::size_t waiting : behind_[best]) --waitsFor_[waiting];
    if (runs_[best].closed && tip) bestStart = aheadOf(runs_[best], bestStart, aheadShare * stepOver_);
    return begunAt(std::move(runs_[best]), bestStart);
}

} // namespace burin

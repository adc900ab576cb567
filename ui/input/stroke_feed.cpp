// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/stroke_feed.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr int interval = 10;              // ms: the stylus holds thousands of points
constexpr std::size_t placesADeal = 500;  // so that computing heights does not block the window
constexpr std::size_t longestTail = 4000; // points that are worth drawing

} // namespace

StrokeFeed::StrokeFeed(SimulatedStylus& stylus, std::function<double(const glm::dvec3&)> heightAt, QObject* parent)
    : QObject(parent), stylus_(stylus), heightAt_(std::move(heightAt)) {
    timer_.setInterval(interval);
    connect(&timer_, &QTimer::timeout, this, &StrokeFeed::feed);
}

void StrokeFeed::add(const StylusTarget& target, Height height) {
    if (!target.cutting && !queue_.empty() && !queue_.back().target.cutting) queue_.pop_back();
    queue_.push_back({target, height});
    feed();
}

void StrokeFeed::giveUp(const StylusTarget& target) {
    queue_.clear();
    handed_.clear();
    held_ = false;
    between_ = true;
    timer_.stop();
    stylus_.request(target);
}

void StrokeFeed::hold() {
    held_ = true;
}

void StrokeFeed::goOn() {
    held_ = false;
    feed();
}

void StrokeFeed::feed() {
    for (std::size_t i = 0; i < placesADeal && !queue_.empty(); ++i) {
        Entry& next = queue_.front();
        if (held_ && next.target.cutting) break;
        if (std::exchange(next.height, Height::given) == Height::later) next.target.tip.z = heightAt_(next.target.tip);
        const bool passed = !stylus_.strokeUnderWay() && stylus_.targetsAhead() == 0;
        if (!stylus_.request(next.target)) break;
        if (passed) handed_.clear();
        if (next.target.cutting) handed_.push_back({next.target.tip, between_});
        between_ = !next.target.cutting;
        queue_.pop_front();
    }
    if (queue_.empty())
        timer_.stop();
    else if (!timer_.isActive())
        timer_.start();
}

bool StrokeFeed::heightsAreOpen() const {
    return std::ranges::any_of(queue_, [](const Entry& entry) { return entry.height == Height::later; });
}

PlaceChains StrokeFeed::tail() {
    PlaceChains chains;
    std::size_t count = 0;
    const auto add = [&](const Place& next) {
        if (chains.empty() && !next.begins) chains.push_back({stylus_.tip()});
        if (next.begins) chains.emplace_back();
        chains.back().push_back(next.place);
        ++count;
    };
    const std::size_t ahead = std::min(stylus_.targetsAhead(), handed_.size());
    for (auto next = handed_.end() - static_cast<std::ptrdiff_t>(ahead); next != handed_.end(); ++next) add(*next);
    bool between = between_;
    for (const Entry& entry : queue_) {
        if (count > longestTail) break;
        if (entry.target.cutting && entry.height == Height::given) add({entry.target.tip, between});
        between = !entry.target.cutting;
    }
    return chains;
}

} // namespace burin

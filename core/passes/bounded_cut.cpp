// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/bounded_cut.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

constexpr double squareShare = 0.08;  // of the tool's radius
constexpr double leastWidth = 0.08;   // of the bound: less is what squares and earlier cuts leave at their edges
constexpr double overBound = 1.08;    // times the bound before a run is left: what squares add
constexpr double circleShare = 0.92;  // of the bound, that circles take
constexpr double averaged = 0.5;      // of the radius: length over which a width is measured
constexpr double enteredShare = 0.25; // of the covered area: more is entered by a helix
constexpr double steepest = 3.0 * pi / 180.0; // rad, of a helix
constexpr double sharpBend = pi / 9.0;        // rad, of a run: circles don't cut its corner
constexpr double rowHeight = 0.5;             // mm
constexpr double gapAbove = 0.3;              // mm between a helix' start and the stock
// Of the bound: radii of circles, and how far the next circle is.
constexpr std::array radiusShares{1.0, 0.7, 0.5, 0.35, 0.25, 0.15, 0.1, 0.07};
constexpr std::array stepShares{1.0, 0.75, 0.55, 0.4, 0.3, 0.2, 0.12};

glm::dvec2 leftOf(const glm::dvec2& forward) noexcept {
    return {-forward.y, forward.x};
}

} // namespace

StandingPlan::StandingPlan(const WorkpieceHeights& heights, double level, double radius)
    : low_(heights.stock().low), edge_(std::max(squareShare * radius, 0.2 * heights.raster())), radius_(radius) {
    const glm::dvec2 size(heights.stock().size());
    columns_ = std::max(1, static_cast<int>(std::ceil(size.x / edge_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(size.y / edge_)));
    stands_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const glm::dvec2 middle = low_ + edge_ * glm::dvec2(column + 0.5, row + 0.5);
            const double top = heights.highestWithin(middle.x, middle.y, std::sqrt(0.5) * heights.raster());
            stands_.push_back(top > level + WorkpieceHeights::leastRest ? 1 : 0);
        }
}

double StandingPlan::take(const glm::dvec2& place, Taken& taken) {
    const glm::dvec2 at = (place - low_) / edge_ - 0.5; // in squares
    const double radius = radius_ / edge_;
    const int first = std::max(0, static_cast<int>(std::ceil(at.y - radius)));
    const int last = std::min(rows_ - 1, static_cast<int>(std::floor(at.y + radius)));
    const std::size_t before = taken.size();
    for (int row = first; row <= last; ++row) {
        const double half = std::sqrt(std::max(0.0, radius * radius - (row - at.y) * (row - at.y)));
        const int from = std::max(0, static_cast<int>(std::ceil(at.x - half)));
        const int to = std::min(columns_ - 1, static_cast<int>(std::floor(at.x + half)));
        const std::size_t line = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
        for (int column = from; column <= to; ++column)
            if (std::uint8_t& stands = stands_[line + static_cast<std::size_t>(column)]; stands != 0) {
                stands = 0;
                taken.push_back(line + static_cast<std::size_t>(column));
            }
    }
    return static_cast<double>(taken.size() - before) * edge_ * edge_;
}

void StandingPlan::giveBack(const Taken& taken) {
    for (const std::size_t square : taken) stands_[square] = 1;
}

double StandingPlan::shareAt(const glm::dvec2& place) {
    Taken taken;
    const double area = take(place, taken);
    giveBack(taken);
    return area / (pi * radius_ * radius_);
}

BoundedCut::BoundedCut(const Values& values, const WorkpieceHeights& heights, HasRoom hasRoom)
    : values_(values), heights_(heights), hasRoom_(std::move(hasRoom)), plan_(heights, values.level, values.radius) {}

bool BoundedCut::cuts(const std::vector<glm::dvec2>& run) {
    StandingPlan::Taken taken;
    std::deque<Cut> recent = std::exchange(recent_, {}); // it need not begin where the tool is
    const double width = widest(run, run.front(), taken);
    recent_ = std::move(recent);
    plan_.giveBack(taken);
    return width > leastWidth * values_.width;
}

std::size_t BoundedCut::entryOf(const std::vector<glm::dvec2>& closed) {
    if (plan_.shareAt(closed.front()) <= enteredShare) return 0;
    std::size_t best = 0;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < closed.size() && widest < values_.width; ++i) {
        const glm::dvec2 way = closed[i + 1] - closed[i];
        const double length = glm::length(way);
        if (!(length > 0.0)) continue;
        const std::vector<Circle> circles = circlesAt({closed[i], way / length});
        if (circles.empty() || circles.front().radius <= widest) continue;
        widest = circles.front().radius;
        best = i;
    }
    return best;
}

/// The greatest width that the tool cuts along a way, mm, over any length that ends on it; what it takes is added to
/// `taken`.
double BoundedCut::widest(const std::vector<glm::dvec2>& way, const glm::dvec2& from, StandingPlan::Taken& taken) {
    const double length = averaged * values_.radius;
    std::vector<Cut>& cuts = cuts_; // those before the way count where a length begins there
    cuts.assign(recent_.begin(), recent_.end());
    double area = 0.0, along = 0.0, most = 0.0;
    for (const Cut& cut : cuts) {
        area += cut.area;
        along += cut.length;
    }
    std::size_t first = 0;
    glm::dvec2 at = from;
    for (const glm::dvec2& place : way) {
        cuts.push_back({glm::distance(at, place), plan_.take(place, taken)});
        along += cuts.back().length;
        area += cuts.back().area;
        at = place;
        while (along - cuts[first].length >= length) {
            along -= cuts[first].length;
            area -= cuts[first].area;
            ++first;
        }
        // A short way counts as a whole length: over it the squares would count too much.
        most = std::max(most, area / std::max(along, length));
    }
    return most;
}

void BoundedCut::remember(const Cut& cut) {
    const double length = averaged * values_.radius;
    recent_.push_back(cut);
    double along = 0.0;
    for (const Cut& each : recent_) along += each.length;
    while (along - recent_.front().length >= length) {
        along -= recent_.front().length;
        recent_.pop_front();
    }
}

BoundedCut::Course::Course(const std::vector<glm::dvec2>& places) {
    for (const glm::dvec2& place : places) {
        const double length = places_.empty() ? 0.0 : glm::distance(places_.back(), place);
        if (!places_.empty() && !(length > 0.0)) continue;
        ends_.push_back(places_.empty() ? 0.0 : ends_.back() + length);
        places_.push_back(place);
    }
}

BoundedCut::Spot BoundedCut::Course::at(double way) const {
    if (places_.size() < 2) return {places_.front(), {1.0, 0.0}};
    const auto found = std::lower_bound(ends_.begin() + 1, ends_.end() - 1, way) - ends_.begin();
    const auto i = static_cast<std::size_t>(found);
    const double length = ends_[i] - ends_[i - 1];
    const glm::dvec2 forward = (places_[i] - places_[i - 1]) / length;
    return {places_[i - 1] + std::clamp(way - ends_[i - 1], 0.0, length) * forward, forward};
}

std::vector<glm::dvec2> BoundedCut::Course::between(double from, double to) const {
    std::vector<glm::dvec2> ahead;
    for (auto i = static_cast<std::size_t>(std::ranges::upper_bound(ends_, from + 1e-9) - ends_.begin());
         i < places_.size() && ends_[i] < to - 1e-9; ++i)
        ahead.push_back(places_[i]);
    ahead.push_back(at(to).place);
    return ahead;
}

/// The circles that fit at a point of a run, the largest first.
std::vector<BoundedCut::Circle> BoundedCut::circlesAt(const Spot& spot) const {
    std::vector<Circle> circles;
    for (const double share : radiusShares) {
        const double radius = share * values_.width;
        const glm::dvec2 centre = spot.place + radius * leftOf(spot.forward);
        if (hasRoom_(centre, radius)) circles.push_back({centre, spot.forward, radius});
    }
    return circles;
}

/// Straight to the back of a circle, and once round it.
std::vector<glm::dvec2> BoundedCut::waysRound(const glm::dvec2& from, const Circle& circle) const {
    const int steps = std::max(16, static_cast<int>(std::ceil(2.0 * pi * circle.radius / values_.spacing)));
    const glm::dvec2 back = circle.centre - circle.radius * circle.forward;
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(from, back) / values_.spacing)));
    std::vector<glm::dvec2> way;
    for (int i = 1; i <= pieces; ++i) way.push_back(glm::mix(from, back, static_cast<double>(i) / pieces));
    for (int i = 1; i <= steps; ++i) { // over the right, where the run is, to the front
        const double angle = 2.0 * pi * i / steps;
        way.push_back(circle.centre -
                      circle.radius * (std::cos(angle) * circle.forward + std::sin(angle) * leftOf(circle.forward)));
    }
    return way;
}

void BoundedCut::go(const std::vector<glm::dvec2>& way, TipLine& tips) {
    StandingPlan::Taken taken;
    for (const glm::dvec2& place : way) {
        const double area = plan_.take(place, taken);
        if (!tips.empty()) remember({glm::distance(glm::dvec2(tips.back()), place), area});
        tips.emplace_back(place, values_.level);
    }
}

/// On a helix down to the level; false if it has no room. Ends at the back of its circle.
bool BoundedCut::descend(const Spot& spot, TipLine& tips) {
    const std::vector<Circle> circles = circlesAt(spot);
    if (circles.empty()) return false;
    const Circle& circle = circles.front();
    const double reach = circle.radius + values_.radius, round = 2.0 * pi * circle.radius;
    const double top = heights_.highestWithin(circle.centre.x, circle.centre.y, reach) + gapAbove;
    const glm::dvec2 back = circle.centre - circle.radius * circle.forward;
    const std::vector<glm::dvec2> turn = waysRound(back, circle); // its first point is the back
    // A turn takes the disc that it covers, as high as the pitch: no more than the bound takes in its length.
    const double bound = values_.most * values_.depth * round / (pi * reach * reach);
    const double pitch = std::min(round * std::tan(steepest), bound), drop = std::max(0.0, top - values_.level);
    const auto points = static_cast<double>(turn.size() - 1);
    const int count = std::max(1, static_cast<int>(std::ceil(drop / pitch * points)));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * (i - count) / points;
        const glm::dvec2 place = circle.centre - circle.radius * (std::cos(angle) * circle.forward +
                                                                  std::sin(angle) * leftOf(circle.forward));
        tips.emplace_back(place, top - drop * i / count);
    }
    go(turn, tips);
    return true;
}

/// The circle that leads farthest along a run within the bound, or cuts least; returns how far it leads.
/// @param straight mm, width that going straight on would cut: a circle has to cut less
std::optional<double> BoundedCut::circleOn(const Course& course, double done, double straight, TipLine& tips) {
    const glm::dvec2 here(tips.back());
    std::vector<glm::dvec2> best;
    double least = straight, gained = 0.0;
    StandingPlan::Taken taken;
    for (const double share : stepShares) {
        const double next = std::min(course.length(), done + share * values_.width);
        for (const Circle& circle : circlesAt(course.at(next))) {
            const glm::dvec2 back = circle.centre - circle.radius * circle.forward;
            const bool reached = std::ranges::all_of(
                std::array{0.25, 0.5, 0.75}, [&](double part) { return hasRoom_(glm::mix(here, back, part), 0.0); });
            if (!reached) continue;
            std::vector<glm::dvec2> way = waysRound(here, circle);
            taken.clear();
            const double cut = widest(way, here, taken);
            plan_.giveBack(taken);
            if (cut >= least) continue;
            least = cut;
            best = std::move(way);
            gained = next;
            if (cut <= circleShare * values_.most) break;
        }
        if (least <= circleShare * values_.most) break;
    }
    if (best.empty()) return std::nullopt;
    go(best, tips);
    return gained;
}

/// Goes along the part of a run that a circle has passed, if that leaves something of it: in a corner.
bool BoundedCut::followed(const Course& course, double from, double to, TipLine& tips) {
    const glm::dvec2 here(tips.back()), start = course.at(from).place;
    const std::vector<glm::dvec2> passed = course.between(from, to);
    bool bends = false;
    glm::dvec2 before = course.at(from).forward;
    glm::dvec2 at = start;
    StandingPlan::Taken taken;
    double area = plan_.take(start, taken);
    for (const glm::dvec2& place : passed) {
        const glm::dvec2 way = place - at;
        bends = bends || glm::dot(before, way) < std::cos(sharpBend) * glm::length(before) * glm::length(way);
        area += plan_.take(place, taken);
        before = way;
        at = place;
    }
    plan_.giveBack(taken);
    const bool reached = std::ranges::all_of(std::array{0.25, 0.5, 0.75},
                                             [&](double part) { return hasRoom_(glm::mix(here, start, part), 0.0); });
    if (!(bends || area > leastWidth * values_.width * (to - from)) || !reached) return false;
    go({start}, tips);
    go(passed, tips);
    return true;
}

TipLine BoundedCut::along(const std::vector<glm::dvec2>& run, bool joined) {
    const Course course(run);
    TipLine tips;
    if (!joined) recent_.clear();
    // Whether the tool is at the back of a circle that touches the run where it has got to.
    bool onCircle = !joined && plan_.shareAt(run.front()) > enteredShare && descend(course.at(0.0), tips);
    if (!onCircle) go({run.front()}, tips);
    double done = 0.0;
    StandingPlan::Taken taken;
    while (done < course.length() - 1e-9) {
        const double window = std::min(course.length(), done + averaged * values_.radius);
        taken.clear();
        const double width = widest(course.between(done, window), course.at(done).place, taken);
        plan_.giveBack(taken);
        if (width > overBound * values_.most) {
            if (const std::optional<double> gained = circleOn(course, done, width, tips)) {
                onCircle = !followed(course, done, *gained, tips);
                done = *gained;
                continue;
            }
        }
        if (onCircle) go({course.at(done).place}, tips); // across the circle, through air
        onCircle = false;
        const double next = std::min(course.length(), done + values_.spacing);
        go(course.between(done, next), tips);
        done = next;
    }
    if (onCircle) go({run.back()}, tips);
    if (joined) tips.erase(tips.begin()); // the tool is there
    return tips;
}

RowedRegion::RowedRegion(const PlanRegion& region, double low, double high)
    : low_(low), rows_(static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / rowHeight)))) {
    const auto rowOf = [&](double y) {
        return static_cast<std::size_t>(std::clamp((y - low_) / rowHeight, 0.0, static_cast<double>(rows_.size() - 1)));
    };
    for (const PlanRing& ring : region.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
            const auto [bottom, top] = std::minmax(edge.from.y, edge.to.y);
            for (std::size_t row = rowOf(bottom); row <= rowOf(top); ++row) rows_[row].push_back(edge);
        }
}

bool RowedRegion::holds(const glm::dvec2& place) const noexcept {
    const double row = (place.y - low_) / rowHeight;
    if (!(row >= 0.0 && row < static_cast<double>(rows_.size()))) return false;
    bool inside = false;
    for (const Edge& edge : rows_[static_cast<std::size_t>(row)]) {
        const auto& [a, b] = edge;
        if ((a.y > place.y) == (b.y > place.y)) continue;
        if (place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

} // namespace burin

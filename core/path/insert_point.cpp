// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/path/apply.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace burin {
namespace {

constexpr double blendChord = 0.001; // mm, chord error of the smooth curve between its points
constexpr double samePoint = 1e-6;   // mm: a point of the stroke that is this near is not inserted again

/// The distance of each point from the start, along the stroke, mm.
std::vector<double> distancesFromStart(const std::vector<StrokePoint>& points) {
    std::vector<double> distances(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        distances[i] = distances[i - 1] + glm::distance(points[i - 1].pose.tip, points[i].pose.tip);
    return distances;
}

/// The distance from the start at which a stroke reaches a moment for the first time, mm; between the ticks of two
/// points by time. Empty if it does not.
std::optional<double> distanceToMoment(const PathStroke& stroke, const std::vector<double>& distances,
                                       const Moment& moment) {
    if (!holds(stroke, moment)) return std::nullopt;
    const std::vector<StrokePoint>& points = stroke.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].sample == moment.tick) return distances[i];
        if (i + 1 == points.size() || (points[i].sample < moment.tick) == (points[i + 1].sample < moment.tick))
            continue;
        if (points[i + 1].sample == moment.tick) return distances[i + 1];
        const double share = static_cast<double>(moment.tick - points[i].sample) /
                             static_cast<double>(points[i + 1].sample - points[i].sample);
        return std::lerp(distances[i], distances[i + 1], share);
    }
    return std::nullopt;
}

/// The distances from the start, in order, at which the stroke needs a point, mm.
std::vector<double> neededAt(const InsertPoint& edit, double at) {
    std::vector<double> needed{at};
    const double far = glm::length(edit.by);
    if (!(edit.length > 0.0) || !(far > 0.0)) return needed;
    // The chord error of a curve with curvature k is k s² / 8; that of the cosine is at most far (pi / length)² / 2.
    const double smooth = 4.0 * edit.length / pi * std::sqrt(blendChord / far);
    const double pieces = edit.form == InsertPoint::Form::corner ? 1.0 : std::ceil(edit.length / smooth);
    for (double i = 1.0; i <= pieces; i += 1.0) {
        needed.push_back(at - edit.length * i / pieces);
        needed.push_back(at + edit.length * i / pieces);
    }
    std::ranges::sort(needed);
    return needed;
}

/// The stroke with a point at each of these distances from its start; those beyond its ends are left out.
std::vector<StrokePoint> withPointsAt(const std::vector<StrokePoint>& points, const std::vector<double>& distances,
                                      const std::vector<double>& needed) {
    std::vector<StrokePoint> all;
    auto next = needed.begin();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (; next != needed.end() && *next < distances[i] - samePoint; ++next) {
            if (i == 0 || *next < distances[i - 1] + samePoint) continue;
            StrokePoint between = points[i]; // the flags of a motion apply to its parts
            between.sample = points[i - 1].sample;
            between.onBoundary = points[i - 1].onBoundary && points[i].onBoundary;
            between.pose.tip = glm::mix(points[i - 1].pose.tip, points[i].pose.tip,
                                        (*next - distances[i - 1]) / (distances[i] - distances[i - 1]));
            all.push_back(between);
        }
        all.push_back(points[i]);
    }
    return all;
}

/// @return the inserted point, mm
glm::dvec3 insertInto(PathStroke& stroke, const std::vector<double>& distances, double at, const InsertPoint& edit) {
    stroke.points = withPointsAt(stroke.points, distances, neededAt(edit, at));
    const std::vector<double> all = distancesFromStart(stroke.points);
    const auto nearest = std::ranges::min_element(all, {}, [&](double each) { return std::abs(each - at); });
    const auto place = static_cast<std::size_t>(nearest - all.begin());
    for (std::size_t i = 0; i < all.size(); ++i)
        stroke.points[i].pose.tip += edit.by * (i == place ? 1.0 : edit.shareAt(std::abs(all[i] - at)));
    stroke.points[place].removes = true; // requested by the user: not an air cut
    return stroke.points[place].pose.tip;
}

} // namespace

double InsertPoint::shareAt(double way) const noexcept {
    if (way >= length) return 0.0;
    return form == Form::corner ? 1.0 - way / length : 0.5 + 0.5 * std::cos(pi * way / length);
}

Result<Deviation> apply(const InsertPoint& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    if (edit.at.source == 0) return Deviation{};
    for (PathStroke& stroke : state.strokes) {
        const std::vector<double> distances = distancesFromStart(stroke.points);
        if (const std::optional<double> at = distanceToMoment(stroke, distances, edit.at))
            state.inserted.push_back(
                insertInto(stroke, distances, std::min(*at + edit.beyond, distances.back()), edit));
    }
    if (state.inserted.empty())
        return Error{ErrorCode::argumentInvalid, "at",
                     nameOf(PathSource{edit.at.source}) + ", tick " + std::to_string(edit.at.tick),
                     "a moment that is still in the path"};
    return Deviation{}; // changed on purpose
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/timeline_curves.h"

#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

constexpr double farthestDeviation = 5.0; // mm

/// Translation context of this file.
struct TimelineCurveLabels {
    Q_DECLARE_TR_FUNCTIONS(TimelineCurveLabels)
};

} // namespace

QString curveName(TrackCurve curve) {
    switch (curve) {
    case TrackCurve::force:
        return TimelineCurveLabels::tr("Force");
    case TrackCurve::removal:
        return TimelineCurveLabels::tr("Removal rate");
    case TrackCurve::feed:
        return TimelineCurveLabels::tr("Feed");
    case TrackCurve::engagement:
        return TimelineCurveLabels::tr("Engagement");
    case TrackCurve::pushBack:
        return TimelineCurveLabels::tr("Push-back");
    case TrackCurve::height:
        return TimelineCurveLabels::tr("Height");
    case TrackCurve::deviation:
        return TimelineCurveLabels::tr("Deviation");
    }
    return {};
}

QString curveText(TrackCurve curve, double value, LengthUnit unit) {
    switch (curve) {
    case TrackCurve::force:
        return TimelineCurveLabels::tr("%1 N").arg(QLocale().toString(value, 'f', 1));
    case TrackCurve::removal:
        return rateText(value, unit);
    case TrackCurve::feed:
        return feedText(60.0 * value, unit);
    case TrackCurve::engagement:
        return areaText(value, unit);
    case TrackCurve::pushBack:
    case TrackCurve::height:
    case TrackCurve::deviation:
        return shortLength(std::round(value * 1e3) / 1e3, unit);
    }
    return {};
}

ColourRole curveColour(TrackCurve curve) {
    constexpr std::array roles{&Palette::force, &Palette::accent,    &Palette::inOrder, &Palette::path,
                               &Palette::part,  &Palette::quietText, &Palette::coupling};
    static_assert(roles.size() == trackCurves);
    return roles[static_cast<std::size_t>(curve)];
}

void TimelineCurves::setRecorded(std::shared_ptr<const RecordedTime> recorded) {
    recorded_ = std::move(recorded);
    ranges_ = {};
    columns_ = referenceColumns_ = {};
    take_ = reference_ = 0;
    if (!recorded_) return;
    for (std::size_t curve = 0; curve < trackCurves; ++curve) {
        Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
        for (const TakeTrack& track : recorded_->tracks)
            for (const float value : track.curves[curve]) {
                range.low = std::min(range.low, static_cast<double>(value));
                range.high = std::max(range.high, static_cast<double>(value));
            }
        if (static_cast<TrackCurve>(curve) == TrackCurve::deviation) {
            if (range.high < range.low) continue; // not computed yet
            range.low = std::min(range.low, 0.0);
            range.high = std::clamp(range.high, 0.0, farthestDeviation);
        } else if (static_cast<TrackCurve>(curve) != TrackCurve::height) {
            range.low = 0.0;
        }
        if (range.high >= range.low) ranges_[curve] = range;
    }
}

void TimelineCurves::setReference(std::int64_t take, std::int64_t reference) {
    const bool there = recorded_ && recorded_->trackOf(take) != nullptr && recorded_->trackOf(reference) != nullptr;
    const std::int64_t own = there ? take : 0, other = there ? reference : 0;
    if (own == take_ && other == reference_) return;
    take_ = own;
    reference_ = other;
    referenceColumns_ = {};
}

void TimelineCurves::follow(const Window& window) {
    if (window == window_) return;
    window_ = window;
    columns_ = referenceColumns_ = {};
}

const std::vector<double>& TimelineCurves::columns(TrackCurve curve, const Window& window) {
    follow(window);
    std::vector<double>& known = columns_[static_cast<std::size_t>(curve)];
    if (known.empty()) known = extremes(curve);
    return known;
}

const std::vector<double>& TimelineCurves::referenceColumns(TrackCurve curve, const Window& window) {
    follow(window);
    std::vector<double>& known = referenceColumns_[static_cast<std::size_t>(curve)];
    if (known.empty()) known = extremesOfReference(curve);
    return known;
}

void TimelineCurves::add(std::vector<double>& extremes, const TakeTrack& track, TrackCurve curve, double start,
                         double end) const {
    const std::vector<float>& values = track.curves[static_cast<std::size_t>(curve)];
    const double bin = static_cast<double>(TakeTrack::samplesPerBin) * track.info.tickPeriod;
    const double column = window_.length / window_.columns;
    for (std::size_t x = 0; x < extremes.size(); ++x) {
        const double at = window_.begin + static_cast<double>(x) * column;
        const double from = (at - start) / bin, to = (std::min(at + column, end) - start) / bin;
        if (at > end || to < 0.0 || from >= static_cast<double>(values.size())) continue;
        const auto first = static_cast<std::size_t>(std::max(0.0, from));
        const auto last = std::min(values.size(), static_cast<std::size_t>(std::max(0.0, to)) + 1);
        for (std::size_t i = first; i < last; ++i) {
            const auto value = static_cast<double>(values[i]);
            extremes[x] =
                curve == TrackCurve::deviation ? std::fmin(extremes[x], value) : std::fmax(extremes[x], value);
        }
    }
}

std::vector<double> TimelineCurves::extremes(TrackCurve curve) const {
    std::vector<double> extremes(static_cast<std::size_t>(window_.columns), std::nan(""));
    if (!recorded_) return extremes;
    const double all = recorded_->seconds();
    double start = 0.0;
    for (const TakeTrack& track : recorded_->tracks) {
        add(extremes, track, curve, start, all);
        start += track.seconds();
    }
    return extremes;
}

std::vector<double> TimelineCurves::extremesOfReference(TrackCurve curve) const {
    std::vector<double> extremes(static_cast<std::size_t>(window_.columns), std::nan(""));
    if (!recorded_ || reference_ == 0) return extremes;
    const double start = recorded_->secondsAt({take_, 0});
    add(extremes, *recorded_->trackOf(reference_), curve, start, start + recorded_->trackOf(take_)->seconds());
    return extremes;
}

} // namespace burin

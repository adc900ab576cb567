// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Butterworth low pass of second order by the bilinear transform, warped to its cut-off.
struct LowPass {
    double b0, b1, b2, a1, a2;

    /// @param part cut-off over sampling rate, 0 … 0.5
    explicit LowPass(double part) {
        const double k = std::tan(pi * part), root = std::sqrt(2.0);
        const double scale = 1.0 / (1.0 + root * k + k * k);
        b0 = k * k * scale;
        b1 = 2.0 * b0;
        b2 = b0;
        a1 = 2.0 * (k * k - 1.0) * scale;
        a2 = (1.0 - root * k + k * k) * scale;
    }

    /// In place, starting as if all values before had equalled the first one.
    template <class Iterator>
    void run(Iterator at, Iterator end) const {
        if (at == end) return;
        glm::dvec3 second = (b2 - a2) * *at, first = (b1 - a1) * *at + second;
        for (; at != end; ++at) {
            const glm::dvec3 in = *at, out = b0 * in + first;
            first = b1 * in - a1 * out + second;
            second = b2 * in - a2 * out;
            *at = out;
        }
    }
};

/// Forward and backward: no delay, gain 1 / (1 + (f / cut-off)⁴). The ends are continued by their point reflection, so
/// that a line stays a line and the ends stay about where they are.
std::vector<glm::dvec3> lowPassed(const PathStroke& stroke, double cutOff) {
    const std::vector<StrokePoint>& points = stroke.points;
    const double cutOffPart = cutOff * stroke.tickPeriod;
    // The impulse response has decayed to 1e-5 of its peak after 3 periods of the cut-off.
    const std::size_t padding = std::min(points.size() - 1, static_cast<std::size_t>(std::ceil(3.0 / cutOffPart)));
    const glm::dvec3 front = points.front().pose.tip, back = points.back().pose.tip;
    std::vector<glm::dvec3> tips;
    tips.reserve(points.size() + 2 * padding);
    for (std::size_t i = padding; i > 0; --i) tips.push_back(2.0 * front - points[i].pose.tip);
    for (const StrokePoint& point : points) tips.push_back(point.pose.tip);
    for (std::size_t i = 1; i <= padding; ++i) tips.push_back(2.0 * back - points[points.size() - 1 - i].pose.tip);
    const LowPass filter(cutOffPart);
    filter.run(tips.begin(), tips.end());
    filter.run(tips.rbegin(), tips.rend());
    tips.erase(tips.begin(), tips.begin() + static_cast<std::ptrdiff_t>(padding));
    tips.resize(points.size());
    return tips;
}

/// Cut-off, as a multiple of the edit's, of the filter that removes what cannot be hand motion: steps of an encoder.
/// Tremor (8 … 12 Hz) passes it.
constexpr double steadyingFactor = 8.0;
/// Share of the tolerance by which the hand's own motion may be changed; the remainder is for the encoder's steps.
constexpr double motionShare = 0.6;

/// Clamping the low-passed tips to the tolerance around the *recorded* ones would reintroduce the encoder's steps
/// wherever the tolerance is used up. They are clamped to a share of it around the steadied tips, which are smooth
/// themselves, and only then to the tolerance around the recorded ones.
Deviation smooth(PathStroke& stroke, const Smooth& edit) {
    Deviation deviation;
    if (stroke.points.size() < 3 || !stroke.inTime()) return deviation;
    const std::vector<glm::dvec3> tips = lowPassed(stroke, edit.cutOff);
    const double steadying = std::min(steadyingFactor * edit.cutOff, 0.4 / stroke.tickPeriod);
    const std::vector<glm::dvec3> steadied = lowPassed(stroke, steadying);
    for (std::size_t i = 0; i < tips.size(); ++i) {
        StrokePoint& point = stroke.points[i];
        const glm::dvec3 wanted = steadied[i] + clampLength(tips[i] - steadied[i], motionShare * edit.tolerance);
        const glm::dvec3 shift = clampLength(wanted - point.pose.tip, edit.tolerance);
        point.pose.tip += shift;
        deviation.include(glm::length(shift), point.pose.tip);
    }
    return deviation;
}

} // namespace

Result<void> checkCutOff(double cutOff, const PathUnderEdit& state) {
    for (const PathStroke& stroke : state.strokes)
        if (cutOff * stroke.tickPeriod >= 0.5)
            return Error{ErrorCode::argumentInvalid, "cut_off_hz", formatShortest(cutOff),
                         "below half of the recording's rate"};
    return {};
}

Result<Deviation> apply(const Smooth& edit, PathUnderEdit& state, const PathContext&, Progress& progress) {
    if (Result<void> usable = checkCutOff(edit.cutOff, state); !usable) return usable.error();
    return changeEach(state, progress, [&](PathStroke& stroke) { return smooth(stroke, edit); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What a pen adds to the mill tool: pressure, tilt, the eraser.
#include "core/geometry/angle.h"
#include "ui/input/mill_geometry.h"
#include "ui/input/mill_tool.h"

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr double clearTilt = 0.26;         // rad, 15°: a hand that writes upright stays below
constexpr double longestSinkingStep = 0.1; // s: after a pause of the window the tool does not jump

} // namespace

bool MillTool::penLeans() const noexcept {
    return pen_ && !pen_->eraser && angleBetween(pen_->axis, uprightAxis) > clearTilt;
}

void MillTool::notePen(const ViewportEvent& event) {
    const bool leaned = penLeans();
    pen_ = event.pen;
    if (penLeans() != leaned) emit stateChanged();
}

double MillTool::fullDepth() const noexcept {
    return settings_.rule == DepthRule::part ? settings_.press : settings_.depthOfCut;
}

void MillTool::beginPressure() {
    raised_ = 0.0;
    if (!pen_) return;
    if (settings_.pen == PenRule::depth) return followPressure();
    raised_ = fullDepth();
    sinkClock_.start();
}

void MillTool::followPressure() {
    if (pen_ && settings_.pen == PenRule::depth) raised_ = (1.0 - pen_->pressure) * fullDepth();
}

/// Also while the pen rests, when there are no events.
void MillTool::sink() {
    const double elapsed = std::min(1e-9 * static_cast<double>(sinkClock_.nsecsElapsed()), longestSinkingStep);
    sinkClock_.start();
    if (stroke_ != Stroke::pointer || !pen_) return sinking_.stop();
    const double before = raised_;
    raised_ = std::max(0.0, raised_ - settings_.sinkSpeed * pen_->pressure * elapsed);
    if (raised_ != before) aim(lastSight_);
}

void MillTool::retract(const Sight& sight) {
    if (std::exchange(drawing_, Drawing::none) != Drawing::none) emit stateChanged();
    showAim({});
    endStroke(End::givenUp);
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return;
    const double height = workpiece.grid().box().high.z + hoverClearance;
    if (const auto place = onLevel(sight, height)) hoverAt(*place);
}

} // namespace burin

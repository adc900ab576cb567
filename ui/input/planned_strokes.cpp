// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The strokes of the mill tool that are cut automatically: straight lines, rasters, repetitions.
#include "ui/input/mill_geometry.h"
#include "ui/input/mill_tool.h"

#include <utility>

namespace burin {
namespace {

constexpr double mostPlaces = 1e6; // of one stroke: each is held as a StylusTarget of some 90 bytes until it is cut

} // namespace

void MillTool::beginDrawing(Drawing what, const ViewportEvent& event) {
    pressed_ = event;
    drawing_ = what;
    lookAt(view_(), sightOf(event));
    if (what == Drawing::line) { // starts at the end of the last stroke, at its height
        corner_ = memory_.last().places.back();
        lockAnchor_ = corner_;
        if (settings_.rule == DepthRule::level) levelHeight_ = corner_.z - wheelOffset_;
    } else {
        const auto place = onLevel(sightOf(event), pointedHeight_);
        corner_ = place ? keptWithin(strokeReach(view_(), tool_.cutter), *place) : target_;
        corner_.z = levelHeight_ + wheelOffset_;
    }
    draw(event);
}

void MillTool::draw(const ViewportEvent& event) {
    const VolumeSnapshot workpiece = view_();
    const auto place = onLevel(sightOf(event), pointedHeight_);
    if (!place || workpiece.empty()) return;
    const glm::dvec3 held = drawing_ == Drawing::line ? locked(lock_, lockAnchor_, lockDirection_, *place) : *place;
    across_ = keptWithin(strokeReach(workpiece, tool_.cutter), held);
    across_.z = corner_.z;
    showAim(drawing_ == Drawing::line ? std::optional(across_) : std::nullopt); // the end of the line
    emit stateChanged();
}

std::vector<glm::dvec3> MillTool::drawnCorners() const {
    if (drawing_ == Drawing::line) return {corner_, across_};
    return rasterRows(corner_, across_, settings_.stepOver);
}

void MillTool::finishDrawing() {
    const std::vector<glm::dvec3> corners = drawnCorners();
    const Drawing what = std::exchange(drawing_, Drawing::none);
    showAim({});
    const bool fast = what == Drawing::raster && settings_.rule == DepthRule::level;
    const QString obstacle = cutPlan({corners, std::vector<glm::dvec3>(corners.size(), uprightAxis), 0.0},
                                     fast ? SimulatedStylus::maximumSpeed : settings_.speed);
    if (!obstacle.isEmpty()) emit refused(obstacle);
}

/// Cuts a complete stroke, at the heights of its corners or along the part.
QString MillTool::cutPlan(const DrawnStroke& stroke, double speed) {
    const std::vector<glm::dvec3>& corners = stroke.places;
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty() || corners.empty()) return {};
    const bool onPart = settings_.rule == DepthRule::part;
    const double spacing = workpiece.grid().edge();
    if (onPart && subdividedCount(corners, spacing) > mostPlaces)
        return tr(
            "The raster needs more than a million points along the part. Increase the step-over or draw a smaller "
            "rectangle.");
    const std::vector<glm::dvec3> places = onPart ? subdivided(corners, spacing) : corners;
    const std::vector<glm::dvec3> axes = onPart ? subdividedAxes(corners, stroke.axes, spacing) : stroke.axes;
    levelHeight_ = corners.front().z - wheelOffset_;
    glm::dvec3 first = places.front();
    if (onPart) first.z = strokeHeight(workpiece, first);
    emit strokeBegins();
    StylusTarget target{.tip = first,
                        .maximumSpeed = speed,
                        .cutting = true,
                        .clearHeight = clearHeightTo(workpiece, first),
                        .grain = stroke.grain,
                        .axis = axes.front()};
    feed_.add(target);
    for (std::size_t i = 1; i < places.size(); ++i) {
        target.tip = places[i];
        target.axis = axes[i];
        feed_.add(target, onPart ? StrokeFeed::Height::later : StrokeFeed::Height::given);
    }
    target_ = places.back();
    memory_.begin(begunStrokes());
    for (std::size_t i = 0; i < corners.size(); ++i) memory_.add(corners[i], stroke.grain, stroke.axes[i]);
    strokeEnd_ = target_;
    feed_.add({.tip = target_, .finishStroke = true});
    hoverAt(target_);
    emit strokeEnds();
    emit stateChanged();
    return {};
}

QString MillTool::repeat(Repetition how) {
    if (!canRepeat() || feed_.waits()) return {};
    glm::dvec3 shift(0.0);
    if (how == Repetition::lower) {
        if (settings_.rule == DepthRule::part)
            return tr("A stroke along the part cannot be repeated lower: the part limits its depth.");
        if (settings_.depthOfCut <= 0.0)
            return tr("The depth of cut is zero. Enter a depth to repeat the stroke lower.");
        shift.z = -settings_.depthOfCut;
    } else {
        const auto across = acrossOf(memory_.last().places);
        if (!across) return tr("The last stroke is vertical, so it cannot be repeated beside itself.");
        shift = *across * (how == Repetition::left ? settings_.stepOver : -settings_.stepOver);
    }
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return {};
    DrawnStroke stroke = memory_.last();
    for (glm::dvec3& corner : stroke.places) corner = keptWithin(strokeReach(workpiece, tool_.cutter), corner + shift);
    return cutPlan(stroke, settings_.speed);
}

PlaceChains MillTool::plans() {
    PlaceChains chains;
    if (drawing_ != Drawing::none) chains.push_back(drawnCorners());
    for (std::vector<glm::dvec3>& stroke : feed_.tail()) chains.push_back(std::move(stroke));
    return chains;
}

} // namespace burin

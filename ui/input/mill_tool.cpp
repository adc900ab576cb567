// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/mill_tool.h"

#include "core/volume/operations/ray_cast.h"
#include "ui/input/mill_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double wheelStep = 0.5, fineWheelStep = 0.05; // mm a notch
constexpr double largestOffset = 500.0;                 // mm
constexpr int settlingInterval = 120;                   // ms
constexpr int sinkingInterval = 10;                     // ms
constexpr double arrived = 0.1;                         // mm
constexpr double settledWay = 1.0;                      // mm over which the direction of a stroke is determined
constexpr double dragReach = 4.0;                       // pixels: a longer motion is a drag

} // namespace

MillTool::MillTool(SimulatedStylus& stylus, const Tool& tool, std::function<VolumeSnapshot()> view, QObject* parent)
    : QObject(parent)
    , stylus_(stylus)
    , tool_(tool)
    , view_(std::move(view))
    , feed_(stylus, [this](const glm::dvec3& place) { return strokeHeight(view_(), place); })
    , begunBefore_(stylus.strokesBegun())
    , target_(stylus.tip()) {
    settling_.setSingleShot(true);
    settling_.setInterval(settlingInterval);
    connect(&settling_, &QTimer::timeout, this, &MillTool::settle);
    sinking_.setInterval(sinkingInterval);
    connect(&sinking_, &QTimer::timeout, this, &MillTool::sink);
}

void MillTool::setSettings(const MillToolSettings& settings) {
    settings_ = settings;
    emit stateChanged();
}

/// Clear height from the tool's position, and from the end of a stroke that it has still to finish.
double MillTool::clearHeightTo(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    const glm::dvec3 now = stylus_.tip();
    const double height = clearTipHeight(workpiece, tool_.cutter, {now.x, now.y}, {place.x, place.y});
    if (!strokeEnd_) return height;
    return std::max(height,
                    clearTipHeight(workpiece, tool_.cutter, {strokeEnd_->x, strokeEnd_->y}, {place.x, place.y}));
}

void MillTool::hoverAt(const glm::dvec3& place) {
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return;
    target_ = keptWithin(strokeReach(workpiece, tool_.cutter), place);
    wantedHeight_ = place.z;
    target_.z = std::max(place.z, clearHeightTo(workpiece, target_));
    feed_.add({.tip = target_, .finishStroke = true});
    settling_.start();
}

/// The height of a hover clears the complete move; once the tool has arrived, a lower one may suffice.
void MillTool::settle() {
    const glm::dvec3 now = stylus_.tip();
    const VolumeSnapshot workpiece = view_();
    if (stroke_ != Stroke::none || workpiece.empty()) return;
    if (feed_.waits() || stylus_.strokeUnderWay() || std::hypot(now.x - target_.x, now.y - target_.y) > arrived)
        return settling_.start();
    strokeEnd_.reset();
    const glm::dvec2 place(target_.x, target_.y);
    target_.z = std::max(wantedHeight_, clearTipHeight(workpiece, tool_.cutter, place, place));
    feed_.add({.tip = target_, .finishStroke = true});
}

void MillTool::hoverOver(const Sight& sight) {
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return;
    const Grid& grid = workpiece.grid();
    std::optional<glm::dvec3> place;
    if (const std::optional<RayHit> hit = castRay(workpiece, sight.seenOrigin(), sight.direction)) {
        place = hit->place;
        surfaceHeight_ = hit->place.z;
    } else {
        place = onLevel(sight, surfaceHeight_.value_or(grid.box().high.z));
    }
    if (place) hoverAt({place->x, place->y, grid.low().z});
    lastSight_ = sight;
    showAim(aimPress(workpiece, sight));
}

/// Tip position if the button were pressed now: the depth is measured from what is under the pointer.
std::optional<glm::dvec3> MillTool::aimPress(const VolumeSnapshot& workpiece, const Sight& sight) {
    pointedHeight_ = surfaceHeight_.value_or(workpiece.grid().box().high.z);
    levelHeight_ = pointedHeight_ - settings_.depthOfCut;
    if (const auto place = onLevel(sight, pointedHeight_)) lockAnchor_ = *place; // for the stroke that would begin
    return strokePlace(workpiece, sight);
}

void MillTool::showAim(const std::optional<glm::dvec3>& tip) {
    if (!tip && !aimShown_) return;
    aimShown_ = tip.has_value();
    emit pressAimed(tip);
}

/// Along the part, far enough below its surface to press onto the boundary; if there is no part below, the previous
/// depth.
double MillTool::strokeHeight(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    if (settings_.rule == DepthRule::part && !workpiece.empty()) {
        const glm::dvec3 above(place.x, place.y, workpiece.grid().box().high.z + 1.0);
        if (const auto hit = castRay(workpiece, above, {0.0, 0.0, -1.0}, RayTarget::protectedOnly))
            levelHeight_ = hit->place.z - settings_.press;
    }
    return levelHeight_ + wheelOffset_;
}

/// The tip position of a stroke under the pointer; empty if the line of sight does not meet the plane. The pointer
/// draws in the plane of the stroke's start, in plan as seen: hidden surfaces below it move the tool along its axis
/// only.
std::optional<glm::dvec3> MillTool::strokePlace(const VolumeSnapshot& workpiece, const Sight& sight) {
    const auto place = onLevel(sight, pointedHeight_);
    if (!place) return std::nullopt;
    const glm::dvec3 held = locked(lock_, lockAnchor_, lockDirection_, *place);
    glm::dvec3 within = keptWithin(strokeReach(workpiece, tool_.cutter), held);
    within.z = strokeHeight(workpiece, within) + raised_;
    return within;
}

/// The resolution of a fine pointer is higher by that factor.
double MillTool::grainAt(const glm::dvec3& place) const {
    return grain_ ? grain_(place) * (fine_.isFine() ? FinePointer::share : 1.0) : 0.0;
}

void MillTool::cutTo(const glm::dvec3& tip, double clearHeight, double grain) {
    const glm::dvec3 axis = stroke_ == Stroke::pointer && pen_ ? pen_->axis : uprightAxis;
    target_ = tip;
    memory_.add(tip, grain, axis);
    feed_.add({.tip = tip,
               .maximumSpeed = settings_.speed,
               .cutting = true,
               .clearHeight = clearHeight,
               .grain = grain,
               .axis = axis});
}

void MillTool::aim(const Sight& sight) {
    lastSight_ = sight;
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return;
    if (const auto place = strokePlace(workpiece, sight)) cutTo(*place, place->z, grainAt(*place));
}

/// Sets the plane in which the pointer draws: through the point under it.
void MillTool::lookAt(const VolumeSnapshot& workpiece, const Sight& sight) {
    if (const auto hit = castRay(workpiece, sight.seenOrigin(), sight.direction)) surfaceHeight_ = hit->place.z;
    (void)aimPress(workpiece, sight);
}

void MillTool::beginFreeStroke(const ViewportEvent& event) {
    const VolumeSnapshot workpiece = view_();
    const Sight sight = sightOf(event);
    fine_.reset();
    lastSight_ = fine_.follow(sight, event.modifiers.testFlag(Qt::ShiftModifier));
    lookAt(workpiece, sight);
    beginPressure();
    const auto place = aimPress(workpiece, lastSight_);
    if (!place) {
        raised_ = 0.0;
        return;
    }
    showAim({});
    stroke_ = Stroke::pointer;
    if (pen_ && settings_.pen == PenRule::sink) sinking_.start();
    memory_.begin(begunStrokes());
    emit strokeBegins();
    cutTo(*place, clearHeightTo(workpiece, *place), grainAt(*place));
}

bool MillTool::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    notePen(event);
    if (erases()) {
        retract(sightOf(event));
        return true;
    }
    if (stroke_ != Stroke::none || drawing_ != Drawing::none || view_().empty()) return true;
    if (feed_.heightsAreOpen()) return true; // a new stroke would change the level of one that follows the part
    lookingAlong_ = sightOf(event).direction;
    if (settings_.drag == DragRule::raster)
        beginDrawing(Drawing::raster, event);
    else if (event.modifiers.testFlag(Qt::ShiftModifier) && !memory_.empty())
        beginDrawing(Drawing::line, event);
    else
        beginFreeStroke(event);
    emit stateChanged();
    return true;
}

QString MillTool::escapeMeaning() {
    if (drawing_ == Drawing::line) return tr("Esc: cancel the line");
    if (drawing_ == Drawing::raster) return tr("Esc: cancel the raster");
    // Strokes are queued if the hand is faster than the tool.
    if (stroke_ != Stroke::none || feed_.waits() || stylus_.strokeUnderWay())
        return tr("Esc: stop the tool here and drop what it has not milled yet");
    return tr("Esc: stop milling");
}

/// The release was sent elsewhere: to a dialog that opened meanwhile, or to another program.
void MillTool::missRelease() {
    if (std::exchange(drawing_, Drawing::none) != Drawing::none) emit stateChanged();
    if (stroke_ == Stroke::pointer) endStroke(End::finished);
}

void MillTool::strokeTakenBack(bool undo) {
    memory_.takeBack(undo, begunStrokes());
    if (drawing_ == Drawing::line) drawing_ = Drawing::none; // it began at the end of that stroke
    emit stateChanged();
}

bool MillTool::move(const ViewportEvent& event) {
    if (!event.buttons.testFlag(Qt::LeftButton)) missRelease();
    const Sight sight = sightOf(event);
    lookingAlong_ = sight.direction;
    notePen(event);
    if (erases()) {
        retract(sight);
        return true;
    }
    if (stroke_ == Stroke::keyboard) return true;
    if (drawing_ == Drawing::line && std::hypot(event.position.x() - pressed_.position.x(),
                                                event.position.y() - pressed_.position.y()) > dragReach) {
        drawing_ = Drawing::none; // it is a fine stroke
        beginFreeStroke(pressed_);
    }
    if (drawing_ != Drawing::none) {
        draw(event);
    } else if (stroke_ == Stroke::pointer) {
        followPressure();
        aim(fine_.follow(sight, event.modifiers.testFlag(Qt::ShiftModifier)));
    } else if (!feed_.waits()) {
        hoverOver(sight);
    }
    return true;
}

bool MillTool::release(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton) return false;
    if (drawing_ != Drawing::none)
        finishDrawing();
    else if (stroke_ == Stroke::pointer)
        endStroke(End::finished);
    return true;
}

bool MillTool::wheel(const ViewportEvent& event) {
    if (event.modifiers.testFlag(Qt::ControlModifier)) return false;
    const double notch = event.modifiers.testFlag(Qt::ShiftModifier) ? fineWheelStep : wheelStep;
    if (stroke_ == Stroke::keyboard) {
        step({0.0, 0.0, notch * event.wheelSteps});
        return true;
    }
    wheelOffset_ = std::clamp(wheelOffset_ + notch * event.wheelSteps, -largestOffset, largestOffset);
    if (stroke_ == Stroke::pointer) aim(lastSight_);
    if (const VolumeSnapshot now = view_(); aimShown_ && !now.empty()) showAim(aimPress(now, lastSight_));
    emit depthChanged(wheelOffset_);
    return true;
}

/// The spindle stops at the end of the trail, or at the tool's position; from there the tool rises until it is clear.
void MillTool::endStroke(End how) {
    if (stroke_ == Stroke::none && !feed_.waits() && !stylus_.strokeUnderWay()) return;
    const bool drawing = std::exchange(stroke_, Stroke::none) != Stroke::none;
    fine_.reset();
    sinking_.stop();
    raised_ = 0.0;
    if (how == End::givenUp) {
        target_ = stylus_.tip();
        feed_.giveUp({.tip = target_}); // even if there is no workpiece any more
        memory_.giveUp(begunStrokes());
    }
    strokeEnd_ = target_;
    feed_.add({.tip = target_, .finishStroke = true});
    hoverAt(target_);
    if (drawing) emit strokeEnds();
    emit stateChanged();
}

void MillTool::step(const glm::dvec3& way) {
    if (stroke_ == Stroke::pointer || drawing_ != Drawing::none || feed_.waits()) return;
    showAim({});
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return;
    const glm::dvec3 place = keptWithin(strokeReach(workpiece, tool_.cutter), target_ + way);
    if (stroke_ == Stroke::keyboard)
        cutTo(place, place.z, 0.0);
    else
        hoverAt(place);
}

void MillTool::toggleSpindle() {
    if (stroke_ != Stroke::none) return endStroke(End::finished);
    if (view_().empty()) return;
    showAim({});
    stroke_ = Stroke::keyboard;
    memory_.begin(begunStrokes());
    emit strokeBegins();
    cutTo(target_, target_.z, 0.0);
    emit stateChanged();
}

void MillTool::toggleLock(StrokeLock lock) {
    if (lock_ == lock) {
        lock_ = StrokeLock::none;
    } else {
        if (lock == StrokeLock::direction) {
            const auto direction = directionAtEnd(memory_.last().places, settledWay);
            if (!direction) return emit refused(tr("No direction to lock yet. Draw at least 1 mm of a stroke first."));
            lockDirection_ = *direction;
        }
        lock_ = lock;
        lockAnchor_ = target_;
    }
    emit stateChanged();
}

bool MillTool::lockKey(int key) {
    switch (key) {
    case Qt::Key_X:
        toggleLock(StrokeLock::alongX);
        return true;
    case Qt::Key_Y:
        toggleLock(StrokeLock::alongY);
        return true;
    case Qt::Key_D:
        toggleLock(StrokeLock::direction);
        return true;
    default:
        return false;
    }
}

bool MillTool::key(int key, Qt::KeyboardModifiers modifiers) {
    if (key == Qt::Key_Escape) {
        if (drawing_ != Drawing::none) {
            drawing_ = Drawing::none;
            showAim({});
            emit stateChanged();
        } else if (stroke_ == Stroke::none && !feed_.waits() && !stylus_.strokeUnderWay()) {
            emit leaveRequested();
        } else {
            endStroke(End::givenUp);
        }
        return true;
    }
    if (modifiers == Qt::NoModifier && lockKey(key)) return true;
    if (key == Qt::Key_Space) {
        if (stroke_ != Stroke::pointer && drawing_ == Drawing::none) toggleSpindle();
        return true;
    }
    const glm::dvec3 direction = keyStep(key, lookingAlong_);
    if (direction == glm::dvec3(0.0)) return false;
    const VolumeSnapshot workpiece = view_();
    if (workpiece.empty()) return true;
    const double voxels = modifiers.testFlag(Qt::ShiftModifier)     ? 0.1
                          : modifiers.testFlag(Qt::ControlModifier) ? 10.0
                                                                    : 1.0;
    step(direction * (voxels * workpiece.grid().edge()));
    return true;
}

/// A released stroke is finished wherever the pointer goes.
void MillTool::leave() {
    if (std::exchange(drawing_, Drawing::none) != Drawing::none) emit stateChanged();
    showAim({});
    if (stroke_ != Stroke::none) endStroke(End::givenUp);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/mill_mode.h"

#include "ui/input/mill_geometry.h"
#include "ui/input/press_preview.h"

#include <QInputDevice>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// The longest diagonal of a pixel at the image of a point, measured in the point's level plane, mm; 0 if it is not
/// visible.
double pixelDiagonal(const Viewport& viewport, const glm::dvec3& place) {
    const QPointF at = viewport.project(place);
    const double pixel = 1.0 / viewport.devicePixelRatioF();
    const auto from = onLevel(sightOf(viewport.sight(at)), place.z);
    const auto right = onLevel(sightOf(viewport.sight(at + QPointF(pixel, 0.0))), place.z);
    const auto down = onLevel(sightOf(viewport.sight(at + QPointF(0.0, pixel))), place.z);
    if (!from || !right || !down) return 0.0;
    return std::max(glm::length(*right + *down - 2.0 * *from), glm::distance(*right, *down));
}

} // namespace

MillMode::MillMode(Workbench& workbench, Viewport& viewport, QObject* parent)
    : QObject(parent), workbench_(workbench), viewport_(viewport) {
    connect(&workbench.mill, &MillController::entered, this, &MillMode::begin);
    connect(&workbench.mill, &MillController::left, this, &MillMode::end);
    connect(&workbench.mill, &MillController::recordingBegan, this, [this](bool well) {
        if (tool_) well ? tool_->goOn() : tool_->giveUp();
    });
    connect(&workbench.mill, &MillController::strokeTakenBack, this, [this](bool undo) {
        if (tool_) tool_->strokeTakenBack(undo);
    });
    connect(&workbench.session, &SessionRunner::ticked, this, &MillMode::showPlans);
    hasPen_ = std::ranges::any_of(QInputDevice::devices(), [](const QInputDevice* device) {
        return device->type() == QInputDevice::DeviceType::Stylus;
    });
    connect(&viewport, &Viewport::penNoticed, this, [this] {
        if (!std::exchange(hasPen_, true)) emit settingsChanged();
    });
}

MillMode::~MillMode() {
    end();
}

void MillMode::setSettings(const MillToolSettings& settings) {
    settings_ = settings;
    if (tool_) tool_->setSettings(settings_);
    emit settingsChanged();
}

void MillMode::begin() {
    if (workbench_.mill.stylus() == nullptr) return; // a device moves the tool, and the mouse the camera
    tool_ = std::make_unique<MillTool>(*workbench_.mill.stylus(), workbench_.workpiece.milling()->tool,
                                       [this] { return workbench_.session.workpiece(); });
    tool_->setGrain([this](const glm::dvec3& place) { return pixelDiagonal(viewport_, place); });
    tool_->setSettings(settings_);
    connect(tool_.get(), &MillTool::strokeBegins, this, &MillMode::record);
    connect(tool_.get(), &MillTool::stateChanged, this, &MillMode::showPlans);
    connect(tool_.get(), &MillTool::stateChanged, this, &MillMode::toolChanged);
    connect(tool_.get(), &MillTool::refused, this, &MillMode::refused);
    connect(tool_.get(), &MillTool::pressAimed, this, &MillMode::showAim);
    // Queued: otherwise the tool would be deleted while it handles the key.
    connect(tool_.get(), &MillTool::leaveRequested, &workbench_.mill, [this] { workbench_.mill.leave(); });
    viewport_.setInteractiveTool(tool_.get());
    viewport_.setFocus();
    emit toolChanged();
}

void MillMode::showAim(const std::optional<glm::dvec3>& tip) {
    if (!tip || !workbench_.workpiece.milling()) return viewport_.setPressMark({});
    const AxisMode& axis = workbench_.workpiece.bound().axis;
    viewport_.setPressMark(pressPreview(workbench_.session.workpiece(), workbench_.workpiece.milling()->tool.cutter,
                                        *tip, axis.free ? glm::dvec3(0.0, 0.0, 1.0) : axis.direction,
                                        workbench_.mill.allowance()));
}

void MillMode::end() {
    showAim({});
    viewport_.setInteractiveTool(nullptr);
    tool_.reset();
    plans_.clear();
    viewport_.setStrokePlans(plans_);
    emit toolChanged();
}

/// A stroke waits above its start until its recording runs.
void MillMode::record() {
    if (workbench_.mill.startRecording()) tool_->hold();
}

void MillMode::showPlans() {
    if (!tool_) return;
    PlaceChains plans = tool_->plans();
    if (plans == plans_) return; // nothing to redraw
    plans_ = std::move(plans);
    viewport_.setStrokePlans(plans_);
}

void MillMode::repeat(MillTool::Repetition how) {
    if (!tool_) return;
    if (const QString obstacle = tool_->repeat(how); !obstacle.isEmpty()) emit refused(obstacle);
}

} // namespace burin

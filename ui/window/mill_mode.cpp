// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/mill_mode.h"

namespace burin {

MillMode::MillMode(Workbench& workbench, Viewport& viewport, QObject* parent)
    : QObject(parent), workbench_(workbench), viewport_(viewport) {
    connect(&workbench.mill, &MillController::entered, this, &MillMode::begin);
    connect(&workbench.mill, &MillController::left, this, &MillMode::end);
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
    if (workbench_.mill.stylus() == nullptr) return; // a device leads the tool, and the mouse the camera
    tool_ = std::make_unique<MillTool>(*workbench_.mill.stylus(), workbench_.bench.bench()->tool,
                                       [this] { return workbench_.session.workpiece(); });
    tool_->setSettings(settings_);
    connect(tool_.get(), &MillTool::strokeBegins, &workbench_.mill, &MillController::startRecording);
    // Not at once: the tool would be deleted while it handles the key.
    connect(tool_.get(), &MillTool::leaveRequested, &workbench_.mill, [this] { workbench_.mill.leave(); });
    viewport_.setInteractiveTool(tool_.get());
    viewport_.setFocus();
}

void MillMode::end() {
    viewport_.setInteractiveTool(nullptr);
    tool_.reset();
}

} // namespace burin

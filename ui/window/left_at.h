// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "ui/input/mill_tool.h"
#include "ui/panels/job_states.h"
#include "ui/scene/camera_view.h"

#include <QMap>
#include <QString>

#include <optional>
#include <string>

namespace burin {

/// Where the user left a project: what the window shows and is set to, so that it is there again when it is opened.
struct LeftAt {
    JobStep step = JobStep::part;
    bool embedded = false;  ///< the workpiece was there
    std::string tool;       ///< id of the one that was chosen
    std::int64_t setup = 1; ///< number of the one that was worked in
    MillToolSettings mill;
    CameraView camera;
    PlanRegion area;           ///< of the next pass, mm, frame of that setup
    QMap<QString, bool> shown; ///< by the name of the action that switches it: what the view shows
};

/// JSON text that a project keeps (Project::setLeftAt).
std::string toJson(const LeftAt& left);
/// Values that are missing or out of range stay as a new window has them. Nothing: the text says nothing.
std::optional<LeftAt> leftAtFromJson(const std::string& text);

} // namespace burin

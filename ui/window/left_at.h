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
#include <set>
#include <string>

namespace burin {

/// The user's position in a project: what the window shows and how it is set, restored when the project is opened.
struct LeftAt {
    JobStep step = JobStep::part;
    bool embedded = false;  ///< there was a workpiece
    std::string tool;       ///< id of the chosen tool
    std::int64_t setup = 1; ///< number of the setup in use
    MillToolSettings mill;
    CameraView camera;
    PlanRegion area;              ///< of the next pass, mm, frame of that setup
    QMap<QString, bool> shown;    ///< visibility in the view, by the name of the action that switches it
    std::set<std::size_t> hidden; ///< bodies of the model that are not drawn
};

/// JSON text stored in a project (Project::setLeftAt).
std::string toJson(const LeftAt& left);
/// Values that are missing or out of range get the defaults of a new window. Empty if the text is not valid.
std::optional<LeftAt> leftAtFromJson(const std::string& text);

} // namespace burin

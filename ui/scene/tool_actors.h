// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/tool/tool.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

namespace burin {

/// From the tool frame (tip at the origin, axis +Z) to the setup frame, as VTK takes it.
void setPose(vtkMatrix4x4& matrix, const ToolPose& pose);

/// The tool: flutes with their edges, shank and holder told apart. In an alarm shank and holder flash and carry an
/// outline, so that colour alone doesn't tell it.
class ToolActors {
public:
    explicit ToolActors(vtkRenderer& renderer) : renderer_(renderer) {}

    void setPalette(const Palette& palette);
    void setTool(const std::optional<Tool>& tool);
    void setPose(const ToolPose& pose) { burin::setPose(*matrix_, pose); }
    void setVisible(bool visible);
    /// @param lit the bright half of a flash; has no effect without the alarm
    void setAlarm(bool alarm, bool lit);
    void setLineWidth(double screenPixels);
    std::size_t triangles() const;

private:
    enum class Section { flutes, edges, shank, holder, outline };
    struct Drawn {
        Section section = Section::flutes;
        vtkSmartPointer<vtkActor> actor;
    };
    void add(Section section, vtkSmartPointer<vtkActor> actor);
    void refresh();

    vtkRenderer& renderer_;
    vtkNew<vtkMatrix4x4> matrix_;
    std::vector<Drawn> sections_;
    Palette palette_;
    double lineWidth_ = 1.0;
    bool visible_ = true, alarm_ = false, lit_ = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/tool/tool.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/cut_cover.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

namespace burin {

/// Sets a VTK matrix to the transformation from the tool frame (tip at the origin, axis +Z) to the setup frame.
void setPose(vtkMatrix4x4& matrix, const ToolPose& pose);

/// The tool: flutes with their cutting edges, shank and holder, distinguished by colour. In an alarm shank and holder
/// flash and have an outline, so that the alarm is not shown by colour alone. If shank and holder hide the surroundings
/// of the tip from the eye, they fade so that what is behind them becomes visible; in an alarm they never fade.
class ToolActors {
public:
    /// @param solids draws the workpiece, @param films draws translucent surfaces, with the workpiece's depths
    ToolActors(vtkRenderer& solids, vtkRenderer& films) : solids_(solids), films_(films) {}

    void setPalette(const Palette& palette);
    void setTool(const std::optional<Tool>& tool);
    void setPose(const ToolPose& pose);
    void setVisible(bool visible);
    /// @param lit whether the flash is in its bright half; has no effect without the alarm
    void setAlarm(bool alarm, bool lit);
    void setLineWidth(double screenPixels);
    /// Call before each paint.
    void place(const CameraView& view);
    /// The position where the tool cuts, if the tool is visible.
    std::optional<CutPlace> cut() const;
    bool filmsVisible() const noexcept; ///< whether there is something in the films' renderer
    std::size_t triangles() const;

private:
    enum class Section { flutes, edges, shank, holder, outline };
    struct Drawn {
        Section section = Section::flutes;
        vtkSmartPointer<vtkActor> actor;
        vtkSmartPointer<vtkActor> faded; ///< drawn instead while the section hides the tip; null: it never does
    };
    void add(Section section, vtkSmartPointer<vtkActor> actor, vtkSmartPointer<vtkActor> faded = nullptr);
    QColor colourOf(Section section) const;
    void refresh();

    vtkRenderer &solids_, &films_;
    std::optional<Cutter> cutter_;
    ToolPose pose_;
    double opacity_ = 1.0; ///< of shank and holder
    vtkNew<vtkMatrix4x4> matrix_;
    std::vector<Drawn> sections_;
    Palette palette_;
    double lineWidth_ = 1.0;
    bool visible_ = true, alarm_ = false, lit_ = false;
};

} // namespace burin

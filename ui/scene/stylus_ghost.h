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

namespace burin {

/// The position commanded by the hand while the part holds the tool back: the translucent flutes, and the coupling
/// between the two positions as a dashed line.
class StylusGhost {
public:
    explicit StylusGhost(vtkRenderer& renderer);
    void setPalette(const Palette& palette);
    void setTool(const std::optional<Tool>& tool);
    void set(bool wanted, const glm::dvec3& stylusTip, const ToolPose& proxy);
    void setVisible(bool visible);
    void setLineWidth(double screenPixels);
    bool visible() const noexcept { return visible_ && wanted_; }

private:
    void refresh();

    vtkSmartPointer<vtkActor> flutes_, coupling_;
    vtkNew<vtkMatrix4x4> stylus_, interval_;
    bool wanted_ = false, visible_ = true, hasTool_ = false;
};

} // namespace burin

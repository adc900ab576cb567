// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkProp.h>

#include <array>
#include <vector>

namespace burin {

/// Draws actors like coloured glass over what was drawn before. Where several of their surfaces lie behind each other
/// the order in which they come decides what is seen of the farther ones. (Depths first, which would show the nearest
/// alone, left nothing to be seen with this VTK.)
class GlassProp final : public vtkProp {
public:
    static GlassProp* New();
    vtkTypeMacro(GlassProp, vtkProp)

    /// Not owned; they outlive the next paint, and need not be in a renderer.
    void set(std::vector<vtkActor*> actors) { actors_ = std::move(actors); }
    int RenderOpaqueGeometry(vtkViewport* viewport) override;
    double* GetBounds() override;

protected:
    GlassProp() = default;

private:
    std::vector<vtkActor*> actors_;
    std::array<double, 6> bounds_{};
};

} // namespace burin

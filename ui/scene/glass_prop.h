// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkProp.h>

#include <array>
#include <vector>

namespace burin {

/// Draws actors like one body of coloured glass: what was drawn before is seen through the surface that is nearest to
/// the eye, and nothing of the body through itself, in whatever order its parts come. Twice the cost of the actors.
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

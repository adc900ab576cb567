// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkProp.h>

#include <array>
#include <vector>

namespace burin {

/// Draws actors like coloured glass over what was drawn before: of surfaces behind each other only the nearest,
/// regardless of their order. Their depths are drawn first, then their colours.
class GlassProp final : public vtkProp {
public:
    static GlassProp* New();
    vtkTypeMacro(GlassProp, vtkProp)

        /// Not owned; they must outlive the next paint, and need not be in a renderer.
        void set(std::vector<vtkActor*> actors) {
        actors_ = std::move(actors);
    }
    int RenderOpaqueGeometry(vtkViewport* viewport) override;
    double* GetBounds() override;

protected:
    GlassProp() = default;

private:
    int drawAll(vtkViewport* viewport) const;

    std::vector<vtkActor*> actors_;
    std::array<double, 6> bounds_{};
};

} // namespace burin

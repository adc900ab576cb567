// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/gizmo.h"
#include "ui/scene/sight.h"

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// By how much a drag moves or rotates an object.
struct GizmoMotion {
    glm::dvec3 shift{0.0}; ///< mm, setup frame; of arrows and squares
    double angle = 0.0;    ///< rad about the handle's axis, by the right-hand rule; of rings

    friend bool operator==(const GizmoMotion&, const GizmoMotion&) = default;
};

/// The steps to which a motion is rounded.
struct GizmoSteps {
    double length = 0.01; ///< mm
    double angle = 1e-3;  ///< rad
};

/// A drag of one handle, followed by sight lines through the pointer.
class GizmoDrag {
public:
    /// @param centre of the gizmo, mm, setup frame @param start sight line at the press @param radius of the rings, mm
    GizmoDrag(const GizmoHandle& handle, const glm::dvec3& centre, const Sight& start, double radius);

    /// Adds the motion since the last sight line, or nothing if the sight line doesn't determine it (it is parallel to
    /// the axis or to the plane, or leads away from it).
    /// @param share of the pointer's motion that counts: 1, less for fine positioning
    void follow(const Sight& sight, double share);
    /// The motion since the press, rounded to whole steps.
    GizmoMotion motion(const GizmoSteps& steps) const noexcept;
    const GizmoHandle& handle() const noexcept { return handle_; }

private:
    std::optional<glm::dvec3> positionOn(const Sight& sight) const noexcept;

    GizmoHandle handle_;
    glm::dvec3 centre_, axis_;
    double radius_;
    /// Where a ring that is seen from its edge is dragged along its tangent: its point nearest to the eye, as a unit
    /// vector from the centre. Empty: in its plane.
    std::optional<glm::dvec3> edge_{};
    std::optional<glm::dvec3> last_{}; ///< as `positionOn`
    glm::dvec3 shift_{0.0};            ///< not rounded
    double angle_ = 0.0;               ///< likewise
};

/// The intersection of a sight line with a plane, mm. Empty if they are within half a degree of parallel, or if the
/// line leads away from the plane. @param normal unit
std::optional<glm::dvec3> onPlane(const Sight& sight, const glm::dvec3& place, const glm::dvec3& normal) noexcept;

} // namespace burin

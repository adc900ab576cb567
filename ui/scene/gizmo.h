// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QPointF>
#include <QString>

#include <cstdint>
#include <optional>

namespace burin {

/// The kinds of handles of a gizmo.
enum class GizmoPart : std::uint8_t {
    arrow,  ///< moves along an axis
    square, ///< moves in the plane perpendicular to an axis
    ring    ///< rotates about an axis
};

struct GizmoHandle {
    GizmoPart part = GizmoPart::arrow;
    int axis = 0; ///< 0, 1, 2 for x, y, z of the setup frame

    friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// Handles in the view that move and rotate an object along and about the axes of the setup frame.
struct Gizmo {
    glm::dvec3 centre{0.0}; ///< mm, setup frame
    bool upright = false;   ///< whether the object rotates about z only
    bool rotates = true;    ///< whether there are rings

    friend bool operator==(const Gizmo&, const Gizmo&) = default;
};

/// A gizmo as it is drawn.
struct GizmoMark {
    Gizmo gizmo;
    std::optional<GizmoHandle> lit{}; ///< the handle under the pointer, or being dragged
    QString value{};                  ///< of the drag, drawn beside the pointer; empty: none
    QPointF pointer{};                ///< device-independent pixels

    friend bool operator==(const GizmoMark&, const GizmoMark&) = default;
};

} // namespace burin

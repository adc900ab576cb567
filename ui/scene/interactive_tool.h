// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/sight.h"

#include <glm/glm.hpp>

#include <QPointF>
#include <QString>
#include <Qt>

#include <optional>

namespace burin {

/// What a pen reports in addition to a mouse.
struct PenState {
    double pressure = 0.0;          ///< 0 … 1; 0: it does not touch
    glm::dvec3 axis{0.0, 0.0, 1.0}; ///< unit, setup frame, from the tip up: a pen upright on the tablet has +z, one
                                    ///< that leans to the right of the tablet leans to the right in the picture
    bool eraser = false;            ///< its other end is near the tablet
};

/// A pointer event over the viewport, in the setup frame.
struct ViewportEvent {
    QPointF position;                      ///< device-independent pixels from the viewport's top left
    glm::dvec3 rayOrigin{0.0};             ///< mm: origin of the sight line through the pointer
    glm::dvec3 rayDirection{0.0};          ///< unit
    bool parallel = false;                 ///< as in `Sight`
    double seenFrom = 0.0;                 ///< mm, as in `Sight`
    Qt::MouseButton button = Qt::NoButton; ///< the button that changed
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers modifiers;
    double wheelSteps = 0.0;     ///< notches, > 0 away from the user
    std::optional<PenState> pen; ///< empty: the pointer is a mouse
};

/// The sight line through the pointer.
inline Sight sightOf(const ViewportEvent& event) noexcept {
    return {event.rayOrigin, event.rayDirection, event.parallel, event.seenFrom};
}

/// A mode of using the pointer in the viewport: the camera, the mouse as a stylus, … The viewport offers each event to
/// the active tool first; events that it doesn't handle (false) move the camera.
class InteractiveTool {
public:
    virtual ~InteractiveTool() = default;
    virtual bool press(const ViewportEvent&) { return false; }
    virtual bool move(const ViewportEvent&) { return false; }
    virtual bool release(const ViewportEvent&) { return false; }
    virtual bool wheel(const ViewportEvent&) { return false; }
    /// @return whether the key was handled. Esc is passed here as well.
    virtual bool key(int /*key*/, Qt::KeyboardModifiers) { return false; }
    /// The current effect of Esc, a short sentence; empty: none.
    virtual QString escapeMeaning() { return {}; }
    virtual void leave() {} ///< the pointer left the viewport, or the tool was deactivated
};

} // namespace burin

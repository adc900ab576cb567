// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_placement.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <optional>

namespace burin {

/// Places a fixture by the pointer: a click on the stock or on the table beside it, a drag with the left button, or
/// keys. Arrow keys move it as seen by the user, Page Up and Page Down along Z, by 1 mm; with Shift by 0.1 mm, with
/// Ctrl by 10 mm. R rotates it by 15°, Shift+R by 90°. Enter accepts, Esc cancels. Thread: user interface.
class FixturePlacer final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    explicit FixturePlacer(QObject* parent = nullptr) : QObject(parent) {}
    void setSite(const FixtureSite& site) { site_ = site; }

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;

signals:
    /// mm, on the stock or the table; X and Y are multiples of 1 mm from the middle of the stock, except at its sides.
    void placed(const glm::dvec3& point);
    void movedBy(const glm::dvec3& shift); ///< mm
    void turnedBy(double angle);           ///< rad
    void accepted();
    void cancelled();

private:
    std::optional<glm::dvec3> pointOn(const Sight& sight) const;

    FixtureSite site_;
    glm::dvec3 lookingAlong_{0.0, 0.0, -1.0};
    bool dragging_ = false;
};

} // namespace burin

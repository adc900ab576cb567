// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/viewport.h"

#include <QCoreApplication>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWindow>

namespace burin::testing {

/// A pen over the view: sends events to the window, as the platform does.
class TabletPen {
public:
    explicit TabletPen(Viewport& viewport) : viewport_(viewport) {}

    double pressure = 0.0;        ///< 0 … 1, while it touches
    double tiltRight = 0.0;       ///< degrees
    double tiltTowardsUser = 0.0; ///< degrees
    bool eraser = false;

    void hover(const QPointF& at) { send(QEvent::TabletMove, at, Qt::NoButton); }
    void press(const QPointF& at, Qt::MouseButton button = Qt::LeftButton) {
        buttons_ |= button;
        send(QEvent::TabletPress, at, button);
    }
    void drag(const QPointF& at) { send(QEvent::TabletMove, at, Qt::NoButton); }
    void release(const QPointF& at, Qt::MouseButton button = Qt::LeftButton) {
        buttons_ &= ~Qt::MouseButtons(button);
        send(QEvent::TabletRelease, at, button);
    }
    /// The pen is taken away, without a release.
    void leave() {
        buttons_ = Qt::NoButton;
        QTabletEvent event(QEvent::TabletLeaveProximity, &device(), {}, {}, 0.0, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           Qt::NoModifier, Qt::NoButton, Qt::NoButton);
        QCoreApplication::sendEvent(QCoreApplication::instance(), &event);
    }

private:
    const QPointingDevice& device() const { return eraser ? eraser_ : tip_; }
    void send(QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
        QWidget* const window = viewport_.window();
        const QPointF inWindow = viewport_.mapTo(window, at);
        QTabletEvent event(type, &device(), inWindow, window->mapToGlobal(inWindow),
                           buttons_.testFlag(Qt::LeftButton) ? pressure : 0.0, static_cast<float>(tiltRight),
                           static_cast<float>(tiltTowardsUser), 0.0F, 0.0, 0.0F, Qt::NoModifier, button, buttons_);
        QCoreApplication::sendEvent(window->windowHandle(), &event);
    }

    static constexpr auto abilities = QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                                      QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt;
    Viewport& viewport_;
    Qt::MouseButtons buttons_;
    QPointingDevice tip_{
        QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen, abilities, 1, 3};
    QPointingDevice eraser_{QStringLiteral("eraser"),
                            2,
                            QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Eraser,
                            abilities,
                            1,
                            3};
};

} // namespace burin::testing

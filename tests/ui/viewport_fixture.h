// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/places.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/scene/viewport.h"

#include <QApplication>
#include <QDir>
#include <QMainWindow>
#include <QProxyStyle>
#include <QTest>
#include <QWheelEvent>

namespace burin::fixture {

inline const Box stock{{-30.0, -22.0, -4.0}, {30.0, 22.0, 18.0}};
inline const glm::dvec3 radii{24.0, 16.0, 14.0};

/// Style of a desktop that asks for reduced motion.
class StillStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        return hint == SH_Widget_Animation_Duration ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
    }
};

inline ToolMarks marksAt(const glm::dvec3& tip) {
    ToolMarks marks;
    marks.proxy.tip = tip;
    marks.stylusTip = tip;
    return marks;
}

/// A window with a viewport that shows a dome, its stock and a tool, together with the user's input.
class ViewportWindow {
public:
    ViewportWindow() {
        QApplication::setStyle(new StillStyle);
        QDir().mkpath(folder());
        window = std::make_unique<QMainWindow>();
        viewport = new Viewport(window.get());
        window->setCentralWidget(viewport);
        window->resize(1000, 700);
        fill(*viewport);
        window->show();
    }

    static void fill(Viewport& viewport) {
        viewport.setPalette3D(palette());
        viewport.setPart(model(radii));
        viewport.setStockOutline(stock);
        viewport.setTool(ballTool());
        viewport.setToolMarks(marksAt({6.0, -4.0, 20.0}));
    }

    /// Whether the part, which is shaded on another thread, can be seen by now.
    bool ready() {
        if (!window->isVisible() || !viewport->isValid()) return false;
        const QPointF at = viewport->project({0.0, 0.0, 13.0}) * viewport->devicePixelRatio();
        const QColor pixel = viewport->grabFramebuffer().pixelColor(at.toPoint());
        return pixel.blue() > pixel.red() + 60;
    }
    /// Waits until the last motion is over and full detail is drawn; without a workpiece, as long as a motion may take.
    void settle() const {
        QTest::qWait(80); // what was changed is painted first
        const auto still = [this] {
            const FrameStatistics frames = viewport->statistics();
            return frames.fullDetail && !frames.busy;
        };
        (void)QTest::qWaitFor(still, 320);
        QTest::qWait(20);
    }
    void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(viewport, button, modifiers, from);
        for (int i = 1; i <= 5; ++i) {
            const QPoint at = from + (to - from) * i / 5;
            QMouseEvent move(QEvent::MouseMove, at, viewport->mapToGlobal(at), Qt::NoButton, button, modifiers);
            QApplication::sendEvent(viewport, &move);
        }
        QTest::mouseRelease(viewport, button, modifiers, to);
    }
    void wheel(const QPointF& at, int notches) {
        QWheelEvent event(at, viewport->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(viewport, &event);
    }
    /// Saves a picture for visual inspection.
    bool save(const char* name) { return save(name, viewport->grabFramebuffer()); }
    bool save(const char* name, const QImage& picture) const {
        constexpr int quick = 85; // quality as Qt counts it: less compression, in a fraction of the time
        const QString ratio = viewport->devicePixelRatio() > 1.5 ? QStringLiteral("@2x") : QString();
        return picture.save(folder() + QString::fromLatin1(name) + ratio + QStringLiteral(".png"), "PNG", quick);
    }

    std::unique_ptr<QMainWindow> window;
    Viewport* viewport = nullptr;

private:
    static QString folder() { return QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots/"); }
};

} // namespace burin::fixture

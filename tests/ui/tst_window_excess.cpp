// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The workpiece in the colours of the excess stock on the part, by mouse and keys.
#include "core/verify/deviation_scale.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QHelpEvent>
#include <QToolTip>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_window_excess {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

/// Whether a colour is the wanted one under oblique light: red, green and blue are darkened by the same factor.
bool looksLike(const QColor& seen, const DeviationColour& wanted) {
    const double light =
        (seen.red() + seen.green() + seen.blue()) / static_cast<double>(wanted[0] + wanted[1] + wanted[2]);
    const auto near = [light](int a, int b) { return std::abs(a - light * b) < 12.0; };
    return light > 0.5 && light < 1.2 && near(seen.red(), wanted[0]) && near(seen.green(), wanted[1]) &&
           near(seen.blue(), wanted[2]);
}

QColor colourAt(WindowDriver& driver, const glm::dvec3& place) {
    auto& viewport = *driver.visible<Viewport>("viewport");
    const QImage picture = viewport.grabFramebuffer();
    const double ratio = static_cast<double>(picture.width()) / viewport.width();
    return picture.pixelColor((viewport.project(place) * ratio).toPoint());
}

QString toolTipAt(WindowDriver& driver, const glm::dvec3& place) {
    auto& viewport = *driver.visible<Viewport>("viewport");
    const QPoint position = viewport.project(place).toPoint();
    QHelpEvent event(QEvent::ToolTip, position, viewport.mapToGlobal(position));
    QCoreApplication::sendEvent(&viewport, &event);
    return QToolTip::text();
}

} // namespace

class TestWindowExcess : public QObject {
    Q_OBJECT
private slots:
    /// The stock covers the block. A stroke removes some of it, and the stock below the stroke is lighter than beside
    /// it. The pointer reads the excess. Switched off again, the workpiece has the colours of its materials.
    void aStrokeChangesTheColour() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        const Box part = workbenchOf(driver).setup.part()->box();
        const Box stock = workbenchOf(driver).setup.setup().stock;
        const glm::dvec3 top(part.centre().x + 12.0, part.centre().y + 9.0, stock.high.z); // where no mark is drawn
        driver.key(Qt::Key_1);                                                             // from above
        driver.key(Qt::Key_3, Qt::ControlModifier); // otherwise the tool would hide the point
        const QColor material = colourAt(driver, top);
        driver.key(Qt::Key_8, Qt::ControlModifier);
        QTRY_VERIFY(menuAction(driver, "excessAction")->isChecked());
        const DeviationScale scale(DeviationTolerance(), DeviationScale::Reach::milling);
        const double above = stock.high.z - part.high.z;
        QVERIFY(above > 0.3);
        QTRY_VERIFY(looksLike(colourAt(driver, top), scale.colourOf(above)));
        QVERIFY(material != colourAt(driver, top));
        driver.shoot("excess-1-whole");
        QCOMPARE(toolTipAt(driver, top),
                 QStringLiteral("%1 left on the part").arg(lengthText(above, LengthUnit::millimetre)));

        QVERIFY(recordLine(driver, {-10.0, -8.0}, {10.0, -8.0}));
        QVERIFY(driver.settle());
        const glm::dvec3 below(part.centre().x - 5.0, part.centre().y - 8.0, stock.high.z);
        const auto seen = driver.window().viewport().pick(driver.window().viewport().project(below));
        QVERIFY(seen && seen->z < stock.high.z - 0.5);
        QTRY_VERIFY(looksLike(colourAt(driver, *seen), scale.colourOf(seen->z - part.high.z)));
        QTRY_VERIFY(looksLike(colourAt(driver, top), scale.colourOf(above)));
        driver.shoot("excess-2-stroke");
        driver.key(Qt::Key_8, Qt::ControlModifier);
        QTRY_VERIFY(!menuAction(driver, "excessAction")->isChecked());
        QVERIFY(driver.settle());
        driver.shoot("excess-3-off");
    }
};

BURIN_TEST(TestWindowExcess, QApplication)

} // namespace burin::tst_window_excess

#include "tst_window_excess.moc"

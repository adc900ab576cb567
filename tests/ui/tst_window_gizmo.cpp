// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The part and a fixture, moved and rotated by the handles in the view.
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"
#include "ui/panels/fixture_drawing.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/gizmo_geometry.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QtTest>

#include <cmath>

namespace burin::tst_window_gizmo {

using namespace burin::testing;

namespace {

Workbench& workbenchOf(WindowDriver& driver) {
    return driver.window().workbench();
}

bool near(const glm::dvec3& one, const glm::dvec3& other, double within = 1e-6) {
    return glm::distance(one, other) < within;
}

/// A point of a handle where the pointer grips it and no other one, mm; it must be in the picture.
std::optional<glm::dvec3> gripOf(Viewport& viewport, const Gizmo& gizmo, const GizmoHandle& handle) {
    const CameraView& view = viewport.cameraView();
    const QSizeF size(viewport.size());
    const GizmoLine line = handleLine(gizmo, handle, view, pixelAt(view, size, gizmo.centre));
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (const double share : {0.8, 0.5, 0.2}) {
            const glm::dvec3 point = glm::mix(line[i], line[i + 1], share);
            const QPointF pixel = viewport.project(point).toPoint();
            if (handleAt(gizmo, view, size, pixel) == handle) return point;
        }
    return std::nullopt;
}

/// A drag with the left button that isn't released yet.
void drag(Viewport& viewport, const glm::dvec3& from, const glm::dvec3& to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&viewport, Qt::LeftButton, {}, viewport.project(from).toPoint());
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const QPointF place(viewport.project(glm::mix(from, to, share)).toPoint());
        QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QApplication::sendEvent(&viewport, &move);
    }
}

void release(Viewport& viewport, const glm::dvec3& at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseRelease(&viewport, Qt::LeftButton, modifiers, viewport.project(at).toPoint());
}

/// The block of 40 x 30 x 20 mm in the part step.
bool showPart(WindowDriver& driver) {
    drop(driver.window(), writeBlock(driver));
    if (!driver.waitFor([&] { return workbenchOf(driver).setup.hasPart(); })) return false;
    if (!driver.settle() || !driver.step(JobStep::part)) return false;
    QTest::qWait(500);
    return true;
}

Gizmo gizmoOfPart(WindowDriver& driver) {
    return {workbenchOf(driver).setup.part()->box().centre(), false};
}

} // namespace

class TestWindowGizmo : public QObject {
    Q_OBJECT
private slots:
    /// An arrow moves the part along its axis alone; that is one undo step. Ctrl: by whole millimetres.
    void anArrowMovesThePart() {
        WindowDriver driver;
        QVERIFY(showPart(driver));
        Viewport& viewport = driver.window().viewport();
        const SetupController& setup = workbenchOf(driver).setup;
        const Gizmo gizmo = gizmoOfPart(driver);
        const auto grip = gripOf(viewport, gizmo, {GizmoPart::arrow, 0});
        QVERIFY(grip);
        QTest::mouseMove(&viewport, viewport.project(*grip).toPoint());
        QTest::qWait(300);
        driver.shoot("gizmo-1-hovered");
        const glm::dvec3 to = *grip + glm::dvec3(12.0, 0.0, 0.0);
        const int steps = workbenchOf(driver).undo().count();
        drag(viewport, *grip, to);
        QTest::qWait(400);
        driver.shoot("gizmo-2-dragged");
        QVERIFY(isNone(setup.setup().placement)); // not before the release
        release(viewport, to);
        QTRY_VERIFY(!isNone(setup.setup().placement));
        const Placement moved = setup.setup().placement;
        QVERIFY2(std::abs(moved.shift.x - 12.0) < 0.5, qPrintable(QString::number(moved.shift.x)));
        QVERIFY(moved.shift.y == 0.0 && moved.shift.z == 0.0 && moved.turn == glm::dmat3(1.0));
        QVERIFY(std::abs(100.0 * moved.shift.x - std::round(100.0 * moved.shift.x)) < 1e-6); // as it was displayed
        QCOMPARE(workbenchOf(driver).undo().count(), steps + 1);
        QVERIFY(driver.settle());
        QTest::qWait(400);
        driver.shoot("gizmo-3-moved");
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(isNone(setup.setup().placement));
        QVERIFY(driver.settle());
        QTest::qWait(300);

        drag(viewport, *grip, to, Qt::ControlModifier);
        release(viewport, to, Qt::ControlModifier);
        QTRY_VERIFY(near(setup.setup().placement.shift, {12.0, 0.0, 0.0}));
    }

    /// A ring rotates about the centre of the part: by whole steps of 5° with Ctrl. Esc gives a drag up.
    void aRingRotatesThePart() {
        WindowDriver driver;
        QVERIFY(showPart(driver));
        Viewport& viewport = driver.window().viewport();
        const SetupController& setup = workbenchOf(driver).setup;
        const Gizmo gizmo = gizmoOfPart(driver);
        const auto grip = gripOf(viewport, gizmo, {GizmoPart::ring, 2});
        QVERIFY(grip);
        const glm::dvec3 to = turnedAbout({0.0, 0.0, 1.0}, pi / 6.0, gizmo.centre).point(*grip);
        drag(viewport, *grip, to, Qt::ControlModifier);
        QTest::qWait(300);
        driver.shoot("gizmo-4-rotated");
        viewport.setFocus();
        QTest::keyClick(&viewport, Qt::Key_Escape);
        release(viewport, to, Qt::ControlModifier);
        QTest::qWait(300);
        QVERIFY(isNone(setup.setup().placement));
        driver.shoot("gizmo-5-given-up");

        drag(viewport, *grip, to, Qt::ControlModifier);
        release(viewport, to, Qt::ControlModifier);
        QTRY_VERIFY(!isNone(setup.setup().placement));
        const double cosine = std::cos(pi / 6.0), sine = 0.5;
        QTRY_VERIFY(near(setup.part()->box().size(), {40.0 * cosine + 30.0 * sine, 40.0 * sine + 30.0 * cosine, 20.0}));
        QVERIFY(near(setup.part()->box().centre(), gizmo.centre));
    }

    /// A click changes nothing; without the switch, or where the part may not be placed, there is no gizmo.
    void thereIsNoGizmoWhereNothingMayBePlaced() {
        WindowDriver driver;
        QVERIFY(showPart(driver));
        Viewport& viewport = driver.window().viewport();
        SetupController& setup = workbenchOf(driver).setup;
        const auto grip = gripOf(viewport, gizmoOfPart(driver), {GizmoPart::arrow, 0});
        QVERIFY(grip);
        const glm::dvec3 to = *grip + glm::dvec3(9.0, 0.0, 0.0);
        const int steps = workbenchOf(driver).undo().count();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.project(*grip).toPoint());
        const auto movesNothing = [&] {
            QTest::qWait(200);
            drag(viewport, *grip, to);
            release(viewport, to);
            QTest::qWait(200);
            return isNone(setup.setup().placement) && workbenchOf(driver).undo().count() == steps;
        };
        driver.key(Qt::Key_M, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(!menuAction(driver, "placementHandlesAction")->isChecked());
        QVERIFY(movesNothing());
        QVERIFY(driver.restart(true)); // it stays off
        QVERIFY(!menuAction(driver, "placementHandlesAction")->isChecked());
    }

    void aLockedPartHasNoGizmo() {
        WindowDriver driver;
        QVERIFY(showPart(driver));
        Viewport& viewport = driver.window().viewport();
        SetupController& setup = workbenchOf(driver).setup;
        const auto grip = gripOf(viewport, gizmoOfPart(driver), {GizmoPart::arrow, 0});
        QVERIFY(grip);
        setup.setLocked(true); // as recordings do
        QTest::qWait(300);
        driver.shoot("gizmo-6-locked");
        drag(viewport, *grip, *grip + glm::dvec3(9.0, 0.0, 0.0));
        release(viewport, *grip + glm::dvec3(9.0, 0.0, 0.0));
        QTest::qWait(200);
        QVERIFY(isNone(setup.setup().placement));
    }

    /// A fixture that is being placed: moved and rotated about Z; Esc gives up the drag, not the fixture.
    void aFixtureFollowsItsHandles() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        Viewport& viewport = driver.window().viewport();
        FixtureController& fixtures = workbenchOf(driver).fixtures;
        driver.key(Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(driver.visible("fixtureDialog") != nullptr);
        auto* kinds = driver.visible<QComboBox>("fixtureKind");
        kinds->setFocus();
        QTest::keyClick(kinds, Qt::Key_Home);
        QTest::keyClick(kinds, Qt::Key_Down); // the step clamp
        QTRY_COMPARE(fixtures.design().kind, FixtureKind::stepClamp);
        QTest::qWait(500);
        const FixtureDesign before = fixtures.design();
        const Gizmo gizmo{before.place, true};
        const auto arrow = gripOf(viewport, gizmo, {GizmoPart::arrow, 1}),
                   ring = gripOf(viewport, gizmo, {GizmoPart::ring, 2});
        QVERIFY(arrow && ring);
        const glm::dvec3 to = *arrow + glm::dvec3(0.0, 6.0, 0.0);
        drag(viewport, *arrow, to, Qt::ControlModifier);
        QVERIFY(near(fixtures.design().place, before.place + glm::dvec3(0.0, 6.0, 0.0)));
        QTest::qWait(300);
        driver.shoot("gizmo-7-fixture");
        viewport.setFocus();
        QTest::keyClick(&viewport, Qt::Key_Escape);
        release(viewport, to);
        QVERIFY(fixtures.placing() && fixtures.design() == before);

        drag(viewport, *arrow, to, Qt::ControlModifier);
        release(viewport, to, Qt::ControlModifier);
        QVERIFY(near(fixtures.design().place, before.place + glm::dvec3(0.0, 6.0, 0.0)));
        QTest::qWait(200);
        const glm::dvec3 shift(0.0, 6.0, 0.0),
            turned = turnedAbout({0.0, 0.0, 1.0}, pi / 9.0, gizmo.centre + shift).point(*ring + shift);
        drag(viewport, *ring + shift, turned, Qt::ControlModifier);
        release(viewport, turned, Qt::ControlModifier);
        QVERIFY2(std::abs(std::remainder(fixtures.design().turn - before.turn - pi / 9.0, 2.0 * pi)) < 1e-9,
                 qPrintable(QString::number(glm::degrees(fixtures.design().turn - before.turn))));
    }

    /// A box of no library, moved by an arrow, the keys and its card: one undo step. It has no rings, as its edges stay
    /// parallel to the axes; R turns it by 90°. Esc leaves it where it was. A cylinder has rings.
    void anyOtherFixtureFollowsItsHandles() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        Viewport& viewport = driver.window().viewport();
        SurroundingsController& surroundings = workbenchOf(driver).surroundings;
        ObstacleMover& mover = workbenchOf(driver).mover;
        surroundings.addBox(ObstacleKind::fixture);
        const auto box = [&] { return std::get<Box>(surroundings.obstacles().front().obstacle->shape); };
        const Box before = box();
        mover.begin(0);
        QTRY_VERIFY(driver.visible("obstacle0Change") != nullptr);
        QTest::qWait(500);
        const Gizmo gizmo{before.centre(), false, false};
        const auto arrow = gripOf(viewport, gizmo, {GizmoPart::arrow, 1});
        QVERIFY(arrow && !gripOf(viewport, gizmo, {GizmoPart::ring, 2}));
        const glm::dvec3 to = *arrow + glm::dvec3(0.0, 6.0, 0.0);
        drag(viewport, *arrow, to, Qt::ControlModifier);
        QTest::qWait(300);
        driver.shoot("gizmo-8-box");
        release(viewport, to, Qt::ControlModifier);
        QVERIFY(near(mover.motion().shift, {0.0, 6.0, 0.0}));
        QVERIFY(box().low == before.low); // not before it is accepted
        viewport.setFocus();
        QTest::keyClick(&viewport, Qt::Key_PageUp);
        QTest::keyClick(&viewport, Qt::Key_R);
        const int steps = workbenchOf(driver).undo().count();
        QVERIFY(driver.clickOn("obstacle0Change"));
        QTRY_VERIFY(!mover.moving());
        QCOMPARE(workbenchOf(driver).undo().count(), steps + 1);
        QVERIFY(near(box().centre(), before.centre() + glm::dvec3(0.0, 6.0, 1.0)));
        QVERIFY(near(box().size(), before.size()));
        driver.key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(box().low == before.low);

        mover.begin(0);
        QTest::keyClick(&viewport, Qt::Key_PageUp);
        QVERIFY(near(mover.centre(), before.centre() + glm::dvec3(0.0, 0.0, 1.0)));
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QTRY_VERIFY(!mover.moving());
        QVERIFY(box().low == before.low && viewport.interactiveTool() == nullptr);

        surroundings.addCylinder(ObstacleKind::keepOut);
        mover.begin(1);
        QTest::qWait(500);
        const auto ring = gripOf(viewport, {mover.centre(), false, true}, {GizmoPart::ring, 0});
        QVERIFY(ring);
        const glm::dvec3 turned = turnedAbout({1.0, 0.0, 0.0}, pi / 6.0, mover.centre()).point(*ring);
        drag(viewport, *ring, turned, Qt::ControlModifier);
        release(viewport, turned, Qt::ControlModifier);
        QTest::qWait(300);
        driver.shoot("gizmo-9-cylinder");
        QTest::keyClick(&viewport, Qt::Key_Return);
        QTRY_VERIFY(!mover.moving());
        const auto cylinder = std::get<CylinderShape>(surroundings.obstacles().back().obstacle->shape);
        QVERIFY(near(cylinder.axis, {0.0, -0.5, std::sqrt(0.75)}));
    }

    /// The drawing marks the size that is being edited.
    void theDrawingMarksTheEditedSize() {
        WindowDriver driver;
        QVERIFY(makeReady(driver, 1.0));
        driver.key(Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(driver.visible("fixtureDialog") != nullptr);
        auto* drawing = driver.visible<FixtureDrawing>("fixtureDrawing");
        QVERIFY(drawing != nullptr && !drawing->marked());
        const FixtureController& fixtures = workbenchOf(driver).fixtures;
        auto* kinds = driver.visible<QComboBox>("fixtureKind");
        for (int i = 0; i < kinds->count(); ++i) {
            kinds->setFocus();
            QVERIFY(!kinds->itemIcon(i).isNull());
            QTest::keyClick(kinds, Qt::Key_Home);
            for (int down = 0; down < i; ++down) QTest::keyClick(kinds, Qt::Key_Down);
            const FixtureKind kind = fixtures.design().kind;
            QCOMPARE(static_cast<int>(kind), i);
            QTest::qWait(100);
            const FixtureKindRow& row = rowOf(kind);
            auto* field = driver.visible(qPrintable(QStringLiteral("fixture-") + row.parameters[1].key));
            QVERIFY(field != nullptr);
            QApplication::setActiveWindow(field->window());
            field->setFocus();
            QTRY_COMPARE(drawing->marked(), std::optional(std::size_t{1}));
        }
        kinds->setFocus();
        QTRY_VERIFY(!drawing->marked());
    }
};

BURIN_TEST(TestWindowGizmo, QApplication)

} // namespace burin::tst_window_gizmo

#include "tst_window_gizmo.moc"

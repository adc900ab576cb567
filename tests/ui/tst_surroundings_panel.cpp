// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/bounds_panel.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/surroundings_panel.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include <cmath>

namespace burin::tst_surroundings_panel {

namespace {

ObstacleRow rowOf(const char* name, std::variant<Box, CylinderShape, TriangleMesh> shape) {
    Obstacle obstacle;
    obstacle.name = name;
    obstacle.shape = std::move(shape);
    obstacle.margin = 1.0;
    return {std::make_shared<const Obstacle>(std::move(obstacle)), true, BoundNews::none};
}

SurroundingsState viseAndPost() {
    SurroundingsState state;
    state.hasPart = true;
    state.zero = {10, 20, 30};
    state.obstacles = {rowOf("Vise", Box{{0, 0, 0}, {40, 10, 15}}),
                       rowOf("Post", CylinderShape{{60, 20, 0}, {0, 0, 1}, 6.0, 25.0})};
    return state;
}

} // namespace

class TestSurroundingsPanel : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    void obstaclesAreAddedSwitchedAndRemoved() {
        SurroundingsPanel panel;
        show(panel);
        QVERIFY(!child<QPushButton>(panel, "addObstacleButton").isEnabled()); // there is no part
        panel.setState(viseAndPost());
        QSignalSpy wanted(&panel, &SurroundingsPanel::additionRequested),
            switched(&panel, &SurroundingsPanel::obstacleSwitched),
            removed(&panel, &SurroundingsPanel::obstacleRemovalRequested);
        child<ChoiceBox>(panel, "obstacleAddition").setCurrentIndex(3);
        click(panel, "addObstacleButton");
        QCOMPARE(qvariant_cast<SurroundingsPanel::Addition>(wanted[0][0]), SurroundingsPanel::Addition::keepOutBox);
        QTest::mouseClick(&child<QCheckBox>(panel, "obstacle1Switch"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(switched[0][0].value<std::size_t>(), std::size_t{1});
        QCOMPARE(switched[0][1].toBool(), false);
        click(panel, "obstacle0Remove");
        QCOMPARE(removed[0][0].value<std::size_t>(), std::size_t{0});
        SurroundingsState recording = viseAndPost();
        recording.locked = true; // fixtures of a take cannot be changed; a switch can be used
        panel.setState(recording);
        QVERIFY(!child<QDoubleSpinBox>(panel, "obstacle0SizeX").isEnabled());
        QVERIFY(!child<QToolButton>(panel, "obstacle0Remove").isEnabled());
        QVERIFY(child<QCheckBox>(panel, "obstacle0Switch").isEnabled());
        QVERIFY(!child<ChoiceBox>(panel, "axisChoice").isEnabled());
    }

    void shapesAreEditedFromProgramZero() {
        SurroundingsPanel panel;
        panel.setState(viseAndPost());
        show(panel);
        std::vector<std::pair<std::size_t, Obstacle>> edits;
        connect(&panel, &SurroundingsPanel::obstacleEdited, this,
                [&](std::size_t place, const Obstacle& obstacle) { edits.emplace_back(place, obstacle); });
        QCOMPARE(child<QDoubleSpinBox>(panel, "obstacle0PlaceX").value(), -10.0);
        type(panel, "obstacle0PlaceX", "5");
        QCOMPARE(std::get<Box>(edits.back().second.shape).low, glm::dvec3(15, 0, 0));
        QCOMPARE(std::get<Box>(edits.back().second.shape).high, glm::dvec3(55, 10, 15)); // moved, with the same size
        type(panel, "obstacle0SizeZ", "20");
        QCOMPARE(std::get<Box>(edits.back().second.shape).high.z, 20.0);
        type(panel, "obstacle1Diameter", "10");
        QCOMPARE(edits.back().first, std::size_t{1});
        QCOMPARE(std::get<CylinderShape>(edits.back().second.shape).radius, 5.0);
        type(panel, "obstacle1Margin", "2.5");
        QCOMPARE(edits.back().second.margin, 2.5);
        emit child<ChoiceBox>(panel, "obstacle1Kind").activated(1);
        QVERIFY(edits.back().second.kind == ObstacleKind::keepOut);
    }

    void theAxisIsChosen() {
        SurroundingsPanel panel;
        SurroundingsState state = viseAndPost();
        panel.setState(state);
        show(panel);
        std::vector<AxisMode> chosen;
        connect(&panel, &SurroundingsPanel::axisChosen, this, [&](const AxisMode& axis) { chosen.push_back(axis); });
        QSignalSpy ofView(&panel, &SurroundingsPanel::axisOfViewRequested);
        auto& choice = child<ChoiceBox>(panel, "axisChoice");
        QVERIFY(!child<QDoubleSpinBox>(panel, "axisLeanField").isVisible());
        emit choice.activated(1);
        QVERIFY(child<QDoubleSpinBox>(panel, "axisLeanField").isVisible());
        panel.setState(state); // the tilt was requested, and the tool is still upright
        QVERIFY(child<QDoubleSpinBox>(panel, "axisLeanField").isVisible());
        click(panel, "axisOfViewButton");
        QCOMPARE(ofView.size(), 1);
        type(panel, "axisLeanField", "30");
        QVERIFY(!chosen.back().free);
        QVERIFY(std::abs(chosen.back().direction.x - 0.5) < 1e-9 && std::abs(chosen.back().direction.y) < 1e-9);
        state.axis = chosen.back();
        panel.setState(state);
        type(panel, "axisHeadingField", "90");
        QVERIFY(std::abs(chosen.back().direction.y - 0.5) < 1e-9 && std::abs(chosen.back().direction.x) < 1e-9);
        QVERIFY(!child<QCheckBox>(panel, "travelSwitch").isEnabled()); // the travel that a tilted tool needs is unknown
        emit choice.activated(2);
        QVERIFY(chosen.back().free);
        emit choice.activated(0);
        QVERIFY(!chosen.back().free && chosen.back().direction == glm::dvec3(0, 0, 1));
    }

    void whatHoldsIsToldBesideItsSwitch() {
        BoundsPanel panel;
        SurroundingsState state = viseAndPost();
        state.obstacles[0].news = BoundNews::holds;
        state.obstacles[1].news = BoundNews::waits;
        state.obstacles[1].on = false;
        show(panel);
        panel.setState(state);
        QVERIFY(panel.isVisible());
        QCOMPARE(child<QLabel>(panel, "bound0News").text(), QStringLiteral("holds the tool"));
        QVERIFY(child<QLabel>(panel, "bound1News").text().contains(QStringLiteral("waits")));
        QVERIFY(!child<QCheckBox>(panel, "bound1Switch").isChecked());
        QSignalSpy switched(&panel, &BoundsPanel::obstacleSwitched), travel(&panel, &BoundsPanel::travelSwitched);
        QTest::mouseClick(&child<QCheckBox>(panel, "bound0Switch"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(switched[0][1].toBool(), false);
        QTest::mouseClick(&child<QCheckBox>(panel, "boundTravelSwitch"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(travel.size(), 1);
        state.obstacles.clear();
        state.axis.free = true;
        panel.setState(state);
        QVERIFY(!panel.isVisible());
    }
};

BURIN_TEST(TestSurroundingsPanel, QApplication)

} // namespace burin::tst_surroundings_panel

#include "tst_surroundings_panel.moc"

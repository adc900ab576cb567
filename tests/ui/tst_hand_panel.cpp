// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/hand_panel.h"
#include "ui/panels/notice.h"
#include "ui/panels/value_row.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QPushButton>
#include <QSignalSpy>

namespace burin::tst_hand_panel {

namespace {

HandState armInHand() {
    HandState state;
    state.hasDevice = state.motors = true;
    state.scale = 0.5;
    state.buttons = 3;
    return state;
}

} // namespace

class TestHandPanel : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    void aDevicesWayIsScaledTheMousesIsNot() {
        HandPanel panel;
        show(panel);
        QVERIFY(child<Notice>(panel, "workspaceNotice").isVisible());
        QVERIFY(!child<QDoubleSpinBox>(panel, "workspaceScaleField").isEnabled());
        QVERIFY(!child<QPushButton>(panel, "clutchButton").isEnabled());
        QVERIFY(!child<ChoiceBox>(panel, "forceButtonChoice").isVisible());
        panel.setState(armInHand());
        QVERIFY(!child<Notice>(panel, "workspaceNotice").isVisible());
        QSignalSpy scaled(&panel, &HandPanel::scaleEdited), clutched(&panel, &HandPanel::clutchToggled),
            recentred(&panel, &HandPanel::recentreRequested), aligned(&panel, &HandPanel::alignmentRequested);
        type(panel, "workspaceScaleField", "2");
        QCOMPARE(scaled[0][0].toDouble(), 2.0);
        click(panel, "clutchButton");
        QCOMPARE(clutched[0][0].toBool(), true);
        QVERIFY(!child<QPushButton>(panel, "clutchButton").isChecked()); // only a request until the state confirms it
        click(panel, "recentreButton");
        QCOMPARE(recentred.size(), 1);
        click(panel, "alignHandButton");
        QCOMPARE(aligned.size(), 1);
    }

    void onlyAStylusWithoutMotorsMaySetTheSpeed() {
        HandPanel panel;
        panel.setState(armInHand());
        show(panel);
        QVERIFY(!child<QPushButton>(panel, "rateControlButton").isVisible());
        HandState cap = armInHand();
        cap.motors = false;
        cap.canRate = true;
        panel.setState(cap);
        QVERIFY(!child<ChoiceBox>(panel, "forceButtonChoice").isVisible()); // there are no forces to be held
        QSignalSpy rated(&panel, &HandPanel::rateToggled);
        click(panel, "placeControlButton"); // position control is already in use
        QCOMPARE(rated.size(), 0);
        click(panel, "rateControlButton");
        QCOMPARE(rated[0][0].toBool(), true);
        cap.rate = true;
        panel.setState(cap);
        QVERIFY(child<QPushButton>(panel, "rateControlButton").isChecked());
    }

    void buttonsGetTheirMeaning() {
        HandPanel panel;
        HandState state = armInHand();
        state.forceButton = 3;
        panel.setState(state);
        show(panel);
        auto& force = child<ChoiceBox>(panel, "forceButtonChoice");
        auto& clutch = child<ChoiceBox>(panel, "clutchButtonChoice");
        QCOMPARE(force.count(), 4);  // always, and three buttons
        QCOMPARE(clutch.count(), 3); // the first button turns the spindle
        QCOMPARE(force.currentText(), QStringLiteral("button 3"));
        QSignalSpy forced(&panel, &HandPanel::forceButtonChosen), clutched(&panel, &HandPanel::clutchButtonChosen);
        emit force.activated(0);
        emit clutch.activated(1);
        QCOMPARE(forced[0][0].toInt(), 0);
        QCOMPARE(clutched[0][0].toInt(), 2);
        state.recording = true; // the change would end the take
        panel.setState(state);
        QVERIFY(!force.isEnabled());
        state.buttons = 0;
        panel.setState(state);
        QVERIFY(!force.isVisible() && !clutch.isVisible());
    }

    void whatTheDeviceTellsOfItselfIsShown() {
        HandPanel panel;
        HandState state = armInHand();
        panel.setState(state);
        show(panel);
        QVERIFY(!child<ValueRow>(panel, "batteryRow").isVisible());
        QVERIFY(!child<ValueRow>(panel, "heatRow").isVisible());
        state.battery = 0.42;
        state.heat = 0.635;
        panel.setState(state);
        QCOMPARE(plain(child<ValueRow>(panel, "batteryRow").value()), QStringLiteral("42 %"));
        QCOMPARE(plain(child<ValueRow>(panel, "heatRow").value()), QStringLiteral("64 %"));
        state.charging = true;
        panel.setState(state);
        QCOMPARE(plain(child<ValueRow>(panel, "batteryRow").value()), QStringLiteral("42 %, charging"));
    }
};

BURIN_TEST(TestHandPanel, QApplication)

} // namespace burin::tst_hand_panel

#include "tst_hand_panel.moc"

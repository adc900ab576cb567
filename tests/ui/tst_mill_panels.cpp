// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/panel_examples.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/meter_bar.h"
#include "ui/panels/meters.h"
#include "ui/panels/mill_panel.h"
#include "ui/panels/notice.h"
#include "ui/panels/step_bar.h"
#include "ui/panels/take_list.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

namespace burin::tst_mill_panels {

class TestMillPanels : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    /// Each notice appears by itself, while the user is moving to a button or typing.
    void noticesMoveNothing_data() {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("short") << QStringLiteral("The machine's travel ends here.");
        QTest::newRow("long") << QStringLiteral(
            "There is no boundary for the tool: choose another tool, or embed again, with larger voxels where memory "
            "was short, or end other programs that take it, or take a smaller stock, or all of these together.");
    }
    void noticesMoveNothing() {
        QFETCH(QString, sentence);
        MillPanel panel;
        MillState quiet = examples::mill();
        quiet.alarm = quiet.hint = quiet.lock = quiet.missing = QString();
        quiet.recording = false;
        panel.setState(quiet);
        show(panel);
        const auto before = controlsOf(panel);
        QVERIFY(before.size() > 8);
        auto& field = child<QDoubleSpinBox>(panel, "speedField");
        field.setFocus(Qt::TabFocusReason);
        field.selectAll();
        const std::pair<QString MillState::*, const char*> notices[] = {
            {&MillState::lock, "millLock"}, {&MillState::hint, "millHint"}, {&MillState::alarm, "millAlarm"}};
        for (const auto& [text, name] : notices) {
            MillState state = quiet;
            state.*text = sentence;
            panel.setState(state);
            QVERIFY(controlsOf(panel) == before);
            auto& notice = child<Notice>(panel, name);
            QVERIFY(notice.isVisible());
            QVERIFY(notice.sentence() == sentence && notice.geometry().bottom() < notice.parentWidget()->height());
            auto* label = notice.findChild<QLabel*>();
            QVERIFY(label->text().endsWith(QChar(0x2026)) ? notice.toolTip() == sentence
                                                          : plain(label->text()).remove(QChar(0x200B)) == sentence);
            QTest::keyClick(&field, Qt::Key_1);
            panel.setState(quiet);
            QVERIFY(controlsOf(panel) == before);
        }
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.value(), 111.0);
    }

    /// Controls below the list keep their positions, on the panel and on the rest of the page; the newest take is
    /// visible.
    void takesMoveNothing() {
        MillPanel panel;
        MillState state = examples::mill();
        state.takes.clear();
        panel.setState(state);
        show(panel);
        const auto outside = [&panel] {
            auto controls = controlsOf(panel);
            const auto& list = child<TakeList>(panel, "takeList");
            std::erase_if(controls, [&list](const auto& control) { return list.isAncestorOf(control.first); });
            return controls;
        };
        const auto before = outside();
        QVERIFY(before.contains(&child<QWidget>(panel, "showMeButton")));
        const int height = panel.heightForWidth(panelWidth);
        for (int takes = 1; takes <= 8; ++takes) {
            state.takes.push_back(examples::take(takes, "Take", 58210, 12));
            panel.setState(state);
            QVERIFY(outside() == before);
            QCOMPARE(panel.heightForWidth(panelWidth), height);
            const auto& newest = child<QWidget>(panel, qPrintable(QStringLiteral("removeTake%1").arg(takes)));
            QCOMPARE(newest.visibleRegion().boundingRect(), newest.rect());
        }
        state.takes.clear();
        panel.setState(state);
        QVERIFY(outside() == before);
    }

    void millingIsLedByItsButtons() {
        MillPanel panel;
        MillState state = examples::mill();
        state.recording = state.active = false;
        panel.setState(state);
        show(panel);
        QSignalSpy mill(&panel, &MillPanel::millModeToggled), undo(&panel, &MillPanel::undoStrokeRequested),
            redo(&panel, &MillPanel::redoStrokeRequested), showMe(&panel, &MillPanel::showMeRequested),
            remove(&panel, &MillPanel::takeRemovalRequested);
        click(panel, "millButton");
        QCOMPARE(mill.size(), 1);
        QCOMPARE(mill[0][0].toBool(), true);
        QVERIFY(!child<QPushButton>(panel, "millButton").isChecked()); // only a request until the state confirms it
        click(panel, "undoStrokeButton");
        click(panel, "redoStrokeButton"); // there is no stroke to redo
        click(panel, "showMeButton");
        click(panel, "removeTake2");
        QCOMPARE(undo.size(), 1);
        QCOMPARE(redo.size(), 0);
        QCOMPARE(showMe.size(), 1);
        QCOMPARE(remove.size(), 1);
        QCOMPARE(remove[0][0].toLongLong(), 2);
        panel.setState(examples::mill());
        QCOMPARE(child<QPushButton>(panel, "millButton").text(), QStringLiteral("Stop, recorded 01:42"));
        QVERIFY(child<QPushButton>(panel, "millButton").isChecked());
        QVERIFY(child<Notice>(panel, "millAlarm").isVisible());
        click(panel, "millButton");
        click(panel, "removeTake2"); // impossible while a take is recorded
        QCOMPARE(mill[1][0].toBool(), false);
        QCOMPARE(remove.size(), 1);
        state.ready = false;
        state.missing = QStringLiteral("Embed the part first.");
        panel.setState(state);
        click(panel, "millButton");
        QCOMPARE(mill.size(), 2);
        QCOMPARE(child<Notice>(panel, "millMissing").sentence(), state.missing);
    }

    /// A take shows the tool's name and the recorded amounts; the number of samples of a growing take is known only at
    /// its end.
    void takesSayWhatTheyHold() {
        MillPanel panel;
        MillState state = examples::mill();
        state.takes[1].recording = true;
        state.takes[1].info.seconds = 12.0;
        panel.setState(state);
        show(panel);
        QStringList texts;
        for (const ElidedLabel* label : panel.findChild<TakeList*>()->findChildren<ElidedLabel*>())
            texts.append(label->text());
        QVERIFY2(texts.contains(QStringLiteral("Ball-end mill 6 mm · 12 strokes · 58,210 samples")),
                 qPrintable(texts.join(QLatin1Char('\n'))));
        QVERIFY(texts.contains(QStringLiteral("Ball-end mill 6 mm · 1 stroke · recording")));
    }

    /// Devices come and go; controls that only the pointer needs come and go with it; no device can be chosen while the
    /// tool is in use.
    void theStylusIsChosen() {
        MillPanel panel;
        MillState state = examples::mill();
        state.recording = state.active = false;
        state.styluses = QStringList{QStringLiteral("Mouse"), QStringLiteral("Open Stylus")};
        panel.setState(state);
        show(panel);
        QSignalSpy chosen(&panel, &MillPanel::stylusChosen);
        auto& box = child<QComboBox>(panel, "stylusChoice");
        QCOMPARE(box.count(), 2);
        QVERIFY(child<QPushButton>(panel, "levelButton").isVisible());
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Down);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toInt(), 1);
        state.stylus = 1;
        panel.setState(state);
        QCOMPARE(box.currentIndex(), 1);
        for (const char* name : {"levelButton", "alongPartButton"})
            QVERIFY(!child<QPushButton>(panel, name).isVisible());
        state.styluses[1] += QStringLiteral(" (not plugged in)");
        panel.setState(state);
        QCOMPARE(box.currentText(), state.styluses[1]);
        state.active = true;
        panel.setState(state);
        QVERIFY(!box.isEnabled());
        QCOMPARE(chosen.size(), 1); // none of the changes came from the user
    }

    void depthAndSpeedAreEdited() {
        MillPanel panel;
        MillState state = examples::mill();
        panel.setState(state);
        show(panel);
        QSignalSpy rule(&panel, &MillPanel::depthRuleChosen), depth(&panel, &MillPanel::depthOfCutEdited),
            press(&panel, &MillPanel::pressEdited), speed(&panel, &MillPanel::speedEdited);
        type(panel, "depthOfCutField", "0.4");
        type(panel, "speedField", "2 in/s");
        QCOMPARE(depth[0][0].toDouble(), 0.4);
        QVERIFY(std::abs(speed[0][0].toDouble() - 50.8) < 1e-9);
        QVERIFY(!child<QWidget>(panel, "pressField").isVisible());
        click(panel, "levelButton"); // is already chosen
        QCOMPARE(rule.size(), 0);
        click(panel, "alongPartButton");
        QCOMPARE(rule.size(), 1);
        QCOMPARE(rule[0][0].value<DepthChoice>(), DepthChoice::part);
        QVERIFY(child<QWidget>(panel, "pressField").isVisible());
        type(panel, "pressField", "3");
        QCOMPARE(press[0][0].toDouble(), 3.0);
        QCOMPARE(depth.size(), 1);
    }

    void aPenIsOfferedItsPressure() {
        MillPanel panel;
        MillState state = examples::mill();
        state.pen = false;
        panel.setState(state);
        show(panel);
        QVERIFY(!child<QPushButton>(panel, "penDepthButton").isVisible());
        state.pen = true;
        state.penRule = PenChoice::depth;
        panel.setState(state);
        QVERIFY(child<QPushButton>(panel, "penDepthButton").isChecked());
        QVERIFY(!child<QWidget>(panel, "sinkSpeedField").isVisible());
        QSignalSpy rule(&panel, &MillPanel::penRuleChosen), speed(&panel, &MillPanel::sinkSpeedEdited);
        click(panel, "penDepthButton"); // is already chosen
        QCOMPARE(rule.size(), 0);
        click(panel, "penSinkButton");
        QCOMPARE(rule.size(), 1);
        QCOMPARE(rule[0][0].value<PenChoice>(), PenChoice::sink);
        type(panel, "sinkSpeedField", "5");
        QCOMPARE(speed[0][0].toDouble(), 5.0);
        state.stylus = 1; // a device mills: the pen does not
        panel.setState(state);
        QVERIFY(!child<QPushButton>(panel, "penSinkButton").isVisible());
    }

    void metersTellTheFigures() {
        Meters meters;
        QCOMPARE(valueOf(meters, "forceMeter"), QStringLiteral("–"));
        meters.setState(examples::meters());
        QCOMPARE(valueOf(meters, "forceMeter"), QStringLiteral("1.8 N of 3.3"));
        QCOMPARE(valueOf(meters, "removalMeter"), QStringLiteral("412 mm³/s"));
        QCOMPARE(valueOf(meters, "rateMeter"), QStringLiteral("1,000 Hz"));
        QCOMPARE(valueOf(meters, "intervalMeter"), QStringLiteral("1.18 ms"));
        QCOMPARE(valueOf(meters, "workMeter"), QStringLiteral("112 µs"));
        QCOMPARE(valueOf(meters, "missedMeter"), QStringLiteral("3"));
        QCOMPARE(valueOf(meters, "lateMeter"), QStringLiteral("1"));
        QCOMPARE(valueOf(meters, "schedulingMeter"), QStringLiteral("RealtimeKit"));
        QCOMPARE(valueOf(meters, "positionZ"), QStringLiteral("-11.380"));
        meters.setUnit(LengthUnit::inch);
        QCOMPARE(valueOf(meters, "positionZ"), QStringLiteral("-0.4480"));
    }

    /// Up to the limit of tool and spindle the bar is not red; above it the bar is red.
    void theForceTurnsRedAtTheLimit() {
        Meters meters;
        MeterState state = examples::meters();
        state.forceLimit = 250.0;
        state.forceLimitOf = QStringLiteral("the tool may break");
        state.force = 200.0;
        meters.setState(state);
        QCOMPARE(valueOf(meters, "forceMeter"), QStringLiteral("200.0 N, limit 250.0 N"));
        const MeterBar* const bar = meters.findChildren<MeterBar*>().constFirst();
        QVERIFY(bar->role() == &Palette::accent);
        QVERIFY(std::abs(bar->share() - 0.8) < 1e-9);
        state.force = 260.0;
        meters.setState(state);
        QVERIFY(bar->role() == &Palette::force);
        QCOMPARE(bar->share(), 1.0);
        QVERIFY(child<QWidget>(meters, "forceMeter").toolTip().contains(QStringLiteral("the tool may break")));
    }

    void stepsAreChosenByMouseAndKeyboard() {
        StepBar line;
        line.setState(examples::job(), JobStep::mill);
        line.resize(1280, line.sizeHint().height());
        line.show();
        line.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&line));
        std::vector<JobStep> chosen;
        connect(&line, &StepBar::stepChosen, this, [&chosen](JobStep step) { chosen.push_back(step); });
        click(line, "stepStock");
        auto& part = child<QAbstractButton>(line, "stepPart");
        part.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&part, Qt::Key_Right);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Enter);
        QCOMPARE(chosen, (std::vector{JobStep::stock, JobStep::material, JobStep::tool, JobStep::material}));
        QCOMPARE(child<QWidget>(line, "stepPart").accessibleName(), QStringLiteral("Part"));
        QCOMPARE(child<QWidget>(line, "stepPart").accessibleDescription(), QStringLiteral("done: mouse.step"));
    }
};

BURIN_TEST(TestMillPanels, QApplication)

} // namespace burin::tst_mill_panels

#include "tst_mill_panels.moc"

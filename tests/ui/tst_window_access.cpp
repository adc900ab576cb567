// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What assistive programs read in the window and its dialogs, and that the dialogs' texts have room in either theme.
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"
#include "tests/ui/dialog_walk.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/dialogs/preferences.h"
#include "ui/messages/messages.h"
#include "ui/panels/meter_bar.h"
#include "ui/panels/meters.h"
#include "ui/panels/notice.h"
#include "ui/panels/value_row.h"
#include "ui/window/axis_rows.h"

#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QtTest>

namespace burin::tst_window_access {

using namespace burin::testing;

namespace {

/// Whether it is a part of a control that has the name, as the text of a number field is.
bool isPart(const QWidget& widget) {
    return widget.objectName().startsWith(QLatin1String("qt_")) || widget.focusProxy() != nullptr;
}

/// Whether a user of the keyboard or the mouse can reach it, or reads a value from it.
bool needsName(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) // an empty one shows nothing
        return label->focusPolicy() != Qt::NoFocus && !label->text().isEmpty();
    return widget.focusPolicy() != Qt::NoFocus || qobject_cast<const QProgressBar*>(&widget) != nullptr ||
           qobject_cast<const MeterBar*>(&widget) != nullptr || qobject_cast<const ValueRow*>(&widget) != nullptr;
}

/// Where a widget is, for the message: its class, its name and those of what it is in.
QString placeOf(const QWidget& widget) {
    QStringList place;
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget())
        if (at == &widget || !at->objectName().isEmpty())
            place << QStringLiteral("%1 %2").arg(QLatin1String(at->metaObject()->className()), at->objectName());
    return place.join(QStringLiteral(" < "));
}

/// What a screen reader calls a widget: the label that belongs to it, or its name. For a choice Qt gives the chosen
/// text as the name, so that only a label says what is chosen.
QString nameOf(QWidget& widget) {
    QAccessibleInterface* access = QAccessible::queryAccessibleInterface(&widget);
    if (access == nullptr) return {};
    const auto labels = access->relations(QAccessible::Label);
    if (!labels.isEmpty()) return labels.front().first->text(QAccessible::Name).trimmed();
    if (qobject_cast<QComboBox*>(&widget) != nullptr) return {};
    return access->text(QAccessible::Name).trimmed();
}

/// What is read of a number field's text.
QString readIn(QuantityField& field) {
    QAccessibleInterface* access = QAccessible::queryAccessibleInterface(&field);
    QAccessibleTextInterface* text = access == nullptr ? nullptr : access->textInterface();
    return text == nullptr ? QString() : text->text(0, text->characterCount());
}

/// What a screen reader could not read of a window's visible widgets.
QStringList faultsOf(QWidget& window) {
    QStringList faults;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != window.window() || isPart(*widget) || !needsName(*widget))
            continue;
        if (nameOf(*widget).isEmpty()) faults << QStringLiteral("without a name: ") + placeOf(*widget);
        auto* field = qobject_cast<QuantityField*>(widget);
        if (field != nullptr && !readIn(*field).endsWith(field->suffix()))
            faults << QStringLiteral("without its unit: ") + placeOf(*widget);
    }
    return faults;
}

} // namespace

class TestWindowAccess : public QObject {
    Q_OBJECT
private slots:
    void everythingHasANameAndRoom_data();
    void everythingHasANameAndRoom();
    void theAxesOfADeviceHaveNames();
    void whatOnlyAColourShowsIsRead();

private:
    void look(QWidget& window);
    void doTheJob(WindowDriver& driver);

    QStringList faults_;
};

void TestWindowAccess::everythingHasANameAndRoom_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("light");
    if (longRun()) {
        QTest::newRow("en, dark") << QStringLiteral("en") << false;
        for (const bool light : {false, true})
            QTest::addRow("zh, %s", light ? "light" : "dark") << QStringLiteral("zh_CN") << light;
        QTest::newRow("de, dark") << QStringLiteral("de") << false;
    }
    QTest::newRow("de, light") << QStringLiteral("de") << true; // the longest words; a translation stays installed
}

void TestWindowAccess::look(QWidget& window) {
    const QString name = window.objectName();
    QTest::qWait(50); // presenters run after the event
    for (const QString& fault : faultsOf(window)) faults_ << name + QStringLiteral(": ") + fault;
    std::vector<VisibleText> clipped = clippedTexts(window);
    for (int i = 0; i < 20 && !clipped.empty(); ++i) { // a layout may follow its texts by some events
        QTest::qWait(100);
        clipped = clippedTexts(window);
    }
    for (const VisibleText& text : clipped)
        faults_ << QStringLiteral("%1: no room: %2: %3").arg(name, text.where, text.text);
    QString file = QStringLiteral("access-%1-%2").arg(QLatin1String(QTest::currentDataTag()), name);
    keepPicture(window, file.replace(QLatin1String(", "), QLatin1String("-")));
}

/// A job with something of each kind, so that every action is possible.
void TestWindowAccess::doTheJob(WindowDriver& driver) {
    Workbench& workbench = driver.window().workbench();
    QVERIFY(makeReady(driver, 1.0));
    workbench.surroundings.addBox(ObstacleKind::fixture);
    QVERIFY(driver.settle() && recordLine(driver, {-15, 0}, {15, 0}) && driver.settle());
    workbench.guides.add(GuideKind::plane);
    QVERIFY(newPath(driver) && postProgram(driver));
    QVERIFY(driver.waitFor([&] { return driver.visible("programText") != nullptr; }));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    const std::vector<NcMotion>& motions = workbench.program.program()->parsed.motions;
    const auto line = static_cast<int>(motions[motions.size() / 2].line) - 1; // the program can be restarted there
    text->setTextCursor(QTextCursor(text->document()->findBlockByNumber(line)));
    for (const int key : {Qt::Key_H, Qt::Key_F10}) driver.key(key, Qt::ControlModifier); // history and project tree
}

void TestWindowAccess::everythingHasANameAndRoom() {
    QFETCH(QString, language);
    QFETCH(bool, light);
    const bool translated = language != QLatin1String("en");
    if (translated) QVERIFY(Messages::install(QLocale(language)));
    WindowDriver driver({1280, 800}, translated ? QLocale(language) : QLocale::c());
    UserSettings().setPreferences({light ? Theme::light : Theme::dark, LengthUnit::millimetre, {}});
    QVERIFY(driver.restart(true));
    faults_.clear();
    look(driver.window()); // the welcome page
    driver.key(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(driver.waitFor([&] { return driver.window().coach().running(); }));
    look(*driver.window().findChild<QWidget*>("coachPanel"));
    look(driver.window());
    QVERIFY(driver.clickOn("coachEndButton"));
    doTheJob(driver);
    if (QTest::currentTestFailed()) return;
    for (int step = 0; step < StepBar::steps; ++step) {
        QVERIFY(driver.step(static_cast<JobStep>(step)));
        look(*driver.visible("panelStack"));
        look(driver.window());
    }
    DialogWalk dialogs(driver, [this](QDialog& dialog) { look(dialog); });
    dialogs.walk();
    for (const char* name :
         {"preferencesDialog", "shortcutDialog", "helpDialog", "keyList", "toolDialog", "toolShapeDialog",
          "materialDialog", "calibrationDialog", "machineDialog", "deviceDialog", "fixtureDialog", "scoreDialog",
          "comparisonDialog", "faceDialog", "passDialog", "setupDialog", "restartDialog"})
        QVERIFY2(dialogs.seen().contains(QLatin1String(name)), name);
    faults_.removeDuplicates();
    QVERIFY2(faults_.isEmpty(), qPrintable(QLatin1Char('\n') + faults_.join(QLatin1Char('\n'))));
}

/// Its dialog needs a device; every field of a row has a name of its own.
void TestWindowAccess::theAxesOfADeviceHaveNames() {
    MappableDevice device;
    device.axes.resize(2);
    device.axes[0].name = "X";
    device.axes[1].name = "Y";
    device.buttons = 2;
    QWidget window;
    AxisRows rows(device, &window);
    rows.showMap(device.usual);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(faultsOf(window), QStringList());
    QStringList names;
    for (QWidget* widget : rows.findChildren<QWidget*>())
        if (widget->window() == &window && !isPart(*widget) && widget->focusPolicy() != Qt::NoFocus)
            names << nameOf(*widget);
    QCOMPARE(names.size(), 10); // four of each axis, one of each button
    QCOMPARE(names.removeDuplicates(), 0);
}

/// The force bar turns red at the limit, and a notice has the colour of its kind. Values without a unit are read with
/// it.
void TestWindowAccess::whatOnlyAColourShowsIsRead() {
    Meters meters;
    const auto* force = meters.findChild<ValueRow*>("forceMeter");
    const auto* z = meters.findChild<ValueRow*>("positionZ");
    MeterState state;
    state.running = true;
    state.forceLimit = 100.0;
    state.tip.z = -1.5;
    for (const double newtons : {40.0, 99.0, 100.0, 120.0, 50.0}) {
        state.force = newtons;
        meters.setState(state);
        QCOMPARE(force->accessibleDescription() != force->value(), newtons >= 100.0);
        QVERIFY(force->accessibleDescription().startsWith(force->value()));
    }
    QVERIFY(z->accessibleDescription().endsWith(QStringLiteral("mm")) && !z->value().endsWith(QStringLiteral("mm")));
    state.running = false;
    meters.setState(state);
    QCOMPARE(z->accessibleDescription(), z->value());
    Notice notice;
    notice.tell(Notice::Kind::information, QStringLiteral("The tool is broken."));
    const QString plain = notice.accessibleName();
    notice.tell(Notice::Kind::error, QStringLiteral("The tool is broken."));
    QVERIFY(notice.accessibleName() != plain && notice.accessibleName().endsWith(plain));
}

BURIN_TEST(TestWindowAccess, QApplication)

} // namespace burin::tst_window_access

#include "tst_window_access.moc"

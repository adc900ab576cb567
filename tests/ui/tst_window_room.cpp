// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/test_program.h"
#include "tests/ui/visible_texts.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QPlainTextEdit>
#include <QtTest>

#include <utility>
#include <vector>

namespace burin::tst_window_room {

using namespace burin::testing;

/// Texts have the room that they need, in every language and at every size that the window can have.
class TestWindowRoom : public QObject {
    Q_OBJECT
private slots:
    void noTextOfAJobIsCut_data();
    void noTextOfAJobIsCut();

private:
    /// Collects the clipped texts that are visible now.
    void look(WindowDriver& driver, const QString& name);
    void lookAtSteps(WindowDriver& driver, const QString& name);
    /// Opens each visible choice: its items have the room that they need.
    void lookIntoChoices(WindowDriver& driver);

    QStringList cut_;
};

void TestWindowRoom::look(WindowDriver& driver, const QString& name) {
    QTest::qWait(200); // until the panels are up to date
    QString file = QStringLiteral("room-%1-%2").arg(QLatin1String(QTest::currentDataTag()), name);
    driver.shoot(file.replace(QLatin1String(", "), QLatin1String("-")));
    for (const VisibleText& text : clippedTexts(driver.window()))
        cut_ << name + QStringLiteral(": ") + text.where + QStringLiteral(": ") + text.text;
}

void TestWindowRoom::lookAtSteps(WindowDriver& driver, const QString& name) {
    for (int step = 0; step < StepBar::steps; ++step)
        if (driver.step(static_cast<JobStep>(step))) look(driver, QStringLiteral("%1-%2").arg(name).arg(step + 1));
}

void TestWindowRoom::lookIntoChoices(WindowDriver& driver) {
    for (auto* choice : driver.window().findChildren<QComboBox*>()) {
        if (!choice->isVisible() || !choice->isEnabled()) continue;
        QTest::mouseClick(choice, Qt::LeftButton);
        if (!driver.waitFor([&] { return choice->view()->isVisible(); })) {
            cut_ << choice->objectName() + QStringLiteral(" does not open");
            continue;
        }
        for (int i = 0; i < choice->count(); ++i)
            if (choice->view()->fontMetrics().horizontalAdvance(choice->itemText(i)) >
                choice->view()->viewport()->width())
                cut_ << choice->objectName() + QStringLiteral(", opened: ") + choice->itemText(i);
        QTest::keyClick(choice->view(), Qt::Key_Escape);
        QTest::qWait(50);
    }
}

void TestWindowRoom::noTextOfAJobIsCut_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    std::vector<std::pair<const char*, QSize>> sizes{{"smallest", {1024, 680}}}; // where room is scarcest
    if (longRun()) sizes.push_back({"large", {1580, 960}});
    std::vector<const char*> languages{"de"}; // which has the longest texts
    if (longRun()) languages.insert(languages.begin(), {"en", "zh_CN"});
    for (const char* language : languages) // the last translation that is installed remains
        for (const auto& [name, size] : sizes)
            QTest::addRow("%s, %s", language, name) << QString::fromLatin1(language) << size;
}

void TestWindowRoom::noTextOfAJobIsCut() {
    QFETCH(QString, language);
    QFETCH(QSize, size);
    const bool translated = language != QLatin1String("en");
    if (translated) QVERIFY(Messages::install(QLocale(language)));
    WindowDriver driver(size, translated ? QLocale(language) : QLocale::c());
    Workbench& workbench = driver.window().workbench();
    cut_.clear();
    look(driver, "welcome");
    drop(driver.window(), writeBlock(driver, false)); // an open mesh, so that there are notes and findings
    QVERIFY(driver.waitFor([&] { return workbench.model.model() != nullptr; }) && driver.settle());
    lookAtSteps(driver, "begun");

    QVERIFY(makeReady(driver));
    QVERIFY(recordLine(driver, {-10, 0}, {10, 0}) && driver.settle());
    QVERIFY(driver.step(JobStep::path) && driver.clickOn("newPathButton"));
    QVERIFY(driver.waitFor([&] { return workbench.path.evaluated() != nullptr; }));
    QVERIFY(postProgram(driver));
    lookAtSteps(driver, "done");
    lookIntoChoices(driver); // the choices of the program, including the machines

    // A program that fails its check, in the dock.
    QVERIFY(driver.clickOn("editTextButton"));
    auto* text = driver.visible<QPlainTextEdit>("programText");
    text->setFocus();
    QTest::keyClick(text, Qt::Key_End, Qt::ControlModifier);
    QTest::keyClicks(text, "G1 Z-50 F100");
    QTest::keyClick(text, Qt::Key_Return);
    QTest::keyClicks(text, "G999");
    QVERIFY(driver.waitFor([&] { return workbench.program.edited(); }));
    driver.key(Qt::Key_F7);
    look(driver, "docked");
    QVERIFY(driver.step(JobStep::mill) && driver.clickOn("millButton"));
    QVERIFY(driver.waitFor([&] { return workbench.mill.active(); }));
    look(driver, "milling");
    cut_.removeDuplicates();
    QVERIFY2(cut_.isEmpty(), qPrintable(QLatin1Char('\n') + cut_.join(QLatin1Char('\n'))));
}

BURIN_TEST(TestWindowRoom, QApplication)

} // namespace burin::tst_window_room

#include "tst_window_room.moc"

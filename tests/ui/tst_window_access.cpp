// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// What a screen reader says: everything that can have the focus has a name.
#include "tests/test_program.h"
#include "tests/ui/window_steps.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QTimer>
#include <QtTest>

namespace burin::tst_window_access {

using namespace burin::testing;

namespace {

/// Whether it is a part of a control that has the name, as the text of a field is.
bool isPart(const QWidget& widget) {
    const QString name = widget.objectName();
    return name.startsWith(QLatin1String("qt_")) || name.startsWith(QLatin1String("QComboBox")) ||
           widget.focusProxy() != nullptr;
}

/// Where a widget is, for the message: its class, its name and those of what it is in.
QString placeOf(const QWidget& widget) {
    QString place;
    for (const QWidget* at = &widget; at != nullptr; at = at->parentWidget())
        if (at == &widget || !at->objectName().isEmpty())
            place += QStringLiteral(" < %1 %2").arg(QLatin1String(at->metaObject()->className()), at->objectName());
    return place.mid(3);
}

/// The visible widgets of a window that can have the focus and have no name.
QStringList nameless(QWidget& window) {
    QStringList found;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != &window || (widget->focusPolicy() & Qt::TabFocus) == 0 ||
            isPart(*widget))
            continue;
        QAccessibleInterface* access = QAccessible::queryAccessibleInterface(widget);
        if (access == nullptr || access->text(QAccessible::Name).trimmed().isEmpty()) found << placeOf(*widget);
    }
    return found;
}

} // namespace

class TestWindowAccess : public QObject {
    Q_OBJECT
private slots:
    void everythingWithFocusHasAName() {
        WindowDriver driver;
        QStringList found = nameless(driver.window()); // the welcome page
        QVERIFY(makeReady(driver, 1.0));
        QVERIFY(driver.step(JobStep::stock) && driver.clickOn("embedButton"));
        driver.window().workbench().surroundings.addBox(ObstacleKind::fixture);
        driver.window().workbench().guides.add(GuideKind::plane);
        QVERIFY(driver.settle() && recordLine(driver, {-15, 0}, {15, 0}));
        QVERIFY(newPath(driver) && postProgram(driver));
        for (const int key : {Qt::Key_H, Qt::Key_F10}) driver.key(key, Qt::ControlModifier);
        for (int step = 0; step < JobLine::steps; ++step) {
            if (!driver.step(static_cast<JobStep>(step))) continue;
            QTest::qWait(50);
            found += nameless(driver.window());
        }
        const int dialogs = lookAtDialogs(driver, found);
        QVERIFY2(dialogs > 8, qPrintable(QString::number(dialogs)));
        found.removeDuplicates();
        QVERIFY2(found.isEmpty(), qPrintable(QLatin1Char('\n') + found.join(QLatin1Char('\n'))));
    }

private:
    /// Opens each dialog that a menu offers now, and closes it again. Returns their number.
    static int lookAtDialogs(WindowDriver& driver, QStringList& found) {
        int dialogs = 0;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, [&] {
            for (QWidget* window : QApplication::topLevelWidgets()) {
                auto* dialog = qobject_cast<QDialog*>(window);
                if (dialog == nullptr || !dialog->isVisible()) continue;
                if (qobject_cast<QFileDialog*>(dialog) == nullptr) { // that one is Qt's own
                    ++dialogs;
                    found += nameless(*dialog);
                }
                dialog->reject();
            }
        });
        look.start(80);
        for (QAction* action : menuActions(driver)) {
            if (!action->isEnabled() || !action->text().remove(QLatin1Char('&')).endsWith(QStringLiteral("…")))
                continue;
            action->trigger();
            QTest::qWait(200);
        }
        return dialogs;
    }
};

BURIN_TEST(TestWindowAccess, QApplication)

} // namespace burin::tst_window_access

#include "tst_window_access.moc"

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/soak/window_monkey.h"

#include "core/document/project.h"
#include "tests/places.h"
#include "tests/ui/window_steps.h"
#include "ui/messages/messages.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QEventLoop>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QSlider>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace burin::testing {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int pause = 15;         // ms between two steps
constexpr int deepest = 3;        // levels of nested dialogs
constexpr double longStall = 100; // ms
constexpr std::size_t keptStalls = 15;

/// All widgets of a type that are visible and enabled.
template <class T>
QList<T*> usable(const QWidget& in) {
    QList<T*> found;
    for (T* widget : in.findChildren<T*>())
        if (widget->isVisible() && widget->isEnabled() && !widget->visibleRegion().isEmpty()) found.append(widget);
    return found;
}

void collect(const QMenu& menu, QList<QAction*>& into) {
    for (QAction* action : menu.actions()) {
        if (action->menu() != nullptr)
            collect(*action->menu(), into);
        else if (!action->isSeparator() && action->isEnabled())
            into.append(action);
    }
}

QString nameOf(const QObject& object) {
    return object.objectName().isEmpty() ? QString::fromLatin1(object.metaObject()->className()) : object.objectName();
}

} // namespace

double residentMegabytes() {
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly)) return 0.0;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (line.startsWith("VmRSS:")) return line.mid(6).trimmed().split(' ').front().toDouble() / 1e3;
    return 0.0;
}

WindowMonkey::WindowMonkey(WindowDriver& driver, StallWatch& watch, unsigned seed, const QString& log)
    : driver_(driver), watch_(watch), random_(seed), log_(log) {
    static_cast<void>(log_.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
}

WindowMonkey::Report WindowMonkey::run(double seconds) {
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(static_cast<long>(1e3 * seconds));
    watch_.beginPhase();
    actSoon();
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        ending_ = Clock::now() >= end;
        if (ending_ && depth_ == 0 && QApplication::activeModalWidget() == nullptr) loop.quit();
    });
    look.start(100);
    loop.exec();
    saveAndCompare();
    over_ = true;
    return report_;
}

void WindowMonkey::note(const QString& kind, const QString& what) {
    last_ = kind + QLatin1Char(' ') + what;
    ++report_.steps;
    ++report_.byKind[kind];
    log_.write((QString::number(report_.steps) + QLatin1Char(' ') + last_ + QLatin1Char('\n')).toUtf8());
}

/// Records a stall of the previous step: the event loop has run since then.
void WindowMonkey::noteStall() {
    const std::size_t stalls = watch_.longerThan(longStall);
    if (stalls == 0) return;
    report_.stalls += stalls;
    const StallWatch::Stall longest = watch_.longest();
    watch_.beginPhase();
    const QString text = QStringLiteral("%1 ms (%2 of them computing): %3: %4")
                             .arg(longest.milliseconds, 0, 'f', 0)
                             .arg(longest.processor, 0, 'f', 0)
                             .arg(last_, longest.what);
    log_.write(("stall " + text + "\n").toUtf8());
    report_.worstStalls.emplace(longest.milliseconds, text);
    if (report_.worstStalls.size() > keptStalls) report_.worstStalls.erase(std::prev(report_.worstStalls.end()));
}

/// Records large changes of memory.
void WindowMonkey::noteMemory() {
    constexpr double worthNoting = 200.0; // MB
    const double now = residentMegabytes();
    if (std::abs(now - memoryNoted_) < worthNoting) return;
    log_.write(QStringLiteral("memory %1 MB\n").arg(now, 0, 'f', 0).toUtf8());
    memoryNoted_ = now;
}

/// Each step has a timer of its own, as a timer that is still being handled does not fire again in a dialog's event
/// loop.
void WindowMonkey::actSoon() {
    QTimer::singleShot(pause, &context_, [this] {
        if (over_) return;
        actSoon();
        act();
    });
}

void WindowMonkey::act() {
    noteStall();
    noteMemory();
    ++depth_;
    if (QWidget* popup = QApplication::activePopupWidget())
        actInPopup(*popup);
    else if (QWidget* dialog = QApplication::activeModalWidget())
        actInDialog(*dialog);
    else if (depth_ == 1 && !ending_)
        actInWindow();
    --depth_;
}

void WindowMonkey::actInPopup(QWidget& popup) {
    auto* menu = qobject_cast<QMenu*>(&popup);
    QList<QAction*> actions;
    if (menu != nullptr) collect(*menu, actions);
    QAction* action = oneOf(actions);
    popup.close();
    if (action == nullptr || ending_ || chance(30)) return;
    note("popup", nameOf(*action) + ' ' + action->text());
    action->trigger();
}

void WindowMonkey::actInDialog(QWidget& dialog) {
    if (ending_ || depth_ > deepest) {
        dialog.close();
        return;
    }
    if (auto* files = qobject_cast<QFileDialog*>(&dialog)) return actInFileDialog(*files);
    const int what = below(100);
    if (what < 20) {
        note("dialog", "Esc in " + nameOf(dialog));
        QTest::keyClick(&dialog, Qt::Key_Escape);
    } else if (what < 40) {
        enterNumber(dialog);
    } else {
        clickWidget(dialog);
    }
}

/// Uses only known files: it must not write into the tester's folders.
void WindowMonkey::actInFileDialog(QFileDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    if (chance(40) || name == nullptr) {
        note("files", "cancelled");
        return dialog.reject();
    }
    const bool saves = dialog.acceptMode() == QFileDialog::AcceptSave;
    const QString file = saves ? driver_.folder().filePath(QStringLiteral("monkey-%1").arg(below(3))) : someFile();
    note("files", (saves ? "saved as " : "opened ") + file);
    name->setText(file);
    QTest::keyClick(name, Qt::Key_Return);
    if (dialog.isVisible() && QApplication::activeModalWidget() == &dialog) dialog.reject();
}

void WindowMonkey::actInWindow() {
    if (!driver_.window().isVisible()) return closeAndOpen();
    const int what = below(1000);
    if (what < 350)
        triggerAction();
    else if (what < 600)
        clickWidget(driver_.window());
    else if (what < 700)
        enterNumber(driver_.window());
    else if (what < 850)
        dragInView();
    else if (what < 960)
        pressKey();
    else if (what < 975)
        openSomeFile();
    else if (what < 995)
        saveAndCompare();
    else
        closeAndOpen();
}

void WindowMonkey::triggerAction() {
    QList<QAction*> actions;
    for (QAction* top : driver_.window().menuBar()->actions())
        if (top->menu() != nullptr) collect(*top->menu(), actions);
    actions.removeIf([](const QAction* action) { return action->objectName() == QLatin1String("quitAction"); });
    QAction* action = oneOf(actions);
    if (action == nullptr) return;
    note("action", nameOf(*action));
    action->trigger();
}

void WindowMonkey::clickWidget(QWidget& in) {
    const QList<QAbstractButton*> buttons = usable<QAbstractButton>(in);
    const QList<QAbstractItemView*> lists = usable<QAbstractItemView>(in);
    const QList<QComboBox*> choices = usable<QComboBox>(in);
    QWidget* widget = nullptr;
    const int what = below(10);
    if (what < 2) widget = oneOf(lists);
    if (what == 2) widget = oneOf(choices);
    if (what == 3) widget = oneOf(usable<QSlider>(in));
    if (widget == nullptr) widget = oneOf(buttons);
    if (widget == nullptr) return;
    note("click", nameOf(*widget));
    if (auto* choice = qobject_cast<QComboBox*>(widget)) {
        if (choice->count() > 0) choice->setFocus();
        QTest::keyClick(choice, chance(50) ? Qt::Key_Down : Qt::Key_Up);
        return;
    }
    if (auto* list = qobject_cast<QAbstractItemView*>(widget)) widget = list->viewport();
    const QPoint place(below(std::max(1, widget->width())), below(std::max(1, widget->height())));
    const bool button = qobject_cast<QAbstractButton*>(widget) != nullptr;
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, button ? widget->rect().center() : place);
}

void WindowMonkey::enterNumber(QWidget& in) {
    auto* field = oneOf(usable<QAbstractSpinBox>(in));
    if (field == nullptr) return;
    constexpr std::array texts{"0", "1", "0.5", "12", "-3", "1e9", "", "3/8 in", "2.5", "100", "abc", "0.001"};
    const char* text = texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
    note("number", nameOf(*field) + " = " + text);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

void WindowMonkey::dragInView() {
    auto* view = driver_.visible<Viewport>("viewport");
    if (view == nullptr) return;
    constexpr std::array buttons{Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    const Qt::MouseButton button = buttons[static_cast<std::size_t>(below(4))];
    const auto place = [&] { return QPoint(below(view->width()), below(view->height())); };
    const QPoint from = place(), to = place();
    note("drag",
         QStringLiteral("%1 from %2 %3 to %4 %5").arg(button).arg(from.x()).arg(from.y()).arg(to.x()).arg(to.y()));
    const QPointer<Viewport> still(view);
    QTest::mousePress(view, button, Qt::NoModifier, from);
    constexpr int steps = 12;
    for (int i = 1; i <= steps && still; ++i) {
        QTest::mouseMove(view, from + (to - from) * i / steps);
        QTest::qWait(5);
    }
    if (still) QTest::mouseRelease(view, button, Qt::NoModifier, to);
}

void WindowMonkey::pressKey() {
    constexpr std::array keys{Qt::Key_Escape, Qt::Key_Return, Qt::Key_Space,  Qt::Key_Tab,   Qt::Key_Delete,
                              Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Left,   Qt::Key_Right, Qt::Key_PageUp,
                              Qt::Key_W,      Qt::Key_A,      Qt::Key_S,      Qt::Key_D,     Qt::Key_Q,
                              Qt::Key_F,      Qt::Key_C,      Qt::Key_Escape, Qt::Key_F2,    Qt::Key_Home};
    const Qt::Key key = keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))];
    note("key", QKeySequence(key).toString());
    driver_.key(key);
}

/// A part, a project, a program or another file.
QString WindowMonkey::someFile() {
    static const QStringList files = [] {
        QStringList found;
        for (const char* folder : {"models", "projects", "gcode", "programs"})
            for (QDirIterator each(QStringLiteral(BURIN_FIXTURES "/") + folder, QDir::Files); each.hasNext();) {
                each.next();
                if (each.fileInfo().size() < 2'000'000) found.append(each.filePath());
            }
        found.sort();
        return found;
    }();
    QStringList all = files;
    // A copy, so that the window cannot change the fixtures by saving.
    const QString chosen = all[below(static_cast<int>(all.size()))];
    const QString copy = driver_.folder().filePath(QFileInfo(chosen).fileName());
    if (!QFile::exists(copy)) QFile::copy(chosen, copy);
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    return copy;
}

void WindowMonkey::openSomeFile() {
    const QString file = chance(40) ? QStringLiteral(BURIN_FIXTURES "/models/mouse-cover.step") : someFile();
    note("open", file);
    driver_.window().openFile(file);
}

/// Checks that the saved project contains the takes that the window shows.
void WindowMonkey::saveAndCompare() {
    Workbench& workbench = driver_.window().workbench();
    if (!driver_.window().isVisible() || !workbench.document.isOpen() || workbench.document.readOnly() ||
        workbench.session.running())
        return;
    note("save", "and compare");
    ++depth_;
    menuAction(driver_, "saveAction")->trigger();
    const bool saved = QTest::qWaitFor([&] { return !workbench.document.unsaved() && workbench.tasks().idle(); }, 5000);
    --depth_;
    if (!saved || workbench.document.isUnnamed() || QApplication::activeModalWidget() != nullptr) return;
    const Result<Project> project = Project::openForReading(workbench.document.file());
    if (!project) {
        report_.losses << QStringLiteral("%1 can't be read: %2")
                              .arg(QString::fromStdString(workbench.document.file().string()),
                                   Messages::sentence(project.error()));
        return;
    }
    ++report_.projectsCompared;
    const auto takes = project->takes();
    if (!takes) {
        report_.losses << Messages::sentence(takes.error());
        return;
    }
    for (const TakeInfo& take : workbench.mill.takes())
        if (std::ranges::find(*takes, take.id, &TakeInfo::id) == takes->end())
            report_.losses << QStringLiteral("step %1: take %2 is not in the file").arg(report_.steps).arg(take.id);
}

void WindowMonkey::closeAndOpen() {
    note("close", "and open again");
    ++depth_;
    static_cast<void>(driver_.restart(chance(50)));
    --depth_;
    watch_.beginPhase(); // a window is created: that belongs to the program's start and is no stall
}

} // namespace burin::testing

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/window_driver.h"
#include "tests/long_run.h"
#include "tests/places.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDir>
#include <QScreen>
#include <QScrollArea>
#include <QTimer>
#include <QtTest>

#include <algorithm>

namespace burin::testing {

namespace {

constexpr const char* stepButtons[] = {"stepPart",      "stepStock", "stepMaterial", "stepTool",
                                       "stepAllowance", "stepMill",  "stepPath",     "stepProgram"};

} // namespace

WindowDriver::WindowDriver(const QSize& size, const QLocale& locale)
    : size_(size), folder_(std::make_unique<QTemporaryDir>()) {
    qputenv("XDG_DATA_HOME", folder_->filePath("data").toUtf8());
    qputenv("XDG_CONFIG_HOME", folder_->filePath("config").toUtf8());
    // QSettings reads the variable only once per process.
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_->filePath("config"));
    QCoreApplication::setApplicationName("Burin");
    QLocale::setDefault(locale);
    open();
}

WindowDriver::~WindowDriver() {
    endQuietly();
}

void WindowDriver::open() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(size_);
    window_->move(0, 0);
    window_->show();
    static_cast<void>(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get()); // no window manager does this
}

bool WindowDriver::endQuietly() {
    window_->endQuietly();
    return QTest::qWaitFor([this] { return !window_->isVisible(); }, 30000);
}

bool WindowDriver::restart(bool quietly) {
    if (quietly)
        endQuietly();
    else
        window_->close();
    if (!QTest::qWaitFor([this] { return !window_->isVisible(); }, 30000)) return false;
    window_.reset();
    open();
    return true;
}

bool WindowDriver::clickOn(const char* name) {
    const auto ready = [&] {
        const auto* widget = visible<QWidget>(name);
        return widget != nullptr && widget->isEnabled();
    };
    if (!waitFor(ready)) return false; // panels follow an event a moment later
    auto* widget = visible<QWidget>(name);
    QTest::mouseClick(widget, Qt::LeftButton);
    return true;
}

bool WindowDriver::step(JobStep step) {
    return clickOn(stepButtons[static_cast<std::size_t>(step)]);
}

bool WindowDriver::enter(const char* name, const QString& text) {
    const auto ready = [&] {
        const auto* field = visible<QAbstractSpinBox>(name);
        return field != nullptr && field->isEnabled();
    };
    if (!waitFor(ready)) return false;
    auto* field = visible<QAbstractSpinBox>(name);
    for (QWidget* parent = field->parentWidget(); parent != nullptr; parent = parent->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(parent)) area->ensureWidgetVisible(field);
    QApplication::setActiveWindow(window_.get());
    QTest::mouseClick(field, Qt::LeftButton, Qt::NoModifier, field->rect().center());
    field->setFocus(); // where a window manager runs, a click does this
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    return true;
}

void WindowDriver::key(int key, Qt::KeyboardModifiers modifiers) {
    QApplication::setActiveWindow(window_.get());
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : window_.get(), static_cast<Qt::Key>(key), modifiers);
}

void WindowDriver::whenDialogStands(std::function<void(QWidget& dialog)> act) {
    auto* timer = new QTimer(window_.get());
    QObject::connect(timer, &QTimer::timeout, window_.get(), [timer, act = std::move(act)] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (dialog == nullptr || !dialog->isVisible()) return;
        const std::function<void(QWidget&)> acts =
            act; // act may wait; the timer and what it holds are deleted meanwhile
        timer->deleteLater();
        timer->stop();
        acts(*dialog);
    });
    timer->start(20);
}

QString WindowDriver::message() const {
    const auto* strip = visible<MessageStrip>("messageStrip");
    return strip == nullptr ? QString() : strip->sentence();
}

bool WindowDriver::waitFor(const std::function<bool()>& what, int milliseconds) const {
    return QTest::qWaitFor(what, milliseconds);
}

bool WindowDriver::settle(int milliseconds) const {
    QTest::qWait(50); // for work that is about to begin
    return waitFor(
        [this] {
            return std::ranges::all_of(window_->workbench().tasks().rows(),
                                       [](const TaskRow& row) { return row.kind == TaskKind::growth; });
        },
        milliseconds);
}

void WindowDriver::shoot(const QString& name) const {
    QWidget* dialog = QApplication::activeModalWidget();
    keepPicture(dialog != nullptr ? *dialog : *window_, name);
}

void keepPicture(QWidget& widget, const QString& name) {
    QTest::qWait(150); // presenters and painting run after the event, in any run
    if (!longRun() && !qEnvironmentVariableIsSet("BURIN_SCREENSHOTS")) return;
    const QDir folder(QStringLiteral(BURIN_BUILD_DIRECTORY "/tests/screenshots"));
    folder.mkpath(QStringLiteral("."));
    widget.grab().save(folder.filePath(name + QStringLiteral(".png")));
}

} // namespace burin::testing

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/main_window.h"

#include <QLocale>
#include <QTemporaryDir>
#include <QWidget>

#include <functional>
#include <memory>

namespace burin::testing {

/// Saves the picture of a widget as tests/screenshots/<name>.png in the build tree, to be looked at: in long runs, and
/// where BURIN_SCREENSHOTS is set, as all of them together take a good part of a run.
void keepPicture(QWidget& widget, const QString& name);

/// A window that is independent of the tester's settings and projects, operated by mouse and keyboard.
class WindowDriver {
public:
    /// @param locale  for writing numbers, set before there is a window, as the program does
    explicit WindowDriver(const QSize& size = QSize(1280, 800), const QLocale& locale = QLocale::c());
    ~WindowDriver();
    WindowDriver(const WindowDriver&) = delete;
    WindowDriver& operator=(const WindowDriver&) = delete;

    MainWindow& window() { return *window_; }
    /// Closes the window and opens a new one, like a restart of the program. @param quietly  as a signal does it
    bool restart(bool quietly = false);
    /// Ends the window like a termination from outside: without a question.
    bool endQuietly();
    const QTemporaryDir& folder() const { return *folder_; } ///< for the test's files

    /// A widget that is visible to the user now; null otherwise.
    template <class T = QWidget>
    T* visible(const char* name) const {
        for (T* widget : window_->findChildren<T*>(QLatin1String(name)))
            if (widget->isVisible()) return widget;
        return nullptr;
    }
    bool clickOn(const char* name); ///< with the mouse; false if that is impossible
    bool step(JobStep step);        ///< by a click in the step bar
    /// Enters a text in the field of that name as a user does: clicks, selects everything, types, presses Enter.
    bool enter(const char* name, const QString& text);
    void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Runs an action on the next modal dialog as soon as it is open.
    void whenDialogStands(std::function<void(QWidget& dialog)> act);
    QString message() const; ///< the sentence above the viewport; empty if there is none
    bool waitFor(const std::function<bool()>& what, int milliseconds = 30000) const;
    /// Until no work runs in the background, except that the boundary is still being refined away from the tool, for
    /// which no user waits.
    bool settle(int milliseconds = 30000) const;
    /// Keeps the picture of the open dialog, or else of the window.
    void shoot(const QString& name) const;

private:
    void open();
    QSize size_;
    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<MainWindow> window_;
};

} // namespace burin::testing

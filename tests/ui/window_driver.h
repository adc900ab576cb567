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

/// A window of its own that knows nothing of the tester's settings and projects, worked by mouse and keyboard.
class WindowDriver {
public:
    /// @param locale  in which numbers are written, as the program sets it before there is a window
    explicit WindowDriver(const QSize& size = QSize(1280, 800), const QLocale& locale = QLocale::c());
    ~WindowDriver();
    WindowDriver(const WindowDriver&) = delete;
    WindowDriver& operator=(const WindowDriver&) = delete;

    MainWindow& window() { return *window_; }
    /// Closes the window and opens a new one, as a restart of the program does. @param quietly as a signal does it
    bool restart(bool quietly = false);
    /// As an end from outside does it: without a question.
    bool endQuietly();
    const QTemporaryDir& folder() const { return *folder_; } ///< for the test's files

    /// A widget that the user sees now; null otherwise.
    template <class T = QWidget>
    T* visible(const char* name) const {
        for (T* widget : window_->findChildren<T*>(QLatin1String(name)))
            if (widget->isVisible()) return widget;
        return nullptr;
    }
    bool clickOn(const char* name); ///< with the mouse; false: nobody could
    bool step(JobStep step);        ///< by a click into the line of steps
    /// Enters a text in the field of that name, as a user does: a click, everything chosen, typed, Enter.
    bool enter(const char* name, const QString& text);
    void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// Does something to the next modal dialog as soon as it stands.
    void whenDialogStands(std::function<void(QWidget& dialog)> act);
    QString message() const; ///< the sentence above the viewport; empty: none
    bool waitFor(const std::function<bool()>& what, int milliseconds = 30000) const;
    bool settle(int milliseconds = 30000) const; ///< until no work runs in the background
    /// Keeps the picture of the dialog that stands, or else the window, as tests/screenshots/<name>.png of the build
    /// tree.
    void shoot(const QString& name) const;

private:
    void open();
    QSize size_;
    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<MainWindow> window_;
};

} // namespace burin::testing

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>

class QAction;
class QMainWindow;

namespace burin {

/// A dock next to the view that is shown while its action is on and its page is visible. Its title bar has the theme's
/// icons; dragging it moves the dock. All arguments outlive it.
class ViewDock : public QDockWidget {
    Q_OBJECT
public:
    struct Look {
        QString title, name;         ///< name: object name of the dock; its buttons are float<name>, close<name>
        QString closeTip;            ///< effect of closing it
        QWidget* titleBar = nullptr; ///< shown instead of the title; null: the title; owned by the dock
        int size = 0;                ///< pixels, initially: its height, or its width at a side
        Qt::DockWidgetArea area = Qt::BottomDockWidgetArea; ///< initially
    };
    /// @param shown checkable; @param view the window whose sides the dock uses, or from which it floats
    ViewDock(const Look& look, QAction& shown, QMainWindow& view);
    /// @param used whether its page is visible
    void setUsed(bool used);

protected:
    void closeEvent(QCloseEvent* event) override;
    /// Called when the action or the visibility of the page has changed.
    virtual void follow();
    bool wanted() const;
    bool used() const noexcept { return used_; }

private:
    QWidget* makeTitleBar(const Look& look);
    QAction& shown_;
    bool used_ = false;
};

} // namespace burin

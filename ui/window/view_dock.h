// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>

class QAction;
class QMainWindow;

namespace burin {

/// A dock next to the view, that is there as long as its action is on and its place is seen. Its
/// title bar has the theme's icons; a drag of it moves the dock. All arguments outlive it.
class ViewDock : public QDockWidget {
    Q_OBJECT
public:
    struct Look {
        QString title, name;         ///< name: object name of the dock; its buttons are float<name>, close<name>
        QString closeTip;            ///< what closing it does
        QWidget* titleBar = nullptr; ///< shown in the title's stead; null: the title; taken over
        int size = 0;                ///< pixels, at first: its height, or its width at a side
        Qt::DockWidgetArea area = Qt::BottomDockWidgetArea; ///< at first
    };
    /// @param shown checkable; @param view what the dock belongs to: its sides, or a window of its own
    ViewDock(const Look& look, QAction& shown, QMainWindow& view);
    /// @param used whether its place is seen
    void setUsed(bool used);

protected:
    void closeEvent(QCloseEvent* event) override;
    /// The action, or the place, is another.
    virtual void follow();
    bool wanted() const;
    bool used() const noexcept { return used_; }

private:
    QWidget* makeTitleBar(const Look& look);
    QAction& shown_;
    bool used_ = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>

class QAction;
class QMainWindow;

namespace burin {

class ProgramPanel;

/// Shows the program's text and findings next to the view, as long as its action is on and the step of the program is
/// open. Closing it puts them back into the panel. All arguments outlive it.
class ProgramDock final : public QDockWidget {
    Q_OBJECT
public:
    /// @param move checkable; @param view what the dock belongs to: its sides, or a window of its own
    ProgramDock(ProgramPanel& panel, QAction& move, QMainWindow& view);
    /// @param used whether the step of the program is seen
    void setUsed(bool used);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makeTitleBar();
    void follow();
    void moveEditor(bool here);

    ProgramPanel& panel_;
    QAction& move_;
    bool used_ = false;
};

} // namespace burin

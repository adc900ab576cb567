// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/view_dock.h"

namespace burin {

class ProgramPanel;

/// Shows the program's text and findings next to the view, as long as its action is on and the step of the program is
/// open. Closing it puts them back into the panel. All arguments outlive it.
class ProgramDock final : public ViewDock {
    Q_OBJECT
public:
    /// @param move checkable; @param view what the dock belongs to: its sides, or a window of its own
    ProgramDock(ProgramPanel& panel, QAction& move, QMainWindow& view);

private:
    void follow() override;
    void moveEditor(bool here);

    ProgramPanel& panel_;
};

} // namespace burin

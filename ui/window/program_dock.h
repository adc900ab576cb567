// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/view_dock.h"

namespace burin {

class ProgramPanel;

/// Shows the program's text and findings next to the view while its action is on and the program step is shown. Closing
/// it moves them back to the panel. All arguments outlive it.
class ProgramDock final : public ViewDock {
    Q_OBJECT
public:
    /// @param move checkable; @param view the window whose sides the dock uses, or from which it floats
    ProgramDock(ProgramPanel& panel, QAction& move, QMainWindow& view);

private:
    void follow() override;
    void moveEditor(bool here);

    ProgramPanel& panel_;
};

} // namespace burin

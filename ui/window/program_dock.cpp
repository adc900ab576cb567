// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/program_dock.h"

#include "ui/panels/program_editor.h"
#include "ui/panels/program_panel.h"

#include <QAction>
#include <QApplication>
#include <QPointer>

namespace burin {

namespace {

constexpr int firstHeight = 280; // pixels

} // namespace

ProgramDock::ProgramDock(ProgramPanel& panel, QAction& move, QMainWindow& view)
    : ViewDock({tr("Program"), QStringLiteral("programDock"), tr("Put text and findings back into the panel"), nullptr,
                firstHeight},
               move, view)
    , panel_(panel) {
    panel.editor().offer(move);
}

void ProgramDock::follow() {
    if (wanted() != (widget() == &panel_.editor())) moveEditor(wanted());
    ViewDock::follow();
}

/// Keeps the keyboard focus in the editor.
void ProgramDock::moveEditor(bool here) {
    ProgramEditor& editor = panel_.editor();
    QPointer<QWidget> focus = QApplication::focusWidget();
    if (focus && !editor.isAncestorOf(focus)) focus = nullptr;
    if (here) {
        setWidget(&editor);
    } else {
        setWidget(nullptr);
        panel_.takeEditor();
    }
    editor.setDocked(here);
    if (!focus) return;
    if (here) setVisible(used());
    focus->window()->activateWindow();
    focus->setFocus();
}

} // namespace burin

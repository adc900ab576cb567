// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/program_dock.h"

#include "ui/panels/buttons.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/program_panel.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>

namespace burin {

namespace {

constexpr int firstHeight = 280; // pixels

} // namespace

ProgramDock::ProgramDock(ProgramPanel& panel, QAction& move, QMainWindow& view)
    : QDockWidget(tr("Program"), &view), panel_(panel), move_(move) {
    setObjectName(QStringLiteral("programDock"));
    setTitleBarWidget(makeTitleBar());
    view.addDockWidget(Qt::BottomDockWidgetArea, this);
    view.resizeDocks({this}, {firstHeight}, Qt::Vertical);
    hide();
    panel.editor().offer(move);
    connect(&move, &QAction::toggled, this, &ProgramDock::follow);
}

/// With the theme's icons; a drag of what is between moves the dock.
QWidget* ProgramDock::makeTitleBar() {
    auto* bar = new QWidget(this);
    auto* title = new QLabel(windowTitle(), bar);
    title->setProperty("look", "section");
    QToolButton* single =
        makeIconButton(QStringLiteral("float"), tr("Make it a window of its own, or put it back next to the view"),
                       QStringLiteral("floatDockButton"), bar);
    QToolButton* back = makeIconButton(QStringLiteral("cancel"), tr("Put text and findings back into the panel"),
                                       QStringLiteral("closeDockButton"), bar);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(8, 2, 4, 2);
    row->setSpacing(4);
    row->addWidget(title, 1);
    row->addWidget(single);
    row->addWidget(back);
    connect(single, &QToolButton::clicked, this, [this] { setFloating(!isFloating()); });
    connect(back, &QToolButton::clicked, this, &QWidget::close);
    return bar;
}

void ProgramDock::setUsed(bool used) {
    used_ = used;
    follow();
}

void ProgramDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    move_.setChecked(false);
}

void ProgramDock::follow() {
    const bool wanted = move_.isChecked();
    if (wanted != (widget() == &panel_.editor())) moveEditor(wanted);
    setVisible(wanted && used_);
}

/// The keyboard goes along.
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
    if (here) setVisible(used_);
    focus->window()->activateWindow();
    focus->setFocus();
}

} // namespace burin

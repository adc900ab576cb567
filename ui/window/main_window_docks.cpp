// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Docks next to the view and the window, shortcuts, help.
#include "ui/dialogs/shortcut_dialog.h"
#include "ui/help/help_dialog.h"
#include "ui/panels/project_tree.h"
#include "ui/panels/timeline_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/program_dock.h"

#include <QApplication>
#include <QSplitter>
#include <QStackedWidget>
#include <QUndoView>

namespace burin {

namespace {

constexpr int sideDockWidth = 260, leastDockWidth = 180; // pixels

} // namespace

void MainWindow::layOutTimeline() {
    timeline_ = new TimelinePanel(
        {*actions_[ActionId::playTime], *actions_[ActionId::presentTime], *actions_[ActionId::punchIn]});
    timelineDock_ = new ViewDock({tr("Timeline"), QStringLiteral("timelineDock"), tr("Hide the timeline"),
                                  timeline_->bar(), timeline_->sizeHint().height()},
                                 *actions_[ActionId::showTimeline], *view_);
    timelineDock_->setWidget(timeline_);
    view_->splitDockWidget(programDock_, timelineDock_, Qt::Vertical); // each as wide as the view
    connect(timelineDock_, &QDockWidget::visibilityChanged, this,
            [this](bool visible) { workbench_.time.setFollowed(visible); });
}

void MainWindow::layOutTree() {
    tree_ = new ProjectTree;
    treeDock_ = new ViewDock({tr("Project"), QStringLiteral("treeDock"), tr("Hide the project tree"), nullptr,
                              sideDockWidth, Qt::LeftDockWidgetArea},
                             *actions_[ActionId::showTree], *view_);
    tree_->setMinimumWidth(leastDockWidth);
    treeDock_->setWidget(tree_);
}

/// The history of commands; each entry leads back to its state.
void MainWindow::layOutHistory() {
    auto* history = new QUndoView(&workbench_.undo());
    history->setObjectName(QStringLiteral("history"));
    history->setAccessibleName(tr("History"));
    history->setEmptyLabel(tr("As opened"));
    history->setToolTip(tr("Click an entry to undo or redo everything up to there."));
    historyDock_ = new ViewDock({tr("History"), QStringLiteral("historyDock"), tr("Hide the history"), nullptr,
                                 sideDockWidth, Qt::LeftDockWidgetArea},
                                *actions_[ActionId::showHistory], *view_);
    history->setMinimumWidth(leastDockWidth);
    historyDock_->setWidget(history);
    // As for Ctrl+Z: not during a stroke, nor while takes are changing.
    const auto follow = [this, history] { history->setEnabled(workbench_.canUndoNow()); };
    for (const Controller* controller :
         {static_cast<const Controller*>(&workbench_.session), static_cast<const Controller*>(&workbench_.showMe),
          static_cast<const Controller*>(&workbench_.mill), static_cast<const Controller*>(&workbench_.setups)})
        connect(controller, &Controller::changed, this, follow);
    connect(&workbench_.session, &SessionRunner::ticked, this, follow);
}

void MainWindow::takeShortcuts() {
    const QMap<QString, QString> own = settings_.shortcuts();
    for (std::size_t i = 0; i < static_cast<std::size_t>(ActionId::count); ++i) {
        QAction* action = actions_[static_cast<ActionId>(i)];
        const auto keys = own.find(action->objectName());
        if (keys != own.end()) action->setShortcut(QKeySequence(*keys, QKeySequence::PortableText));
    }
}

void MainWindow::showShortcuts() {
    std::vector<ShortcutRow> rows;
    for (std::size_t i = 0; i < static_cast<std::size_t>(ActionId::count); ++i) {
        const auto id = static_cast<ActionId>(i);
        rows.push_back({actions_[id], Actions::firstShortcut(id)});
    }
    ShortcutDialog dialog(rows, this);
    connect(&dialog, &ShortcutDialog::changed, this, [this, &rows] {
        QMap<QString, QString> own;
        for (const ShortcutRow& row : rows)
            if (row.action->shortcut() != row.first)
                own.insert(row.action->objectName(), row.action->shortcut().toString(QKeySequence::PortableText));
        settings_.setShortcuts(own);
        delete findChild<KeyList*>(); // it shows the previous shortcuts
    });
    dialog.exec();
}

/// Opens the help on the current step or widget.
void MainWindow::showHelp() {
    const auto topic = [this]() -> QString {
        if (pages_->currentWidget() == welcome_) return QStringLiteral("start");
        if (timeline_->isAncestorOf(QApplication::focusWidget())) return QStringLiteral("time");
        switch (presenters_->job.shown()) {
        case JobStep::part:
            return QStringLiteral("part");
        case JobStep::stock:
        case JobStep::material:
            return QStringLiteral("stock");
        case JobStep::tool:
        case JobStep::allowance:
            return QStringLiteral("tool");
        case JobStep::mill:
            return QStringLiteral("mill");
        case JobStep::path:
            return QStringLiteral("path");
        case JobStep::program:
            return QStringLiteral("program");
        }
        return QStringLiteral("window");
    }();
    auto* help = findChild<HelpDialog*>();
    if (help == nullptr) {
        const QString language = settings_.preferences().language;
        help = new HelpDialog(helpPages(language.isEmpty() ? QLocale().name() : language), this);
        help->setAttribute(Qt::WA_DeleteOnClose);
    }
    help->showTopic(topic);
    help->show();
    help->raise();
    help->activateWindow();
}

/// Restores docks and panel as they were before the user moved them.
void MainWindow::resetLayout() {
    for (const ActionId id : {ActionId::programDock, ActionId::showHistory, ActionId::showTree})
        actions_[id]->setChecked(false);
    actions_[ActionId::showTimeline]->setChecked(true);
    view_->restoreState(firstDocks_);
    work_->restoreState(firstWork_);
    followDocks();
}

void MainWindow::followDocks() {
    treeDock_->setUsed(pages_->currentWidget() == workPage_);
    historyDock_->setUsed(pages_->currentWidget() == workPage_);
    timelineDock_->setUsed(pages_->currentWidget() == workPage_);
    programDock_->setUsed(presenters_ && pages_->currentWidget() == workPage_ &&
                          presenters_->job.shown() == JobStep::program);
}

} // namespace burin

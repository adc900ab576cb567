// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/menus.h"

#include <QFileInfo>

#include <initializer_list>
#include <optional>

namespace burin {

namespace {

using Entries = std::initializer_list<std::optional<ActionId>>; // nothing: a separator

QMenu* addMenu(QMenuBar& bar, const QString& title, const char* name, const Actions& actions, Entries entries) {
    QMenu* menu = bar.addMenu(title);
    menu->setObjectName(QString::fromLatin1(name));
    menu->setToolTipsVisible(true);
    for (const std::optional<ActionId>& entry : entries) {
        if (entry)
            menu->addAction(actions[*entry]);
        else
            menu->addSeparator();
    }
    return menu;
}

} // namespace

Menus::Menus(QMenuBar& bar, const Actions& actions) : QObject(&bar) {
    using enum ActionId;
    constexpr auto line = std::nullopt;
    QMenu* file = addMenu(
        bar, tr("&File"), "fileMenu", actions,
        {newProject, openProject, line, importPart, sampleProject, line, save, saveAs, exportProgram, line, quit});
    recent_ = new QMenu(tr("Open &recent"), file);
    recent_->setObjectName(QStringLiteral("recentMenu"));
    file->insertMenu(file->actions().at(2), recent_);
    addMenu(bar, tr("&Edit"), "editMenu", actions, {undo, redo, line, preferences});
    addMenu(bar, tr("&View"), "viewMenu", actions,
            {fit, line, viewIsometric, viewTop, viewBottom, viewFront, viewBack, viewLeft, viewRight, line,
             showWorkpiece, showPart, showTool, showPath, showOtherPaths, showGuides, line, nextStep, previousStep});
    addMenu(bar, tr("&Mill"), "millMenu", actions,
            {embed,     addFixtureFile, axisOfView,  line,        millMode, record, line,
             guides,    nearestEdge,    levelAbove,  levelBelow,  line,     clutch, recentre,
             alignHand, finerHand,      coarserHand, rateControl, line,     showMe, stopShow});
    addMenu(bar, tr("&Path"), "pathMenu", actions, {newPath, evaluatePath, line, drawStretch, drawEdit});
    addMenu(bar, tr("P&rogram"), "programMenu", actions, {post, exportProgram, overrideCheck, line, findInProgram});
    addMenu(bar, tr("&Help"), "helpMenu", actions, {welcome, about});
    setRecentFiles({});
}

void Menus::setRecentFiles(const QStringList& files) {
    recent_->clear();
    recent_->setEnabled(!files.isEmpty());
    for (const QString& file : files) {
        QAction* action = recent_->addAction(QFileInfo(file).fileName());
        action->setToolTip(file);
        connect(action, &QAction::triggered, this, [this, file] { emit recentChosen(file); });
    }
}

} // namespace burin

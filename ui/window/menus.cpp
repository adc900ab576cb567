// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/menus.h"

#include <QFileInfo>

#include <initializer_list>
#include <optional>

namespace burin {

namespace {

using Entries = std::initializer_list<std::optional<ActionId>>; // empty: a separator

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

Menus::Menus(QMenuBar& bar, const Actions& actions) : QObject(&bar), bar_(bar) {
    using enum ActionId;
    constexpr auto line = std::nullopt;
    QMenu* file = addMenu(bar, tr("&File"), "fileMenu", actions,
                          {newProject, openProject, line, importPart, updatePart, sampleProject, line, save, saveAs,
                           exportProgram, exportWorkpiece, exportSheet, exportPicture, line, quit});
    recent_ = new QMenu(tr("Open &recent"), file);
    recent_->setObjectName(QStringLiteral("recentMenu"));
    file->insertMenu(file->actions().at(2), recent_);
    addMenu(bar, tr("&Edit"), "editMenu", actions,
            {undo, redo, showHistory, line, tools, materials, devices, shortcuts, preferences});
    addMenu(bar, tr("&View"), "viewMenu", actions,
            {fit,          line,        viewIsometric, viewTop,          viewBottom,  viewFront,
             viewBack,     viewLeft,    viewRight,     parallelView,     line,        seeThrough,
             sectionPlane, flipSection, measure,       measureWorkpiece, line,        showWorkpiece,
             showPart,     showTool,    showPath,      showOtherPaths,   pathColours, excess,
             showGuides,   line,        showTimeline,  showTree,         resetLayout, line,
             nextStep,     previousStep});
    addMenu(bar, tr("&Setup"), "setupMenu", actions,
            {addSetup, nextSetup, previousSetup, line, faceDown, turnAboutX, turnAboutY, turnAboutZ, placementHandles,
             holdAtStock, line, pickZero, touchZero});
    addMenu(bar, tr("&Mill"), "millMenu", actions,
            {embed,       stockFile, toolShape,   libraryFixture, addFixtureFile, axisOfView,    line,
             millMode,    raster,    repeatLower, repeatLeft,     repeatRight,    line,          playTime,
             presentTime, punchIn,   addMarker,   takeUp,         takeDown,       duplicateTake, scoreTake,
             line,        guides,    nearestEdge, levelAbove,     levelBelow,     line,          clutch,
             recentre,    alignHand, finerHand,   coarserHand,    rateControl,    keepFromStock, recordTrace,
             line,        showMe,    stopShow});
    addMenu(bar, tr("&Path"), "pathMenu", actions,
            {newPath, newPass, programPath, measurePasses, refreshPasses, brushArea, lassoArea, faceArea, clearArea,
             pickHoles, evaluatePath, comparePaths, line, drawInterval, insertPoint, stylusEdit, drawEdit});
    addMenu(bar, tr("P&rogram"), "programMenu", actions,
            {post, exportProgram, overrideCheck, restart, inspectFaces, line, findInProgram, breakpoint, programDock,
             line, machines});
    addMenu(bar, tr("&Help"), "helpMenu", actions, {help, firstJob, welcome, keyList, about});
    setRecentFiles({});
}

std::vector<KeySection> Menus::keys() const {
    const auto textOf = [](const QAction& action) { return action.iconText().remove(QChar(0x2026)); }; // "…"
    std::vector<KeySection> sections;
    for (const QAction* entry : bar_.actions()) {
        KeySection section{entry->iconText(), {}};
        for (const QAction* action : entry->menu()->actions())
            if (!action->shortcut().isEmpty())
                section.lines.push_back(
                    {action->shortcut().toString(QKeySequence::NativeText), textOf(*action), action->toolTip()});
        sections.push_back(std::move(section));
    }
    return sections;
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

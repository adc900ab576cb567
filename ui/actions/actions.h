// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QObject>

#include <array>
#include <cstddef>

namespace burin {

/// All actions of the menus.
enum class ActionId : std::size_t {
    newProject,
    openProject,
    importPart,
    updatePart,
    sampleProject,
    save,
    saveAs,
    exportProgram,
    exportWorkpiece,
    exportSheet,
    exportPicture,
    undo, ///< the texts of undo and redo name the command
    redo,
    showHistory,
    preferences,
    shortcuts,
    quit,
    fit,
    viewIsometric,
    viewTop,
    viewBottom,
    viewFront,
    viewBack,
    viewLeft,
    viewRight,
    parallelView,
    seeThrough,
    sectionPlane,
    flipSection,
    measure,
    measureWorkpiece,
    showPart,
    showWorkpiece,
    showTool,
    showPath,
    showGuides,
    showOtherPaths,
    pathColours,
    excess,
    nextStep,
    previousStep,
    addSetup,
    nextSetup,
    previousSetup,
    faceDown,
    turnAboutX,
    turnAboutY,
    turnAboutZ,
    placementHandles,
    pickZero,
    holdAtStock,
    touchZero,
    embed,
    stockFile,
    toolShape,
    libraryFixture,
    addFixtureFile,
    axisOfView,
    millMode,
    raster,
    repeatLower,
    repeatLeft,
    repeatRight,
    showMe,
    stopShow,
    guides,
    nearestEdge,
    levelAbove,
    levelBelow,
    clutch,
    recentre,
    alignHand,
    finerHand,
    coarserHand,
    rateControl,
    keepFromStock,
    recordTrace,
    newPath,
    newPass,
    programPath,
    measurePasses,
    refreshPasses,
    brushArea,
    lassoArea,
    faceArea,
    clearArea,
    pickHoles,
    evaluatePath,
    comparePaths,
    drawInterval,
    insertPoint,
    stylusEdit,
    drawEdit,
    post,
    findInProgram,
    programDock,
    showTimeline,
    showTree,
    resetLayout,
    playTime,
    breakpoint,
    presentTime,
    punchIn,
    addMarker,
    scoreTake,
    takeUp, ///< this and the next two act on the chosen take
    takeDown,
    duplicateTake,
    overrideCheck,
    restart,
    inspectFaces,
    machines,
    tools,
    materials,
    devices,
    help,
    welcome,
    firstJob,
    keyList,
    about,
    count
};

/// All actions of the window in one place: object name, text, tooltip, shortcut. The window connects them to their
/// functions.
class Actions final : public QObject {
    Q_OBJECT
public:
    explicit Actions(QObject* parent = nullptr);

    /// The default shortcut of an action.
    static QKeySequence firstShortcut(ActionId id);
    QAction* operator[](ActionId id) const { return actions_[static_cast<std::size_t>(id)]; }

private:
    std::array<QAction*, static_cast<std::size_t>(ActionId::count)> actions_{};
};

} // namespace burin

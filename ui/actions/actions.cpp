// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/actions.h"

#include <QCoreApplication>

#include <algorithm>

namespace burin {

namespace {

struct Row {
    ActionId id;
    const char* name; ///< object name
    const char* text;
    const char* toolTip;
    const char* shortcut;
    bool checkable = false;
};

constexpr const char* context = "Actions";

constexpr std::array rows{
    Row{ActionId::newProject, "newProjectAction", QT_TRANSLATE_NOOP("Actions", "&New"),
        QT_TRANSLATE_NOOP("Actions", "Begin a new, empty project."), "Ctrl+N"},
    Row{ActionId::openProject, "openAction", QT_TRANSLATE_NOOP("Actions", "&Open…"),
        QT_TRANSLATE_NOOP("Actions", "Open a project, or a program to check and play."), "Ctrl+O"},
    Row{ActionId::importPart, "importAction", QT_TRANSLATE_NOOP("Actions", "&Import a part…"),
        QT_TRANSLATE_NOOP("Actions",
                          "Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF)."),
        "Ctrl+I"},
    Row{ActionId::updatePart, "updatePartAction", QT_TRANSLATE_NOOP("Actions", "&Update the part"),
        QT_TRANSLATE_NOOP("Actions", "Read the part again after it was changed in the CAD system. Setups, roles, "
                                     "materials, recordings and paths stay."),
        "Ctrl+Shift+U"},
    Row{ActionId::sampleProject, "sampleAction", QT_TRANSLATE_NOOP("Actions", "Sample &part"),
        QT_TRANSLATE_NOOP("Actions", "Import the part that Burin is shipped with."), "Ctrl+Shift+I"},
    Row{ActionId::save, "saveAction", QT_TRANSLATE_NOOP("Actions", "&Save"),
        QT_TRANSLATE_NOOP("Actions", "Save the project."), "Ctrl+S"},
    Row{ActionId::saveAs, "saveAsAction", QT_TRANSLATE_NOOP("Actions", "Save &as…"),
        QT_TRANSLATE_NOOP("Actions", "Save the project under another name and continue with it."), "Ctrl+Shift+S"},
    Row{ActionId::exportProgram, "exportAction", QT_TRANSLATE_NOOP("Actions", "&Export the program…"),
        QT_TRANSLATE_NOOP("Actions", "Write the program that passed its check to a file."), "Ctrl+E"},
    Row{ActionId::exportWorkpiece, "exportWorkpieceAction", QT_TRANSLATE_NOOP("Actions", "Export the &workpiece…"),
        QT_TRANSLATE_NOOP("Actions", "Write the workpiece as a surface (STL, PLY, 3MF) or as voxels."), "Ctrl+Shift+W"},
    Row{ActionId::exportSheet, "exportSheetAction", QT_TRANSLATE_NOOP("Actions", "Export the setup s&heet…"),
        QT_TRANSLATE_NOOP("Actions", "Write a page for the machine: pictures, zero, fixtures, tools, times, findings."),
        "Ctrl+Shift+H"},
    Row{ActionId::exportPicture, "exportPictureAction", QT_TRANSLATE_NOOP("Actions", "Export a p&icture…"),
        QT_TRANSLATE_NOOP("Actions", "Write what the view shows to a PNG file."), "Ctrl+Shift+G"},
    Row{ActionId::undo, "undoAction", QT_TRANSLATE_NOOP("Actions", "&Undo"),
        QT_TRANSLATE_NOOP("Actions", "Undo the last change."), "Ctrl+Z"},
    Row{ActionId::redo, "redoAction", QT_TRANSLATE_NOOP("Actions", "&Redo"),
        QT_TRANSLATE_NOOP("Actions", "Redo the change that was undone last."), "Ctrl+Shift+Z"},
    Row{ActionId::showHistory, "historyAction", QT_TRANSLATE_NOOP("Actions", "H&istory"),
        QT_TRANSLATE_NOOP("Actions", "Show all changes next to the view; a click goes back to one, or forward again."),
        "Ctrl+H", true},
    Row{ActionId::preferences, "preferencesAction", QT_TRANSLATE_NOOP("Actions", "&Preferences…"),
        QT_TRANSLATE_NOOP("Actions", "Unit, theme and language."), "Ctrl+,"},
    Row{ActionId::shortcuts, "shortcutsAction", QT_TRANSLATE_NOOP("Actions", "&Keyboard shortcuts…"),
        QT_TRANSLATE_NOOP("Actions", "Change the shortcuts of actions."), "Ctrl+Shift+,"},
    Row{ActionId::quit, "quitAction", QT_TRANSLATE_NOOP("Actions", "&Quit"),
        QT_TRANSLATE_NOOP("Actions", "Quit Burin."), "Ctrl+Q"},
    Row{ActionId::fit, "fitAction", QT_TRANSLATE_NOOP("Actions", "&Fit"),
        QT_TRANSLATE_NOOP("Actions", "Show everything."), "F"},
    Row{ActionId::viewIsometric, "viewIsometricAction", QT_TRANSLATE_NOOP("Actions", "&Isometric"),
        QT_TRANSLATE_NOOP("Actions", "Look from a corner."), "0"},
    Row{ActionId::viewTop, "viewTopAction", QT_TRANSLATE_NOOP("Actions", "&Top"),
        QT_TRANSLATE_NOOP("Actions", "Look along the tool."), "1"},
    Row{ActionId::viewBottom, "viewBottomAction", QT_TRANSLATE_NOOP("Actions", "&Bottom"),
        QT_TRANSLATE_NOOP("Actions", "Look from below."), "2"},
    Row{ActionId::viewFront, "viewFrontAction", QT_TRANSLATE_NOOP("Actions", "F&ront"),
        QT_TRANSLATE_NOOP("Actions", "Look from the front."), "3"},
    Row{ActionId::viewBack, "viewBackAction", QT_TRANSLATE_NOOP("Actions", "B&ack"),
        QT_TRANSLATE_NOOP("Actions", "Look from the back."), "4"},
    Row{ActionId::viewLeft, "viewLeftAction", QT_TRANSLATE_NOOP("Actions", "&Left"),
        QT_TRANSLATE_NOOP("Actions", "Look from the left."), "5"},
    Row{ActionId::viewRight, "viewRightAction", QT_TRANSLATE_NOOP("Actions", "Ri&ght"),
        QT_TRANSLATE_NOOP("Actions", "Look from the right."), "6"},
    Row{ActionId::parallelView, "parallelViewAction", QT_TRANSLATE_NOOP("Actions", "Parallel pro&jection"),
        QT_TRANSLATE_NOOP("Actions", "Parallel edges stay parallel in every view. Views along an axis always are so."),
        "P", true},
    Row{ActionId::seeThrough, "seeThroughAction", QT_TRANSLATE_NOOP("Actions", "Transpare&nt workpiece"),
        QT_TRANSLATE_NOOP("Actions", "Show the part through the workpiece."), "I", true},
    Row{ActionId::sectionPlane, "sectionPlaneAction", QT_TRANSLATE_NOOP("Actions", "S&ection"),
        QT_TRANSLATE_NOOP("Actions", "Section the part and the workpiece in the view."), "S", true},
    Row{ActionId::flipSection, "flipSectionAction", QT_TRANSLATE_NOOP("Actions", "Fl&ip"),
        QT_TRANSLATE_NOOP("Actions", "Show the other side of the section plane."), "Shift+S"},
    Row{ActionId::measure, "measureAction", QT_TRANSLATE_NOOP("Actions", "&Measure"),
        QT_TRANSLATE_NOOP("Actions", "Click points on the part: diameter, wall thickness, area, distances and angle."),
        "Ctrl+J", true},
    Row{ActionId::measureWorkpiece, "measureWorkpieceAction", QT_TRANSLATE_NOOP("Actions", "Measure the wor&kpiece"),
        QT_TRANSLATE_NOOP("Actions", "Click points on the workpiece as it is milled: thickness, depth, width, "
                                     "diameter, stock left on the part, distances and angle."),
        "Ctrl+Alt+I", true},
    Row{ActionId::showPart, "showPartAction", QT_TRANSLATE_NOOP("Actions", "&Part"),
        QT_TRANSLATE_NOOP("Actions", "Draw the part together with the workpiece."), "Ctrl+1", true},
    Row{ActionId::showWorkpiece, "showWorkpieceAction", QT_TRANSLATE_NOOP("Actions", "&Workpiece"),
        QT_TRANSLATE_NOOP("Actions", "Draw the workpiece."), "Ctrl+2", true},
    Row{ActionId::showTool, "showToolAction", QT_TRANSLATE_NOOP("Actions", "T&ool"),
        QT_TRANSLATE_NOOP("Actions", "Draw the tool."), "Ctrl+3", true},
    Row{ActionId::showPath, "showPathAction", QT_TRANSLATE_NOOP("Actions", "Pat&h"),
        QT_TRANSLATE_NOOP("Actions", "Draw the edited path."), "Ctrl+4", true},
    Row{ActionId::showGuides, "showGuidesAction", QT_TRANSLATE_NOOP("Actions", "G&uides"),
        QT_TRANSLATE_NOOP("Actions", "Draw the guides of the hand that are on."), "Ctrl+5", true},
    Row{ActionId::showOtherPaths, "showOtherPathsAction", QT_TRANSLATE_NOOP("Actions", "Paths of other tool&s"),
        QT_TRANSLATE_NOOP("Actions", "Draw the paths of the job's other tools."), "Ctrl+6", true},
    Row{ActionId::pathColours, "pathColoursAction", QT_TRANSLATE_NOOP("Actions", "Next path &colours"),
        QT_TRANSLATE_NOOP("Actions", "Colour the path by its feed, spindle speed, height, removal rate, force or "
                                     "deviation from the recording, in turn."),
        "Ctrl+7"},
    Row{ActionId::excess, "excessAction", QT_TRANSLATE_NOOP("Actions", "E&xcess stock"),
        QT_TRANSLATE_NOOP("Actions", "Colour the workpiece by the stock that is left on the part, during milling, too. "
                                     "Rest the pointer on it to read how much."),
        "Ctrl+8", true},
    Row{ActionId::nextStep, "nextStepAction", QT_TRANSLATE_NOOP("Actions", "&Next step"),
        QT_TRANSLATE_NOOP("Actions", "Open the next step of the job."), "Alt+Right"},
    Row{ActionId::previousStep, "previousStepAction", QT_TRANSLATE_NOOP("Actions", "Pre&vious step"),
        QT_TRANSLATE_NOOP("Actions", "Open the step of the job before this one."), "Alt+Left"},
    Row{ActionId::addSetup, "addSetupAction", QT_TRANSLATE_NOOP("Actions", "&Add a setup…"),
        QT_TRANSLATE_NOOP(
            "Actions", "Add a setup for another side of the part. Its stock is the workpiece that this setup leaves."),
        "Ctrl+Shift+N"},
    Row{ActionId::nextSetup, "nextSetupAction", QT_TRANSLATE_NOOP("Actions", "&Next setup"),
        QT_TRANSLATE_NOOP("Actions", "Switch to the next setup."), "Ctrl+Shift+PgDown"},
    Row{ActionId::previousSetup, "previousSetupAction", QT_TRANSLATE_NOOP("Actions", "Pre&vious setup"),
        QT_TRANSLATE_NOOP("Actions", "Switch to the previous setup."), "Ctrl+Shift+PgUp"},
    Row{ActionId::faceDown, "faceDownAction", QT_TRANSLATE_NOOP("Actions", "Orient a face &down"),
        QT_TRANSLATE_NOOP("Actions",
                          "Click a face of the part in the view. The part is rotated so that this face points down."),
        "Ctrl+Shift+D"},
    Row{ActionId::turnAboutX, "turnAboutXAction", QT_TRANSLATE_NOOP("Actions", "Rotate by 90° about &X"),
        QT_TRANSLATE_NOOP("Actions", "Rotate the part by 90° about X, through its centre."), "Ctrl+Alt+X"},
    Row{ActionId::turnAboutY, "turnAboutYAction", QT_TRANSLATE_NOOP("Actions", "Rotate by 90° about &Y"),
        QT_TRANSLATE_NOOP("Actions", "Rotate the part by 90° about Y, through its centre."), "Ctrl+Alt+Y"},
    Row{ActionId::turnAboutZ, "turnAboutZAction", QT_TRANSLATE_NOOP("Actions", "Rotate by 90° about &Z"),
        QT_TRANSLATE_NOOP("Actions", "Rotate the part by 90° about Z, through its centre."), "Ctrl+Alt+Z"},
    Row{ActionId::placementHandles, "placementHandlesAction", QT_TRANSLATE_NOOP("Actions", "&Handles in the view"),
        QT_TRANSLATE_NOOP("Actions",
                          "Show arrows, squares and rings that move and rotate the part, or the fixture that "
                          "is being placed, by the mouse. Shift: fine; Ctrl: in steps."),
        "Ctrl+Alt+M", true},
    Row{ActionId::pickZero, "pickZeroAction", QT_TRANSLATE_NOOP("Actions", "&Pick program zero"),
        QT_TRANSLATE_NOOP("Actions", "Click a vertex, an edge or a circle of the part, or a corner of the stock."),
        "Ctrl+Shift+O"},
    Row{ActionId::holdAtStock, "holdAtStockAction", QT_TRANSLATE_NOOP("Actions", "&Stop the tool at the stock"),
        QT_TRANSLATE_NOOP("Actions", "Until a recording starts, the stock stops the tool, as it was before milling, so "
                                     "that its sides can be touched off."),
        "Ctrl+Alt+U", true},
    Row{ActionId::touchZero, "touchZeroAction", QT_TRANSLATE_NOOP("Actions", "&Touch off program zero"),
        QT_TRANSLATE_NOOP("Actions",
                          "The face of the part or stock that the tool touches becomes zero along its axis, as with an "
                          "edge finder."),
        "Ctrl+Alt+O"},
    Row{ActionId::embed, "embedAction", QT_TRANSLATE_NOOP("Actions", "&Embed the part"),
        QT_TRANSLATE_NOOP("Actions", "Embed the part in its stock; this makes the workpiece."), "Ctrl+B"},
    Row{ActionId::stockFile, "stockFileAction", QT_TRANSLATE_NOOP("Actions", "Stoc&k from a file…"),
        QT_TRANSLATE_NOOP("Actions", "Read the stock from a volume file, a voxel array (a scan) or a model."),
        "Ctrl+Shift+B"},
    Row{ActionId::toolShape, "toolShapeAction", QT_TRANSLATE_NOOP("Actions", "Too&l from models…"),
        QT_TRANSLATE_NOOP("Actions", "Make a tool of models of its flutes and its shank: a form tool, a worn cutter."),
        "Ctrl+Shift+L"},
    Row{ActionId::libraryFixture, "libraryFixtureAction", QT_TRANSLATE_NOOP("Actions", "A&dd a fixture…"),
        QT_TRANSLATE_NOOP("Actions", "Place a vise, clamp, screw, parallels or plate of the library with the mouse; "
                                     "the tool keeps clear of it."),
        "Ctrl+Alt+W"},
    Row{ActionId::addFixtureFile, "addFixtureAction", QT_TRANSLATE_NOOP("Actions", "Fixture from a &file…"),
        QT_TRANSLATE_NOOP("Actions", "Import a fixture in the coordinates of the setup; the tool keeps clear of it."),
        "Ctrl+Shift+F"},
    Row{ActionId::axisOfView, "axisOfViewAction", QT_TRANSLATE_NOOP("Actions", "Tool a&xis along the view"),
        QT_TRANSLATE_NOOP("Actions", "Sets the tool axis to the view direction (3+2 milling)."), "Ctrl+Shift+X"},
    Row{ActionId::millMode, "millModeAction", QT_TRANSLATE_NOOP("Actions", "&Mill"),
        QT_TRANSLATE_NOOP("Actions", "Start or stop milling. Everything that is cut is recorded."), "M", true},
    Row{ActionId::raster, "rasterAction", QT_TRANSLATE_NOOP("Actions", "Ras&ter"),
        QT_TRANSLATE_NOOP("Actions", "Drag a rectangle; it is milled in rows at the step-over."), "T", true},
    Row{ActionId::repeatLower, "repeatLowerAction", QT_TRANSLATE_NOOP("Actions", "Repeat &lower"),
        QT_TRANSLATE_NOOP("Actions", "Repeat the last stroke, lower by the depth of cut."), "L"},
    Row{ActionId::repeatLeft, "repeatLeftAction", QT_TRANSLATE_NOOP("Actions", "Repeat beside, le&ft"),
        QT_TRANSLATE_NOOP("Actions", "Repeat the last stroke one step-over to the left of its direction."), "B"},
    Row{ActionId::repeatRight, "repeatRightAction", QT_TRANSLATE_NOOP("Actions", "Repeat beside, ri&ght"),
        QT_TRANSLATE_NOOP("Actions", "Repeat the last stroke one step-over to the right of its direction."), "Shift+B"},
    Row{ActionId::showMe, "showMeAction", QT_TRANSLATE_NOOP("Actions", "&Show me"),
        QT_TRANSLATE_NOOP("Actions", "Watch a virtual operator mill this part."), "Ctrl+M"},
    Row{ActionId::stopShow, "stopShowAction", QT_TRANSLATE_NOOP("Actions", "S&top the virtual operator"),
        QT_TRANSLATE_NOOP("Actions", "Stop; the recording is kept."), "Ctrl+."},
    Row{ActionId::guides, "guidesAction", QT_TRANSLATE_NOOP("Actions", "&Guides on"),
        QT_TRANSLATE_NOOP("Actions", "Switch all guides of the hand on or off."), "G", true},
    Row{ActionId::nearestEdge, "nearestEdgeAction", QT_TRANSLATE_NOOP("Actions", "Guide along the nearest &edge"),
        QT_TRANSLATE_NOOP("Actions", "Lead the hand along the edge of the part that is nearest to the tool."), "E"},
    Row{ActionId::levelAbove, "levelAboveAction", QT_TRANSLATE_NOOP("Actions", "Level &above"),
        QT_TRANSLATE_NOOP("Actions", "The guide takes the next level above, or ends the pass."), "Ctrl+PgUp"},
    Row{ActionId::levelBelow, "levelBelowAction", QT_TRANSLATE_NOOP("Actions", "Level &below"),
        QT_TRANSLATE_NOOP("Actions", "The guide takes the next level below, or ends the pass."), "Ctrl+PgDown"},
    Row{ActionId::clutch, "clutchAction", QT_TRANSLATE_NOOP("Actions", "&Clutch"),
        QT_TRANSLATE_NOOP("Actions", "The hand moves, the tool stays."), "C", true},
    Row{ActionId::recentre, "recentreAction", QT_TRANSLATE_NOOP("Actions", "Re&centre"),
        QT_TRANSLATE_NOOP("Actions", "Brings the hand back to the centre of the device's workspace while you work."),
        "Ctrl+R"},
    Row{ActionId::alignHand, "alignHandAction", QT_TRANSLATE_NOOP("Actions", "A&lign the hand with the view"),
        QT_TRANSLATE_NOOP("Actions", "A hand movement to the right moves the tool to the right in the view."),
        "Ctrl+L"},
    Row{ActionId::finerHand, "finerHandAction", QT_TRANSLATE_NOOP("Actions", "Fi&ner hand"),
        QT_TRANSLATE_NOOP("Actions", "Smaller tool movement for the same hand movement."), "["},
    Row{ActionId::coarserHand, "coarserHandAction", QT_TRANSLATE_NOOP("Actions", "C&oarser hand"),
        QT_TRANSLATE_NOOP("Actions", "Larger tool movement for the same hand movement."), "]"},
    Row{ActionId::rateControl, "rateControlAction", QT_TRANSLATE_NOOP("Actions", "The hand sets the spee&d"),
        QT_TRANSLATE_NOOP("Actions", "A stylus without motors sets the tool's speed, not its position."), "V", true},
    Row{ActionId::keepFromStock, "keepFromStockAction", QT_TRANSLATE_NOOP("Actions", "&Keep from the stock"),
        QT_TRANSLATE_NOOP("Actions", "Shank and holder push back before they touch the stock. The distance is set with "
                                     "the devices."),
        "Ctrl+Alt+K", true},
    Row{ActionId::recordTrace, "recordTraceAction", QT_TRANSLATE_NOOP("Actions", "Record a session trace…"),
        QT_TRANSLATE_NOOP("Actions",
                          "Write every reading of the stylus, from entering mill mode until leaving it, to a "
                          "file that \"burin mill\" replays to the bit."),
        "Ctrl+Alt+S", true},
    Row{ActionId::newPath, "newPathAction", QT_TRANSLATE_NOOP("Actions", "&New path"),
        QT_TRANSLATE_NOOP("Actions", "Make a path from the takes, with the standard edits."), "Ctrl+P"},
    Row{ActionId::newPass, "newPassAction", QT_TRANSLATE_NOOP("Actions", "&Compute a pass…"),
        QT_TRANSLATE_NOOP(
            "Actions",
            "Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool."),
        "Ctrl+Shift+P"},
    Row{ActionId::programPath, "programPathAction", QT_TRANSLATE_NOOP("Actions", "Path from a pro&gram…"),
        QT_TRANSLATE_NOOP("Actions", "Edit a program of another system (G-code or APT/CL) as a path: its moves, feeds "
                                     "and speeds; Burin links them anew."),
        "Ctrl+Alt+G"},
    Row{ActionId::measurePasses, "measurePassesAction", QT_TRANSLATE_NOOP("Actions", "&Measure the passes"),
        QT_TRANSLATE_NOOP("Actions",
                          "Length, time, share of air and engagement of each pass, and the stock that it leaves."),
        "Ctrl+Alt+P"},
    Row{ActionId::refreshPasses, "refreshPassesAction", QT_TRANSLATE_NOOP("Actions", "Compute ou&tdated passes again"),
        QT_TRANSLATE_NOOP("Actions",
                          "Compute those passes of the path again whose strokes have changed; all others stay "
                          "as they are."),
        "Ctrl+Alt+R"},
    Row{ActionId::brushArea, "brushAreaAction", QT_TRANSLATE_NOOP("Actions", "Paint an area with the &brush"),
        QT_TRANSLATE_NOOP("Actions", "Paint the area of the next pass on the part; Shift erases."), "Ctrl+Shift+A"},
    Row{ActionId::lassoArea, "lassoAreaAction", QT_TRANSLATE_NOOP("Actions", "Draw an area with the &lasso"),
        QT_TRANSLATE_NOOP("Actions", "Draw round the area of the next pass; Shift erases."), "Ctrl+Alt+A"},
    Row{ActionId::faceArea, "faceAreaAction", QT_TRANSLATE_NOOP("Actions", "Pick &faces as the area"),
        QT_TRANSLATE_NOOP("Actions", "Click faces of the part for the next pass; Shift removes them."), "Ctrl+Alt+F"},
    Row{ActionId::clearArea, "clearAreaAction", QT_TRANSLATE_NOOP("Actions", "Clea&r the area"),
        QT_TRANSLATE_NOOP("Actions", "The next pass goes over the whole part again."), "Ctrl+Alt+C"},
    Row{ActionId::pickHoles, "pickHolesAction", QT_TRANSLATE_NOOP("Actions", "Pick &holes for a pass"),
        QT_TRANSLATE_NOOP("Actions",
                          "Click holes of the part for drilling or thread milling with the loaded tool, or studs for "
                          "external threads."),
        "Ctrl+Alt+H"},
    Row{ActionId::evaluatePath, "evaluatePathAction", QT_TRANSLATE_NOOP("Actions", "&Update path"),
        QT_TRANSLATE_NOOP("Actions", "Apply the edits to the takes again."), "F5"},
    Row{ActionId::comparePaths, "comparePathsAction", QT_TRANSLATE_NOOP("Actions", "C&ompare paths…"),
        QT_TRANSLATE_NOOP("Actions", "Compare the path with another one, with the recording or with itself without an "
                                     "edit: lengths, time and deviation."),
        "Ctrl+Alt+V"},
    Row{ActionId::drawInterval, "drawStretchAction", QT_TRANSLATE_NOOP("Actions", "&Draw instead"),
        QT_TRANSLATE_NOOP("Actions", "Draw a stroke in the view that replaces the selected part of the path."),
        "Ctrl+D"},
    Row{ActionId::insertPoint, "insertPointAction", QT_TRANSLATE_NOOP("Actions", "Insert a &point"),
        QT_TRANSLATE_NOOP("Actions", "Insert a point where the path is selected. Drag it in the view to move it; the "
                                     "stroke follows it smoothly."),
        "Ins"},
    Row{ActionId::stylusEdit, "stylusEditAction", QT_TRANSLATE_NOOP("Actions", "Edit with the st&ylus"),
        QT_TRANSLATE_NOOP("Actions", "Move points of the path with the chosen stylus, and feel part and fixtures."),
        "Ctrl+Alt+E", true},
    Row{ActionId::drawEdit, "drawEditAction", QT_TRANSLATE_NOOP("Actions", "Draw for an ed&it"),
        QT_TRANSLATE_NOOP("Actions", "Draw the area, the guide or the mirror plane of the last edit that has one."),
        "Ctrl+Alt+D"},
    Row{ActionId::post, "postAction", QT_TRANSLATE_NOOP("Actions", "&Post and check"),
        QT_TRANSLATE_NOOP("Actions", "Make the program, read it back and check it."), "F6"},
    Row{ActionId::findInProgram, "findAction", QT_TRANSLATE_NOOP("Actions", "&Find in the program"),
        QT_TRANSLATE_NOOP("Actions", "Look for a text in the program."), "Ctrl+F"},
    Row{ActionId::programDock, "programDockAction", QT_TRANSLATE_NOOP("Actions", "&Text next to the view"),
        QT_TRANSLATE_NOOP("Actions", "Show the program's text and findings next to the view instead of in the panel."),
        "F7", true},
    Row{ActionId::showTimeline, "timelineAction", QT_TRANSLATE_NOOP("Actions", "Time&line"),
        QT_TRANSLATE_NOOP("Actions", "Show the takes along their time below the view."), "F9", true},
    Row{ActionId::showTree, "treeAction", QT_TRANSLATE_NOOP("Actions", "Pro&ject tree"),
        QT_TRANSLATE_NOOP("Actions", "Show setups, bodies, fixtures, tools, takes, paths and program as a tree."),
        "Ctrl+F10", true},
    Row{ActionId::resetLayout, "resetLayoutAction", QT_TRANSLATE_NOOP("Actions", "Reset the &window layout"),
        QT_TRANSLATE_NOOP("Actions", "Put docks and panels back to where they were at first."), "Ctrl+Shift+F9"},
    Row{ActionId::playTime, "playAction", QT_TRANSLATE_NOOP("Actions", "&Play or pause"),
        QT_TRANSLATE_NOOP("Actions", "Play the takes, or the program, from the time shown; the workpiece follows."),
        "Ctrl+F9"},
    Row{ActionId::breakpoint, "breakpointAction", QT_TRANSLATE_NOOP("Actions", "&Breakpoint"),
        QT_TRANSLATE_NOOP("Actions",
                          "Stop a play of the program before the line of the cursor, or no longer. A click on "
                          "the line's number does the same."),
        "Ctrl+Alt+B"},
    Row{ActionId::presentTime, "presentAction", QT_TRANSLATE_NOOP("Actions", "Back to the &current state"),
        QT_TRANSLATE_NOOP("Actions", "Show the workpiece as it is now."), "Shift+F9"},
    Row{ActionId::punchIn, "punchInAction", QT_TRANSLATE_NOOP("Actions", "P&unch in"),
        QT_TRANSLATE_NOOP(
            "Actions", "Continue milling from the time shown. Everything recorded after it is switched off, and can be "
                       "switched on again."),
        "Ctrl+Shift+R"},
    Row{ActionId::addMarker, "addMarkerAction", QT_TRANSLATE_NOOP("Actions", "Add a mar&ker…"),
        QT_TRANSLATE_NOOP("Actions", "Set a named marker at the time shown on the timeline."), "Ctrl+K"},
    Row{ActionId::scoreTake, "scoreTakeAction", QT_TRANSLATE_NOOP("Actions", "Sco&re a take…"),
        QT_TRANSLATE_NOOP("Actions",
                          "State how well a take was milled, and compare it with a reference, for training."),
        "Ctrl+Alt+N"},
    Row{ActionId::takeUp, "takeUpAction", QT_TRANSLATE_NOOP("Actions", "Mo&ve the take up"),
        QT_TRANSLATE_NOOP("Actions", "Replay the take that is selected in the project tree or on the timeline before "
                                     "the take above it. The workpiece at the end and the paths stay as they are."),
        "Ctrl+Shift+Up"},
    Row{ActionId::takeDown, "takeDownAction", QT_TRANSLATE_NOOP("Actions", "Move the take do&wn"),
        QT_TRANSLATE_NOOP("Actions", "Replay the take that is selected in the project tree or on the timeline after "
                                     "the take below it. The workpiece at the end and the paths stay as they are."),
        "Ctrl+Shift+Down"},
    Row{ActionId::duplicateTake, "duplicateTakeAction", QT_TRANSLATE_NOOP("Actions", "Dupl&icate the take"),
        QT_TRANSLATE_NOOP("Actions", "Copy the selected take with its strokes and what is switched off. No path mills "
                                     "the copy until its menu adds it."),
        "Ctrl+Shift+C"},
    Row{ActionId::overrideCheck, "overrideAction", QT_TRANSLATE_NOOP("Actions", "&Override the check…"),
        QT_TRANSLATE_NOOP("Actions", "Export a program that failed its check; you must state a reason."),
        "Ctrl+Shift+E"},
    Row{ActionId::restart, "restartAction", QT_TRANSLATE_NOOP("Actions", "&Restart at the selected line…"),
        QT_TRANSLATE_NOOP("Actions", "Export the rest of the program from the selected line, with a safe re-entry into "
                                     "the cut, for example after tool breakage."),
        "F8"},
    Row{ActionId::inspectFaces, "facesAction", QT_TRANSLATE_NOOP("Actions", "F&aces of the part…"),
        QT_TRANSLATE_NOOP("Actions", "List the faces of the part with the gouges and the stock that the program leaves "
                                     "on each; a click shows the worst point."),
        "Ctrl+Shift+J"},
    Row{ActionId::materials, "materialsAction", QT_TRANSLATE_NOOP("Actions", "Mate&rials…"),
        QT_TRANSLATE_NOOP("Actions", "Look at, copy, change, add and calibrate materials."), "Ctrl+Shift+T"},
    Row{ActionId::tools, "toolsAction", QT_TRANSLATE_NOOP("Actions", "&Tools…"),
        QT_TRANSLATE_NOOP("Actions", "Look at the tools; copy, change, add and delete your own."), "Ctrl+Shift+K"},
    Row{ActionId::machines, "machinesAction", QT_TRANSLATE_NOOP("Actions", "&Machines…"),
        QT_TRANSLATE_NOOP("Actions", "Look at the machines; copy, change and delete your own."), "Ctrl+Shift+M"},
    Row{ActionId::devices, "devicesAction", QT_TRANSLATE_NOOP("Actions", "De&vices…"),
        QT_TRANSLATE_NOOP("Actions", "List the styluses that were found, and test them before milling."),
        "Ctrl+Shift+Y"},
    Row{ActionId::help, "helpAction", QT_TRANSLATE_NOOP("Actions", "&Help"),
        QT_TRANSLATE_NOOP("Actions", "Show the help on the current step."), "F1"},
    Row{ActionId::welcome, "welcomeAction", QT_TRANSLATE_NOOP("Actions", "&Welcome page"),
        QT_TRANSLATE_NOOP("Actions", "Show how to begin."), "Ctrl+Shift+F1"},
    Row{ActionId::firstJob, "firstJobAction", QT_TRANSLATE_NOOP("Actions", "&First job"),
        QT_TRANSLATE_NOOP("Actions", "Start a guide through a complete job on the sample part, step by step."),
        "Ctrl+Alt+J"},
    Row{ActionId::keyList, "keyListAction", QT_TRANSLATE_NOOP("Actions", "&Keys and mouse"),
        QT_TRANSLATE_NOOP("Actions", "All keyboard shortcuts and mouse actions."), "Ctrl+F1"},
    Row{ActionId::about, "aboutAction", QT_TRANSLATE_NOOP("Actions", "&About Burin"),
        QT_TRANSLATE_NOOP("Actions", "Version, licence and sources."), "Shift+F1"},
};
static_assert(rows.size() == static_cast<std::size_t>(ActionId::count));

/// Checkable actions that are on by default.
constexpr ActionId onAtFirst[] = {ActionId::showWorkpiece, ActionId::showTool,        ActionId::showPath,
                                  ActionId::showGuides,    ActionId::showOtherPaths,  ActionId::guides,
                                  ActionId::showTimeline,  ActionId::placementHandles};

} // namespace

QKeySequence Actions::firstShortcut(ActionId id) {
    const auto row = std::ranges::find(rows, id, &Row::id);
    return row != rows.end() ? QKeySequence(QString::fromLatin1(row->shortcut)) : QKeySequence();
}

Actions::Actions(QObject* parent) : QObject(parent) {
    for (const Row& row : rows) {
        auto* action = new QAction(QCoreApplication::translate(context, row.text), this);
        action->setObjectName(QString::fromLatin1(row.name));
        const QString tip = QCoreApplication::translate(context, row.toolTip);
        action->setToolTip(tip);
        action->setStatusTip(tip);
        action->setShortcut(firstShortcut(row.id));
        action->setCheckable(row.checkable);
        if (row.checkable) action->setChecked(std::ranges::find(onAtFirst, row.id) != std::end(onAtFirst));
        actions_[static_cast<std::size_t>(row.id)] = action;
    }
    (*this)[ActionId::quit]->setMenuRole(QAction::QuitRole);
    (*this)[ActionId::preferences]->setMenuRole(QAction::PreferencesRole);
    (*this)[ActionId::about]->setMenuRole(QAction::AboutRole);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/ui/window_driver.h"

namespace burin::testing {

// Steps of the job that several tests perform by mouse and keyboard.

/// Enters a file name in the next file dialog and accepts it.
void chooseFile(WindowDriver& driver, const QString& file);
/// Clicks a button of a dialog. Returns false if there is none of that name.
bool answer(QWidget& dialog, const char* button);
/// The action of one of the menus with that object name; null if there is none.
QAction* menuAction(WindowDriver& driver, const QString& name);
/// All actions of the menus.
std::vector<QAction*> menuActions(WindowDriver& driver);
/// Saves the project under a name by key and dialog; true once nothing is left to save.
bool saveAs(WindowDriver& driver, const QString& file);
/// Drops a file on the window.
void drop(MainWindow& window, const QString& file);
/// A block of 40 x 30 x 20 mm as an STL file, which is read in a moment. @param closed  false: without its top
QString writeBlock(const WindowDriver& driver, bool closed = true);
/// Drops the block on the window and embeds it, ready to be milled. Coarse voxels suffice where a test is about the
/// behaviour of the window, not about how finely it mills. @param voxel  mm
bool makeReady(WindowDriver& driver, double voxel = 0.5);
/// How fast a line is drawn: as fast as the window follows, or as a hand does it, for what depends on its samples.
enum class LinePace : std::uint8_t { quick, ofAHand };
/// Draws a line on the stock's top with the left button down. Positions in mm from the middle of the stock's top.
void millLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to, LinePace pace = LinePace::quick);
/// Records a take of one such line; enters and leaves mill mode.
bool recordLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to, LinePace pace = LinePace::quick);
/// Makes a path of the recording and waits until it is evaluated.
bool newPath(WindowDriver& driver);
/// Posts the program and waits for its check. Returns false if that produced no new program.
bool postProgram(WindowDriver& driver);
/// The volume removed from the workpiece, mm³.
double removedSoFar(const MillingContext& milling);

} // namespace burin::testing

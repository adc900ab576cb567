// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/ui/window_driver.h"

namespace burin::testing {

// Steps of the job that several tests do by mouse and keyboard.

/// Gives the file dialog that comes a name, and takes it.
void chooseFile(WindowDriver& driver, const QString& file);
/// Clicks a button of a dialog. False: there is none of that name.
bool answer(QWidget& dialog, const char* button);
/// An action of one of the menus, by its object's name; null where there is none.
QAction* menuAction(WindowDriver& driver, const QString& name);
/// All that the menus offer.
std::vector<QAction*> menuActions(WindowDriver& driver);
/// Saves the project under a name by key and dialogue; true once nothing is left to save.
bool saveAs(WindowDriver& driver, const QString& file);
/// Lets a file fall on the window.
void drop(MainWindow& window, const QString& file);
/// A block of 40 x 30 x 20 mm as an STL file: read in a moment. @param closed false: without its top
QString writeBlock(const WindowDriver& driver, bool closed = true);
/// Drops the block on the window and embeds it; ready to be milled. Coarse voxels do where a test asks how the window
/// behaves, not how finely it mills. @param voxel  mm
bool makeReady(WindowDriver& driver, double voxel = 0.5);
/// Draws a line on the stock's top with the left button down. Places in mm from the middle of the stock's top.
void millLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to);
/// Records a take of one such line, in mill mode and out of it again.
bool recordLine(WindowDriver& driver, const glm::dvec2& from, const glm::dvec2& to);
/// Makes a path of what is recorded, and waits until it is evaluated.
bool newPath(WindowDriver& driver);
/// Posts the program and waits for its check. False: nothing new came of it.
bool postProgram(WindowDriver& driver);
/// mm³ that the workpiece has lost.
double removedSoFar(const MillingContext& milling);

} // namespace burin::testing

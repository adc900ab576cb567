// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin {

/// Whether these arguments request the window: none at all, or one file that is neither a command nor an option.
/// @param isCommand whether a word is a command's name
bool asksForWindow(int argc, char** argv, bool (*isCommand)(const std::string& word));

/// Opens the window and returns when it is closed. Without a display: one sentence on standard error.
/// @return exit status
int runWorkstation(int argc, char** argv);

} // namespace burin

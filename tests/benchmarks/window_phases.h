// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/stall_watch.h"
#include "tests/benchmarks/window_report.h"
#include "tests/ui/window_driver.h"

namespace burin::testing {

// What a user does before and after milling. Each step is a phase whose longest stall is reported. The functions return
// false if a step failed.

bool importSample(WindowDriver& driver, StallWatch& watch, Report& report);
bool embedSample(WindowDriver& driver, StallWatch& watch, Report& report);
/// Undoes strokes, goes through the recorded time, looks at the tree and at sections, makes the path, changes and
/// compares it, posts it, looks at faces, writes the setup sheet, changes preferences, saves.
bool workOn(WindowDriver& driver, StallWatch& watch, Report& report);
/// Opens the saved project in a new window.
bool openAgain(WindowDriver& driver, StallWatch& watch, Report& report);

} // namespace burin::testing

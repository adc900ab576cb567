// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/window_report.h"
#include "tests/ui/window_driver.h"

#include <QString>

namespace burin::testing {

/// Records an hour into the project of the window, has its workpiece made and kept once, and measures how long a new
/// process takes to show it. Returns false if a step failed.
bool measureOpening(WindowDriver& driver, Report& report);
/// What that process does: opens the project as the program does, and writes the times to standard output as JSON.
/// @param begun when it was started, on the monotonic clock, ns. Returns its exit status.
int openAndMeasure(const QString& file, qint64 begun);

} // namespace burin::testing

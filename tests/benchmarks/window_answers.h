// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/window_report.h"
#include "tests/ui/window_driver.h"

namespace burin::testing {

/// How long a user waits for the window's answers: until the welcome page is there, and, with a take of 400,000 samples
/// added to the embedded project, for a changed edit and for a check after it. Saves the project and opens a new
/// window. Returns false if a step failed.
bool measureAnswers(WindowDriver& driver, Report& report);

} // namespace burin::testing

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/project/restart_job.h"
#include "ui/theme/length_unit.h"

class QWidget;

namespace burin {

/// Shows what the rest of an interrupted program will do before it is written: the first cut, where the tool comes back
/// to the path, the tool to measure, and what the check says of it; with the text itself. Dialog "restartDialog" with
/// "restartFacts", "restartFindings", "restartText", "exportRestartButton" (only for what may be written) and
/// "cancelButton". @return the user wants it written
bool askRestart(QWidget* parent, const RestartedProgram& rest, LengthUnit unit);

} // namespace burin

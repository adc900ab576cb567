// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/restart_job.h"
#include "ui/theme/length_unit.h"

#include <QString>

class QWidget;

namespace burin {

/// What is to become of the rest of an interrupted program.
struct RestartAnswer {
    bool write = false;
    QString overrideReason; ///< why, though its check refused it; empty where it passed
};

/// Shows what the rest of an interrupted program will do before it is written: the first cut, where the tool comes back
/// to the path, the tool to measure, and what the check says of it; with the text itself. Dialog "restartDialog" with
/// "restartFacts", "restartFindings", "restartText", "exportRestartButton" (only for what may be written),
/// "overrideRestartButton" (only for what was refused; it asks for a reason, as askOverride) and "cancelButton".
RestartAnswer askRestart(QWidget* parent, const RestartedProgram& rest, LengthUnit unit);

} // namespace burin

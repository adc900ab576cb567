// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/restart_job.h"
#include "ui/theme/length_unit.h"

#include <QString>

class QWidget;

namespace burin {

/// The user's decision about the rest of an interrupted program.
struct RestartAnswer {
    bool write = false;
    QString overrideReason; ///< why it is written although its check refused it; empty if it passed
};

/// Shows what the rest of an interrupted program will do before it is written: the first cut, where the tool returns to
/// the path, the tool to measure, and the result of the check; together with the text. Dialog "restartDialog" with
/// "restartFacts", "restartFindings", "restartText", "exportRestartButton" (only if it may be written),
/// "overrideRestartButton" (only if it was refused; it asks for a reason, as askOverride) and "cancelButton".
RestartAnswer askRestart(QWidget* parent, const RestartedProgram& rest, LengthUnit unit);

} // namespace burin

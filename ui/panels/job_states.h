// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

/// States of the panels for the steps of the job. Panels own no model: they are given one of these states and report
/// the user's requests by signals.
namespace burin {

/// The steps of the job, in order.
enum class JobStep { part, stock, material, tool, allowance, mill, path, program };

enum class StepProgress {
    missing, ///< cannot be done yet
    ready,
    current,
    objected, ///< done, but a check reports a problem
    done
};

struct JobStepState {
    StepProgress progress = StepProgress::missing;
    QString line; ///< a summary of the step, or what is missing
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

/// What the panels of the steps of the job show. Panels own no model: they get one of these and tell by signals what
/// the user wants.
namespace burin {

/// The steps of the job, in order.
enum class JobStep { part, stock, material, tool, allowance, mill, path, program };

enum class StepProgress {
    missing, ///< cannot be done yet
    ready,
    current,
    objected, ///< done, but a check objects to it
    done
};

struct JobStepState {
    StepProgress progress = StepProgress::missing;
    QString line; ///< what it holds, or what is missing
};

} // namespace burin

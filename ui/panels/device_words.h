// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_trial.h"

#include <QStringList>

namespace burin {

/// The limits that a device states, one a line.
QStringList limitLines(const StylusDescription& stylus);
/// Measurements of a trial, one a line.
QStringList trialLines(const TrialFigures& figures);

} // namespace burin

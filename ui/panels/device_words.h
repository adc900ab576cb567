// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_trial.h"

#include <QStringList>

namespace burin {

/// What a device says of itself, a line a limit.
QStringList limitLines(const StylusDescription& stylus);
/// How it did in a trial, a line each.
QStringList trialLines(const TrialFigures& figures);

} // namespace burin

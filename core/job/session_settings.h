// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/job/session_loop.h"
#include "core/job/session_request.h"

namespace burin {

// What a session's request means to its parts, and what its loop tells means to who watches. Owner's thread.

/// Of the step: `settings.tickPeriod` is that of the loop.
HapticSettings hapticSettings(const MillingContext& milling, const AxisMode& axis, const StylusHandle& stylus,
                              const SessionRequest& request);
/// Of the loop: a stylus that paces itself gives the period.
ServoSettings servoSettings(const StylusHandle& stylus, const SessionRequest& request);
/// Folder for records of faults; empty where time is simulated: there is no hand.
std::filesystem::path flightFolder(const Project& project, const SessionRequest& request);

/// @param unitVolume mm³ that a run unit of the workpiece stands for
SessionState sessionState(const TickNews& news, const LiveFigures& figures, std::size_t layerCount, double unitVolume);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/job/session_loop.h"
#include "core/job/session_request.h"

namespace burin {

// Converts a session's request to the settings of its parts, and the reports of its loop to the state that is shown.
// Call on the owner's thread.

/// Returns the settings of the step: `settings.tickPeriod` is that of the loop.
HapticSettings hapticSettings(const MillingContext& milling, const AxisMode& axis, const StylusHandle& stylus,
                              const SessionRequest& request);
/// Returns the settings of the loop: a stylus that paces itself defines the period.
ServoSettings servoSettings(const StylusHandle& stylus, const SessionRequest& request);
/// Returns the folder for records of faults; empty if time is simulated, as there is no hand.
std::filesystem::path flightFolder(const Project& project, const SessionRequest& request);

/// Returns what is shown of one layer.
LayerNews layerNews(const LayersNews& news, std::size_t layer);
/// @param unitVolume volume of a run unit of the workpiece, mm³
SessionState sessionState(const TickNews& news, const LiveFigures& figures, std::size_t layerCount, double unitVolume);

} // namespace burin

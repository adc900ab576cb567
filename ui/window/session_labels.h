// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_session.h"

#include <QString>

namespace burin {

// The meaning of the flags of a tick in words. Empty if there is nothing to report.

/// What prevents the tool from cutting: "The shank touches Machinable wax."
QString alarmSentence(const SessionState& state, const MillingContext& milling);
/// Explains what the user may notice: a fixture that holds the tool, and, with a device, no readings, an axis that does
/// not follow, no force, the full force of the device.
/// @param bounds of the session @param stylus of the device; null: the mouse @param forceButton the dead man's button,
/// from 1; 0: none
QString hintSentence(const SessionState& state, const ToolBounds& bounds, const StylusDescription* stylus,
                     int forceButton);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_session.h"

#include <QString>

namespace burin {

// What the flags of a tick mean to the user. An empty sentence: there is nothing to be said.

/// What keeps the tool from cutting: "The shank touches Machinable wax."
QString alarmSentence(const SessionState& state, const MillingContext& milling);
/// What a hand wonders about: a fixture that holds the tool, and, with a device, no readings, an axis that does not
/// follow, no force, all of it.
/// @param bounds of the session. @param stylus of the device; null: the mouse. @param forceButton the dead man's, from
/// 1; 0: there is none
QString hintSentence(const SessionState& state, const ToolBounds& bounds, const StylusDescription* stylus,
                     int forceButton);

} // namespace burin

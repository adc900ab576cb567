// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/stylus.h"
#include "core/haptics/haptic_settings.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// What a session began with that its stylus and its owner decided, not its project: without it a trace plays another
/// one.
struct TracedSession {
    StylusDescription stylus;
    WorkspaceMapping mapping;
    double allowance = 0.0;         ///< mm
    double period = 0.001;          ///< s of a tick
    bool cutsOnButton = false;      ///< as in HapticSettings
    std::uint32_t forceButtons = 0; ///< as in HapticSettings
    FeltCutting felt;
    AxisMode axis; ///< decided by what bounds the tool
    /// The part's boundary grew while it was milled (GrowingBoundary), as the changes tell.
    struct Growth {
        double maximumAllowance = 0.0; ///< mm, that it was made for
        bool whole = false;            ///< all of it was there from the start
    };
    std::optional<Growth> growth{}; ///< none: it was all there
};

/// A JSON object of one line, without its end. Numbers come back to the bit.
std::string formatTracedSession(const TracedSession& session);
/// Whether a line is one that formatTracedSession wrote, as far as its beginning tells.
bool tellsTracedSession(std::string_view text);
/// Errors: resourceInvalid (place: the key), argumentInvalid (a description that breaks a rule).
Result<TracedSession> readTracedSession(std::string_view text, const std::string& origin);

} // namespace burin

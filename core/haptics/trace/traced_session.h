// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/stylus.h"
#include "core/haptics/haptic_settings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The part of a session's initial state that was determined by its stylus and its owner, not by its project. Without
/// it a replay of the trace would give a different session.
struct TracedSession {
    StylusDescription stylus;
    WorkspaceMapping mapping;
    double allowance = 0.0;         ///< mm
    double period = 0.001;          ///< s of a tick
    bool cutsOnButton = false;      ///< as in HapticSettings
    std::uint32_t forceButtons = 0; ///< as in HapticSettings
    FeltCutting felt;
    AxisMode axis; ///< determined by the boundary of the tool
    /// Set if the part's boundary grew while it was milled (GrowingBoundary); the recorded changes contain the tiles.
    struct Growth {
        double maximumAllowance = 0.0; ///< mm, allowance that it was made for
        bool whole = false;            ///< whether it was complete from the start
    };
    std::optional<Growth> growth{}; ///< empty: the boundary was complete from the start
    StockLayer stock{};             ///< the recorded changes contain when it was switched
    GainLimits gains{};             ///< as in HapticSettings
    std::string tool{};             ///< id; empty: not stated
    /// The layers that bounded the tool; the recorded changes contain when they were switched. Empty: not stated.
    struct Layer {
        std::string kind, name; ///< name: of a fixture or keep-out volume
        bool on = true;         ///< initially
        friend bool operator==(const Layer&, const Layer&) = default;
    };
    std::vector<Layer> layers{};
};

/// Returns a JSON object in one line, without a line end. Numbers are read back exactly, to the bit.
std::string formatTracedSession(const TracedSession& session);
/// Whether a line was written by formatTracedSession, judged by its beginning.
bool tellsTracedSession(std::string_view text);
/// Errors: resourceInvalid (place: the key), argumentInvalid (a description that breaks a rule).
Result<TracedSession> readTracedSession(std::string_view text, const std::string& origin);

} // namespace burin

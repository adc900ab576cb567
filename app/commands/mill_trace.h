// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/commands/mill_session.h"

namespace burin {

/// Reports the share of the cutting force that was felt, and the source of this value.
void tellFelt(const FeltCutting& felt, const char* source, nlohmann::json& answer);
/// Reports the distance that shank and holder keep from the stock, mm; null: none.
void tellStockDistance(const StockLayer& stock, nlohmann::json& answer);
/// Reports the limits of the gains, if there are any.
void tellGains(const GainLimits& gains, nlohmann::json& answer);

/// Configures a request like the session that recorded a trace, except that the allowance may be given anew.
/// Errors: argumentInvalid (its tool had another axis, or an argument contradicts what the trace states).
Result<void> playAgain(const SessionTrace& trace, const MillWork& work, TakeRequest& request);

} // namespace burin

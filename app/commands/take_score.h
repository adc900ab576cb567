// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

namespace burin {

/// Declares `take score`: the score of a take, and its comparison with that of a reference.
void addTakeScore(CommandParser take, CommandContext& context, int& status);

} // namespace burin

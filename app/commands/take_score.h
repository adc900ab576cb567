// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

namespace burin {

/// Declares `take score`: the values of a take, and how they compare with those of a reference.
void addTakeScore(CommandParser take, CommandContext& context, int& status);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

namespace burin {

/// Declares `burin take deviation`. @param take the command `take`
void addTakeDeviation(CommandParser take, CommandContext& context, int& status);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/promised_path.h"

#include <vector>

namespace burin {

/// Groups findings by cause: one of each kind for each cause, at its line, with the worst amount and the number of
/// lines that it stands for. See README.md, "Causes".
/// @param findings in program order
std::vector<Finding> byCause(std::vector<Finding> findings, const ParsedProgram& program,
                             const PathComparison& comparison);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"

namespace burin {

/// What the program sets, or leaves out, before it moves: tools that were never loaded, length offsets, the work offset
/// and the spindle's direction. Each once, at the line that sets it; what is missing, at the first move that lacks it.
/// Length offsets are those of tools by their T numbers, as LinuxCNC keeps them and shops with other controls do; a
/// control without G43 H has none. Every tool is taken to be right-handed.
void judgeSettings(const VerifyRequest& request, Findings& findings);

} // namespace burin

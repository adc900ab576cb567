// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"

namespace burin {

/// Judges what the program sets, or omits, before it moves: tools that were never loaded, length offsets, the work
/// offset and the direction of the spindle. Each is reported once, at the line that sets it; a missing setting at the
/// first move that needs it. Length offsets belong to tools by their T numbers, as in LinuxCNC and by custom in shops
/// with other controls; a control without G43 H has none. Every tool is assumed to be right-handed.
void judgeSettings(const VerifyRequest& request, Findings& findings);

} // namespace burin

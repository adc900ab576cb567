// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

namespace burin {

/// Where a machine lets a tool go, setup frame. An empty box sets no limit.
struct Envelope {
    Box tips;  ///< mm: the tip stays inside (the axes' travel)
    Box tools; ///< mm: every point of cutter, shank and holder stays inside (doors, walls, table)
};

} // namespace burin

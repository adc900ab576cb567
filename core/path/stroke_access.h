// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/part_guard.h"
#include "core/path/stroke.h"

#include <cstddef>

namespace burin {

/// The points of a stroke that the tool can reach from above, and leave upwards. On a part without undercuts these are
/// its ends; under an overhang the tool goes back along the stroke until the way up is free.
struct StrokeAccess {
    std::size_t entry = 0, exit = 0;
    bool found = false;
};

/// @param height mm, of a tip above everything. Thread-safe.
StrokeAccess accessOf(const PathStroke& stroke, const PartGuard& guard, double height);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin {

/// The scanlines first … last, counted along an axis perpendicular to them; empty if last < first.
struct LineInterval {
    std::int32_t first = 0, last = -1;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace burin {

/// An axis (0 X, 1 Y, 2 Z) as a position in a std::array, which GLM's own index is not.
constexpr std::size_t axisIndex(int axis) noexcept {
    return static_cast<std::size_t>(axis);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/program_lines.h"

#include <algorithm>

namespace burin {

std::span<const NcMotion> motionsOf(std::span<const NcMotion> motions, std::uint32_t line) {
    const auto found = std::ranges::equal_range(motions, line, {}, &NcMotion::line);
    return {found.begin(), found.end()};
}

const NcMotion* lastMotion(std::span<const NcMotion> motions, std::uint32_t line) {
    const auto behind = std::ranges::upper_bound(motions, line, {}, &NcMotion::line);
    return behind == motions.begin() ? nullptr : &*std::prev(behind);
}

} // namespace burin

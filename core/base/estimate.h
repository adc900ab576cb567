// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin {

/// Whether the source of a value calls it an estimate: what is judged by such a value is warned of, not refused.
inline bool isEstimate(std::string_view source) noexcept {
    return source.find("estimate") != std::string_view::npos || source.find("Estimate") != std::string_view::npos;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin {

/// Whether the source of a value calls it an estimate: checks against such a value warn instead of refusing.
inline bool isEstimate(std::string_view source) noexcept {
    return source.find("estimate") != std::string_view::npos || source.find("Estimate") != std::string_view::npos;
}

} // namespace burin

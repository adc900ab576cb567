// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin {

/// What a PLY file lacks of what its head states ("12 of 2000 faces"): a head that ends, lines or bytes of all
/// elements. Empty: it is complete. (assimp reads beyond the end of a binary one that is cut off.)
std::string missingOfPly(std::string_view content);

} // namespace burin

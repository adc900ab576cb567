// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin {

/// Returns what a PLY file lacks of what its header states ("12 of 2000 faces"): the end of the header, or lines or
/// bytes of elements. Empty if the file is complete. (assimp reads beyond the end of a truncated binary file.)
std::string missingOfPly(std::string_view content);

} // namespace burin

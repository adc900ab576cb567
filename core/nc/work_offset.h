// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// The name of a work offset with a number as in NcMotion::workOffset: "G54" … "G59", "G59.1" … "G59.3", or "P3" for
/// the third of the additional ones that some controls have.
std::string workOffsetName(int number);
/// The number of a work offset with such a name, in upper or lower case; empty for other names. Additional ones: P1 to
/// P300.
std::optional<int> workOffsetFromName(std::string_view name);

} // namespace burin

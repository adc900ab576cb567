// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Of a number as NcMotion::workOffset has it: "G54" … "G59", "G59.1" … "G59.3", or "P3" for the third of the further
/// ones that some controls have.
std::string workOffsetName(int number);
/// Of such a name, in capitals or not; nothing for others. Further ones: P1 to P300.
std::optional<int> workOffsetFromName(std::string_view name);

} // namespace burin

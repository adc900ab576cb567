// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace burin {

/// CRC-64/XZ (polynomial of ECMA-182, reflected): detects every change within up to 64 consecutive bits. The check
/// value of "123456789" is 0x995dc9bbdf1939fa.
std::uint64_t checksum(std::string_view bytes) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A setup as JSON text, its keys with their units; every number reads back bit for bit.
/// Errors: argumentInvalid with the key of a number that is not finite (an empty stock box is allowed).
Result<std::string> toJson(const Setup& setup);

/// Nothing when `text` is not what `toJson` writes.
std::optional<Setup> setupFromJson(std::string_view text);

} // namespace burin

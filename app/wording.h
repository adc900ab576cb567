// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace burin {

/// A text in the user's language, with %1, %2 … replaced by the values. UTF-8. English as long as no translations are
/// installed. Thread-safe.
std::string worded(TextId text, std::initializer_list<std::string> values = {});

/// `one` if `count` is 1, otherwise `many`; %1 is the count, %2 the first value.
std::string worded(std::size_t count, TextId one, TextId many, std::initializer_list<std::string> values = {});

/// The name of a tool, machine or material: translated if it is shipped with Burin, otherwise unchanged.
std::string resourceName(const std::string& name);
/// Returns names in one line, separated by commas.
std::string listed(const std::vector<std::string>& names);

/// The error for an option with an invalid text. @param allowed what is allowed
Error wrongArgument(const char* option, const std::string& text, TextId allowed);

} // namespace burin

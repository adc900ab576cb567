// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Comma-separated numbers; empty if the text is anything but `count` of them.
std::optional<std::vector<double>> numbersOf(const std::string& text, std::size_t count);
/// "X,Y,Z"
std::optional<glm::dvec3> vectorOf(const std::string& text);

/// The index, from 0, of a number that the user counts from 1; empty if the text is anything but 1 … `count`.
std::optional<std::size_t> indexOfNumber(const std::string& text, std::size_t count);

/// The parts between separators, including empty ones: one more than there are separators.
std::vector<std::string> partsOf(const std::string& text, char separator);

} // namespace burin

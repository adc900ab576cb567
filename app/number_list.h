// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Numbers with commas between them; nothing where it is not just so many.
std::optional<std::vector<double>> numbersOf(const std::string& text, std::size_t count);
/// "X,Y,Z"
std::optional<glm::dvec3> vectorOf(const std::string& text);

/// What stands between separators, empty parts included: one more than there are separators.
std::vector<std::string> partsOf(const std::string& text, char separator);

} // namespace burin

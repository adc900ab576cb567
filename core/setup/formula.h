// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace burin {

/// A number as a function of position, as written by a user: "0.4 + 0.02 * Z". muParser's grammar, with the variables
/// X, Y and Z (or x, y, z), mm, setup frame. Copies share the parsed formula.
class Formula {
public:
    static constexpr std::size_t longest = 1000; ///< characters

    /// Errors: argumentInvalid (place: the text; detail: what a formula may consist of, and the position of the error).
    static Result<Formula> parse(const std::string& text);

    /// Returns the value at a point. Not finite where the formula has no value: a division by zero, a root of a
    /// negative number. Thread-safe.
    double at(const glm::dvec3& place) const;

private:
    class Parsed;
    explicit Formula(std::shared_ptr<const Parsed> parsed) noexcept : parsed_(std::move(parsed)) {}
    std::shared_ptr<const Parsed> parsed_; ///< never null
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>

namespace burin {

/// A number as a function of a place, as a user writes it: "0.4 + 0.02 * Z". muParser's grammar, with the variables X,
/// Y and Z (or x, y, z), mm, setup frame. Copies share what was parsed.
class Formula {
public:
    static constexpr std::size_t longest = 1000; ///< characters

    /// Errors: argumentInvalid (place: the text; detail: what it may be made of, and where it is wrong).
    static Result<Formula> parse(const std::string& text);

    /// Not finite where the formula has no value: a division by zero, a root of what is negative. Any thread.
    double at(const glm::dvec3& place) const;

private:
    class Parsed;
    explicit Formula(std::shared_ptr<const Parsed> parsed) noexcept : parsed_(std::move(parsed)) {}
    std::shared_ptr<const Parsed> parsed_; ///< never null
};

} // namespace burin

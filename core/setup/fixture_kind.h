// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "core/base/result.h"
#include "core/base/text.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The kinds of the library of fixtures.
enum class FixtureKind : std::uint8_t { vise, stepClamp, toeClamp, hexScrew, socketScrew, parallels, plate };

/// A length of a fixture, mm.
struct FixtureParameter {
    const char* key; ///< stable id, for files and the command line
    TextId label, toolTip;
    double standard; ///< default
    NumberRange range;
    const char* source;        ///< of the default: a standard and its size, or "estimate" (context "Fixture")
    bool followsStock = false; ///< whether placing the fixture sets it from the stock, unless it was given
};

struct FixtureKindRow {
    FixtureKind kind;
    const char* id; ///< stable, for files and the command line
    TextId title, toolTip;
    std::span<const FixtureParameter> parameters;
};

const FixtureKindRow& rowOf(FixtureKind kind) noexcept;
std::optional<FixtureKind> fixtureKindFromId(std::string_view id) noexcept;

/// What a fixture of the library is made of. Its own frame has +Z up; `place` is its origin in the setup frame, `turn`
/// the rotation of its X axis about Z. The origins:
/// - vise: the middle of the opening at the height of the stock's bottom; X points to the fixed jaw
/// - step clamp: where it presses on the stock's top; X points away from the stock, to stud and step block
/// - toe clamp: where its nose presses on the stock's side, at the height of the table; X points away from the stock
/// - screws: the middle of the washer's lower face
/// - parallels: the middle between them, at the height of the stock's bottom; X along them
/// - plate: the middle of its upper face
struct FixtureDesign {
    FixtureKind kind = FixtureKind::vise;
    std::vector<double> values; ///< mm, in the order of the kind's parameters
    glm::dvec3 place{0.0};      ///< mm, setup frame
    double turn = 0.0;          ///< rad

    friend bool operator==(const FixtureDesign&, const FixtureDesign&) = default;
};

/// With the default of each parameter, at the origin.
FixtureDesign standardFixture(FixtureKind kind);

/// Returns the index of a parameter; empty if the kind has none of this key.
std::optional<std::size_t> indexOf(FixtureKind kind, std::string_view key) noexcept;
/// @param key one of the kind's
double valueOf(const FixtureDesign& design, std::string_view key) noexcept;
void setValue(FixtureDesign& design, std::string_view key, double value) noexcept;

inline constexpr double leastClearance = 0.1; ///< mm: between solids of a fixture side by side
inline constexpr int blockSteps = 3;          ///< of a step block; the bar rests on the first

/// Errors: argumentInvalid (subject: key of the parameter, "place" or "turn"; place: the value; detail: what is
/// allowed).
Result<void> checkFixture(const FixtureDesign& design);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// A binary operator of NIST RS274/NGC and LinuxCNC, or the bracket that closes an expression.
enum class ExpressionOperator : std::uint8_t {
    close,
    logicalAnd,
    logicalOr,
    logicalXor,
    equal,
    notEqual,
    greater,
    greaterOrEqual,
    less,
    lessOrEqual,
    plus,
    minus,
    times,
    divide,
    modulo,
    power
};

/// How tightly it binds: more before less; 0: close.
int precedenceOf(ExpressionOperator by) noexcept;

/// The operator that a text begins with, in either case, and how many characters it has; nothing: none.
struct SpelledOperator {
    ExpressionOperator by = ExpressionOperator::close;
    std::size_t length = 0;
};
std::optional<SpelledOperator> operatorAt(std::string_view text) noexcept;

/// Nothing for a division or remainder by 0. Truth is 1, falsehood 0; a remainder is never below 0.
std::optional<double> combined(ExpressionOperator by, double left, double right) noexcept;

} // namespace burin

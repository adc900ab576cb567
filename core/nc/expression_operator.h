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

/// The precedence of an operator: higher binds more tightly; 0 for close.
int precedenceOf(ExpressionOperator by) noexcept;

/// The operator that a text begins with, in upper or lower case, and its number of characters; empty if there is none.
struct SpelledOperator {
    ExpressionOperator by = ExpressionOperator::close;
    std::size_t length = 0;
};
std::optional<SpelledOperator> operatorAt(std::string_view text) noexcept;

/// The result of an operation; empty for a division or remainder by 0. True is 1, false is 0; a remainder is never
/// below 0.
std::optional<double> combined(ExpressionOperator by, double left, double right) noexcept;

} // namespace burin

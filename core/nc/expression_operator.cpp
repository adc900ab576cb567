// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/expression_operator.h"

#include "core/nc/letter.h"

#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr double equalTolerance = 1e-6; // as LinuxCNC's for EQ and NE

struct Spelling {
    std::string_view text;
    ExpressionOperator means;
};
// ** precedes *, which is its first character.
constexpr std::array<Spelling, 16> spellings{{{"]", ExpressionOperator::close},
                                              {"**", ExpressionOperator::power},
                                              {"*", ExpressionOperator::times},
                                              {"/", ExpressionOperator::divide},
                                              {"+", ExpressionOperator::plus},
                                              {"-", ExpressionOperator::minus},
                                              {"MOD", ExpressionOperator::modulo},
                                              {"AND", ExpressionOperator::logicalAnd},
                                              {"OR", ExpressionOperator::logicalOr},
                                              {"XOR", ExpressionOperator::logicalXor},
                                              {"EQ", ExpressionOperator::equal},
                                              {"NE", ExpressionOperator::notEqual},
                                              {"GT", ExpressionOperator::greater},
                                              {"GE", ExpressionOperator::greaterOrEqual},
                                              {"LT", ExpressionOperator::less},
                                              {"LE", ExpressionOperator::lessOrEqual}}};

/// By index in the enumeration.
constexpr std::array<int, 16> precedences{0, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 4, 4, 4, 5};

bool beginsWith(std::string_view text, std::string_view word) noexcept {
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (upperLetter(text[i]) != word[i]) return false;
    return true;
}

} // namespace

int precedenceOf(ExpressionOperator by) noexcept {
    return precedences[static_cast<std::size_t>(by)];
}

std::optional<SpelledOperator> operatorAt(std::string_view text) noexcept {
    for (const Spelling& spelling : spellings)
        if (beginsWith(text, spelling.text)) return SpelledOperator{spelling.means, spelling.text.size()};
    return std::nullopt;
}

std::optional<double> combined(ExpressionOperator by, double left, double right) noexcept {
    const auto truth = [](bool value) { return value ? 1.0 : 0.0; };
    const bool equal = std::abs(left - right) < equalTolerance;
    switch (by) {
    case ExpressionOperator::logicalAnd:
        left = truth(left != 0.0 && right != 0.0);
        break;
    case ExpressionOperator::logicalOr:
        left = truth(left != 0.0 || right != 0.0);
        break;
    case ExpressionOperator::logicalXor:
        left = truth((left != 0.0) != (right != 0.0));
        break;
    case ExpressionOperator::equal:
        left = truth(equal);
        break;
    case ExpressionOperator::notEqual:
        left = truth(!equal);
        break;
    case ExpressionOperator::greater:
        left = truth(left > right);
        break;
    case ExpressionOperator::greaterOrEqual:
        left = truth(left >= right);
        break;
    case ExpressionOperator::less:
        left = truth(left < right);
        break;
    case ExpressionOperator::lessOrEqual:
        left = truth(left <= right);
        break;
    case ExpressionOperator::plus:
        left += right;
        break;
    case ExpressionOperator::minus:
        left -= right;
        break;
    case ExpressionOperator::times:
        left *= right;
        break;
    case ExpressionOperator::divide:
        if (right == 0.0) return std::nullopt;
        left /= right;
        break;
    case ExpressionOperator::modulo:
        if (right == 0.0) return std::nullopt;
        left = std::fmod(left, right);
        if (left < 0.0) left += std::abs(right); // never negative, as in the report
        break;
    case ExpressionOperator::power:
        left = std::pow(left, right);
        break;
    case ExpressionOperator::close:
        break;
    }
    return left;
}

} // namespace burin

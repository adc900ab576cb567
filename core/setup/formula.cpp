// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/formula.h"

#include <muParser.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdint>
#include <limits>
#include <locale>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// Belongs to one thread: muParser keeps the variables and the stack of an evaluation in the parser.
class Evaluator {
public:
    explicit Evaluator(const std::string& text) {
        for (const auto& [name, variable] :
             {std::pair("X", &place_.x), std::pair("Y", &place_.y), std::pair("Z", &place_.z),
              std::pair("x", &place_.x), std::pair("y", &place_.y), std::pair("z", &place_.z)})
            parser_.DefineVar(name, variable);
        parser_.SetExpr(text);
    }
    double at(const glm::dvec3& place) {
        place_ = place;
        return parser_.Eval();
    }

private:
    glm::dvec3 place_{0.0};
    mu::Parser parser_;
};

constexpr const char* ingredients = "numbers, X, Y, Z, + - * / ^, brackets and functions such as sqrt and sin";

Error notAFormula(const std::string& text, std::optional<std::size_t> at) {
    return {ErrorCode::argumentInvalid, "formula", text,
            at ? std::string(ingredients) + "; it goes wrong at character " + std::to_string(*at + 1)
               : std::string(ingredients) + ", " + std::to_string(Formula::longest) + " characters at most"};
}

} // namespace

class Formula::Parsed {
public:
    explicit Parsed(std::string text) : text_(std::move(text)) {}

    double at(const glm::dvec3& place) const {
        // Each thread keeps the evaluator of its most recent formula: a volume is graded by one formula after another.
        thread_local std::uint64_t number = 0;
        thread_local std::optional<Evaluator> evaluator;
        if (number != number_ || !evaluator) {
            evaluator.reset();
            evaluator.emplace(text_);
            number = number_;
        }
        try {
            return evaluator->at(place);
        } catch (const mu::Parser::exception_type&) {
            return std::numeric_limits<double>::quiet_NaN(); // a function that rejects its argument
        }
    }

private:
    static std::uint64_t nextNumber() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }
    std::string text_;
    std::uint64_t number_ = nextNumber();
};

Result<Formula> Formula::parse(const std::string& text) {
    const bool blank = std::ranges::all_of(text, [](unsigned char character) { return std::isspace(character) != 0; });
    if (blank || text.size() > longest) return notAFormula(text.substr(0, longest), std::nullopt);
    try {
        Evaluator(text).at(glm::dvec3(0.0));
    } catch (const mu::Parser::exception_type& wrong) {
        // A division by zero at the origin, for example, does not invalidate the formula; at() reports it.
        switch (wrong.GetCode()) {
        case mu::ecDIV_BY_ZERO:
        case mu::ecDOMAIN_ERROR:
            break;
        default:
            return notAFormula(text, std::min(static_cast<std::size_t>(wrong.GetPos()), text.size())); // -1: unknown
        }
    }
    return Formula(std::make_shared<const Parsed>(text));
}

double Formula::at(const glm::dvec3& place) const {
    return parsed_->at(place);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parameters.h"

namespace burin {

std::optional<double> Parameters::value(int number) const {
    if (number >= firstOfControl) return ofControl_(number);
    if (const auto found = numbers_.find(number); found != numbers_.end()) return found->second;
    return unsetIsZero_ ? std::optional<double>(0.0) : std::nullopt;
}

std::optional<double> Parameters::value(std::string_view name) const {
    if (const auto found = names_.find(name); found != names_.end()) return found->second;
    return std::nullopt;
}

void Parameters::commit() {
    for (const auto& [number, value] : numbersLater_) numbers_[number] = value;
    for (auto& [name, value] : namesLater_) names_[std::move(name)] = value;
    discard();
}

void Parameters::discard() {
    numbersLater_.clear();
    namesLater_.clear();
}

} // namespace burin

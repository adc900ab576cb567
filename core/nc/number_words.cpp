// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/number_words.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace burin {
namespace {

/// `steps` units of the last digit as text: 12345 with three decimals is "12.345".
std::string fixedText(long long steps, int decimals) {
    std::string digits = std::to_string(std::llabs(steps));
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, 1, '.');
    return steps < 0 ? "-" + digits : digits;
}

/// Removes trailing zeros after the decimal point; the point itself stays.
void trim(std::string& text) {
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
}

} // namespace

NumberWords::NumberWords(const DialectData& dialect, NcUnits units, int mostDecimals)
    : dialect_(dialect), unit_(units == NcUnits::inch ? millimetresPerInch : 1.0) {
    const DialectNumbers& numbers = dialect.numbers[static_cast<std::size_t>(units)];
    decimals_ = std::clamp(mostDecimals + (units == NcUnits::inch ? 1 : 0), 1, numbers.decimals);
    feedDecimals_ = numbers.feedDecimals;
    step_ = unit_ / std::pow(10.0, decimals_);
}

long long NumberWords::stepsOf(double millimetres) const noexcept {
    return std::llround(millimetres / unit_ * std::pow(10.0, decimals_));
}

long long NumberWords::feedStepsOf(double millimetresPerMinute) const noexcept {
    return std::llround(millimetresPerMinute / unit_ * std::pow(10.0, feedDecimals_));
}

std::string NumberWords::text(long long steps, int decimals, bool keepZeros) const {
    std::string text = fixedText(steps, decimals);
    if (!keepZeros) trim(text);
    if (!dialect_.leadingZero) {
        const std::size_t first = text.front() == '-' ? 1 : 0;
        if (text.size() > first + 2 && text[first] == '0' && text[first + 1] == '.') text.erase(first, 1);
    }
    const bool point = text.find('.') != std::string::npos;
    if (dialect_.forcedPoint && !point) text += '.';
    if (!dialect_.forcedPoint && text.back() == '.') text.pop_back();
    return text;
}

std::string NumberWords::coordinate(long long steps) const {
    return text(steps, decimals_, dialect_.keepZeros);
}

std::string NumberWords::feed(long long steps) const {
    return text(steps, feedDecimals_, false);
}

std::string NumberWords::tolerance(double millimetres) const {
    const int decimals = decimals_ + 1;
    return text(std::llround(millimetres / unit_ * std::pow(10.0, decimals)), decimals, false);
}

std::string NumberWords::plain(double value, int decimals) {
    std::string text = fixedText(std::llround(value * std::pow(10.0, decimals)), decimals);
    trim(text);
    if (text.back() == '.') text.pop_back();
    return text;
}

} // namespace burin

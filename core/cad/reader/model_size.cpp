// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/model_size.h"

#include "core/base/numbers.h"
#include "core/cad/import_notes.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace burin {

namespace {

constexpr double farthest = 1e6;                     // mm
constexpr double smallest = 1.0, largest = 10'000.0; // mm, of usual milled parts

/// Formats a length with four digits.
std::string numberText(double length) {
    std::array<char, 32> text{};
    const std::to_chars_result end =
        std::to_chars(text.data(), text.data() + text.size(), length, std::chars_format::general, 4);
    return std::string(text.data(), end.ptr);
}

std::string lengthText(double millimetres) {
    return numberText(millimetres) + " mm";
}

double largestOf(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

} // namespace

Result<void> judgeSize(Model& model) {
    Box whole;
    for (const Body& body : model.bodies) whole.include(body.box);
    if (whole.empty()) return {};
    const double reach = largestOf(glm::max(glm::abs(whole.low), glm::abs(whole.high)));
    if (!(reach <= farthest)) {
        // The excess is too small to show with four digits.
        const bool alike = numberText(reach) == numberText(farthest);
        const auto text = [&](double length) { return alike ? formatFixed(length, 3) + " mm" : lengthText(length); };
        return Error{ErrorCode::modelTooLarge, {}, text(reach), text(farthest)};
    }
    const double size = largestOf(whole.high - whole.low);
    if (size < smallest || size > largest)
        model.notes.push_back(
            {ImportNote::Kind::warning, import_notes::fill(import_notes::sizeDoubtful, {numberText(size)})});
    return {};
}

} // namespace burin

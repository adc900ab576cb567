// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/colour.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    const auto channel = [](float value) { return linear(static_cast<double>(value)); };
    return 0.2126 * channel(colour.redF()) + 0.7152 * channel(colour.greenF()) + 0.0722 * channel(colour.blueF());
}

} // namespace

double contrast(const QColor& one, const QColor& other) {
    const auto [dark, light] = std::minmax({luminance(one), luminance(other)});
    return (light + 0.05) / (dark + 0.05);
}

QColor mixed(const QColor& ground, const QColor& over, double share) {
    const auto channel = [share](int below, int above) {
        return static_cast<int>(std::lround((1.0 - share) * below + share * above));
    };
    return {channel(ground.red(), over.red()), channel(ground.green(), over.green()),
            channel(ground.blue(), over.blue())};
}

QColor readableOn(const QColor& ground) {
    const QColor dark(16, 20, 24), light(255, 255, 255);
    return contrast(ground, dark) >= contrast(ground, light) ? dark : light;
}

QColor colourFrom(const std::optional<std::array<std::uint8_t, 3>>& rgb) {
    return rgb ? QColor((*rgb)[0], (*rgb)[1], (*rgb)[2]) : QColor();
}

} // namespace burin

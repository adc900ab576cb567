// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_form.h"

#include <span>

namespace burin::packed_form {

namespace {

/// A constant has no fraction.
constexpr int fractionBits = 8;

/// The common bit width of coefficients first … end - 1.
unsigned widthOf(const Prediction& prediction, std::size_t first, std::size_t end) noexcept {
    std::uint32_t any = 0;
    for (std::size_t k = first; k < end; ++k) any |= folded(prediction.coefficients[k]);
    return static_cast<unsigned>(std::bit_width(any));
}

std::uint32_t constantOf(const Prediction& prediction) noexcept {
    return static_cast<std::uint32_t>(prediction.coefficients[0]) >> fractionBits;
}

struct Part {
    std::size_t first, end;
    unsigned widthWidth;
};
constexpr Part parts[] = {{0, 1, placeWidthWidth}, {1, 3, slopeWidthWidth}, {3, 6, slopeWidthWidth}};

std::span<const Part> partsOf(PredictionShape shape) noexcept {
    return std::span(parts).first(static_cast<std::size_t>(shape) + 1);
}

} // namespace

std::uint64_t coefficientBits(const Prediction& prediction) noexcept {
    if (prediction.shape == PredictionShape::constant)
        return placeWidthWidth + static_cast<unsigned>(std::bit_width(constantOf(prediction)));
    std::uint64_t bits = 0;
    for (const Part& part : partsOf(prediction.shape))
        bits += part.widthWidth + widthOf(prediction, part.first, part.end) * (part.end - part.first);
    return bits;
}

void writeCoefficients(const Prediction& prediction, BitWriter& writer) {
    if (prediction.shape == PredictionShape::constant) {
        const auto width = static_cast<unsigned>(std::bit_width(constantOf(prediction)));
        writer.put(width, placeWidthWidth);
        writer.put(constantOf(prediction), width);
        return;
    }
    for (const Part& part : partsOf(prediction.shape)) {
        const unsigned width = widthOf(prediction, part.first, part.end);
        writer.put(width, part.widthWidth);
        for (std::size_t k = part.first; k < part.end; ++k) writer.put(folded(prediction.coefficients[k]), width);
    }
}

void readCoefficients(Prediction& prediction, BitReader& reader) noexcept {
    prediction.coefficients = {};
    if (prediction.shape == PredictionShape::constant) {
        const std::uint32_t value = reader.get(reader.get(placeWidthWidth) & 31);
        prediction.coefficients[0] = static_cast<std::int32_t>(value << fractionBits);
        return;
    }
    for (const Part& part : partsOf(prediction.shape)) {
        const std::uint32_t stated = reader.get(part.widthWidth);
        const unsigned width = stated > 32 ? 32 : stated;
        for (std::size_t k = part.first; k < part.end; ++k) prediction.coefficients[k] = unfolded(reader.get(width));
    }
}

void writePalette(std::span<const PropertyIndex> palette, std::uint32_t properties, BitWriter& writer) {
    if (properties <= shortPalette) {
        std::uint32_t mask = 0;
        for (const PropertyIndex property : palette) mask |= std::uint32_t{1} << property;
        writer.put(mask, properties);
        return;
    }
    writer.putNumber(static_cast<std::uint32_t>(palette.size() - 1));
    for (const PropertyIndex property : palette) writer.put(property, bitsFor(properties));
}

void readPalette(std::pmr::vector<PropertyIndex>& palette, std::uint32_t properties, BitReader& reader) {
    palette.clear();
    if (properties <= shortPalette) {
        const std::uint32_t mask = reader.get(properties);
        for (std::uint32_t i = 0; i < properties; ++i)
            if ((mask >> i & 1) != 0) palette.push_back(static_cast<PropertyIndex>(i));
        return;
    }
    const std::uint32_t further = reader.getNumber();
    if (further >= properties) return;
    for (std::uint32_t i = 0; i <= further; ++i) {
        const std::uint32_t property = reader.get(bitsFor(properties));
        // Rising: if a property occurred twice, one of its runs could follow another.
        if (property >= properties || (!palette.empty() && property <= palette.back())) {
            palette.clear();
            return;
        }
        palette.push_back(static_cast<PropertyIndex>(property));
    }
}

} // namespace burin::packed_form

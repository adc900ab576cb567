// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacenav/events.h"

#include "plugins/devices/cap/cap_mapping.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace burin::spacenav {
namespace {

enum PacketKind : std::int32_t { motion = 0, press = 1, release = 2 };
constexpr std::int32_t buttonCount = 32;

std::int16_t counts(std::int32_t value, int sign) noexcept {
    constexpr double scale = cap::CapMapping::fullScale / EventReader::fullScale;
    const double bounded =
        std::clamp(static_cast<double>(value), -2.0 * EventReader::fullScale, 2.0 * EventReader::fullScale);
    return static_cast<std::int16_t>(std::lround(sign * scale * bounded));
}

} // namespace

EventReader::Kind EventReader::take(std::span<const std::uint8_t>& bytes) noexcept {
    const std::size_t taken = std::min(packetSize - filled_, bytes.size());
    std::copy_n(bytes.begin(), taken, packet_.begin() + static_cast<std::ptrdiff_t>(filled_));
    filled_ += taken;
    bytes = bytes.subspan(taken);
    if (filled_ < packetSize) return Kind::none;
    filled_ = 0;
    return read();
}

EventReader::Kind EventReader::read() noexcept {
    std::array<std::int32_t, 8> numbers;
    std::memcpy(numbers.data(), packet_.data(), packetSize);
    if (numbers[0] == motion) {
        // The cap's frame: x right, y towards the user, z down.
        for (std::size_t first : {std::size_t{0}, std::size_t{3}}) {
            controls_.axes[first] = counts(numbers[first + 1], 1);
            controls_.axes[first + 1] = counts(numbers[first + 3], -1);
            controls_.axes[first + 2] = counts(numbers[first + 2], -1);
        }
        return Kind::motion;
    }
    if ((numbers[0] == press || numbers[0] == release) && numbers[1] >= 0 && numbers[1] < buttonCount) {
        const std::uint32_t bit = 1U << static_cast<unsigned>(numbers[1]);
        controls_.buttons = numbers[0] == press ? controls_.buttons | bit : controls_.buttons & ~bit;
        return Kind::button;
    }
    return Kind::none;
}

} // namespace burin::spacenav

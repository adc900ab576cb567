// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/reports.h"

#include <algorithm>

namespace burin::spacemouse {
namespace {

enum ReportId : std::uint8_t {
    motionId = 0x01,
    rotationId = 0x02,
    buttonsId = 0x03,
    ledId = 0x04,
    batteryId = 0x17,
    keysId = 0x1c
};
constexpr std::size_t threeAxes = 6, sixAxes = 12; // bytes
constexpr unsigned bitButtons = 32;

std::uint16_t u16(Bytes bytes, std::size_t at) noexcept {
    return static_cast<std::uint16_t>(bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U);
}

} // namespace

ReportKind ReportReader::take(Bytes report) noexcept {
    if (report.empty()) return ReportKind::unknown;
    const Bytes bytes = report.subspan(1);
    switch (report[0]) {
    case motionId:
        if (bytes.size() >= sixAxes) {
            takeAxes(bytes, 0, 6);
            return ReportKind::motion;
        }
        if (bytes.size() < threeAxes) return ReportKind::unknown;
        takeAxes(bytes, 0, 3);
        return ReportKind::translation;
    case rotationId:
        if (bytes.size() < threeAxes) return ReportKind::unknown;
        takeAxes(bytes, 3, 3);
        return ReportKind::rotation;
    case buttonsId:
        if (bytes.empty()) return ReportKind::unknown;
        bits_ = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 4); ++i)
            bits_ |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
        joinButtons();
        return ReportKind::buttons;
    case keysId:
        if (bytes.size() < sixAxes) return ReportKind::unknown;
        takeKeys(bytes);
        return ReportKind::buttons;
    case batteryId:
        if (bytes.size() < 2 || bytes[0] > 100) return ReportKind::unknown;
        controls_.batteryPercent = static_cast<std::int8_t>(bytes[0]);
        controls_.charging = (bytes[1] & 1U) != 0;
        return ReportKind::battery;
    default:
        return ReportKind::unknown;
    }
}

void ReportReader::takeAxes(Bytes bytes, std::size_t first, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count; ++i) controls_.axes[first + i] = static_cast<std::int16_t>(u16(bytes, 2 * i));
}

/// An array of pressed buttons, as described by the descriptor: usages of the button page, which count from 1.
void ReportReader::takeKeys(Bytes bytes) noexcept {
    keyBits_ = 0;
    controls_.keys = {};
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const unsigned number = u16(bytes, 2 * i);
        if (number >= 1 && number <= bitButtons)
            keyBits_ |= 1U << (number - 1);
        else if (number > bitButtons && number <= 0xff)
            controls_.keys[beyond++] = static_cast<std::uint8_t>(number);
    }
    joinButtons();
}

void ReportReader::rest() noexcept {
    const Controls before = controls_;
    *this = ReportReader();
    controls_.batteryPercent = before.batteryPercent;
    controls_.charging = before.charging;
}

std::array<std::uint8_t, 2> ledReport(bool on) noexcept {
    return {ledId, static_cast<std::uint8_t>(on ? 1 : 0)};
}

} // namespace burin::spacemouse

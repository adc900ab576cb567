// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/open_stylus/firmware/open_stylus.h"
#include "tests/hid/uhid_device.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <random>

namespace burin::test {

/// An input report of the open stylus protocol, with the bytes of protocol.md.
struct InputReport {
    std::uint16_t sequence = 0, echo = 0, faults = 0;
    std::uint32_t microseconds = 0, buttons = 1;
    glm::dvec3 position{0.0}; ///< mm
    std::array<std::int32_t, 4> rotation{1 << 30, 0, 0, 0};
    std::uint8_t flags = 2, heat = 50;

    Report bytes() const {
        Report report(OPEN_STYLUS_INPUT_SIZE);
        report[0] = OPEN_STYLUS_INPUT_ID;
        report[1] = flags;
        put(report, 2, sequence, 2);
        put(report, 4, microseconds, 4);
        for (int axis = 0; axis < 3; ++axis) {
            const auto steps = static_cast<std::int32_t>(position[axis] * 65536.0);
            put(report, 8 + 4 * static_cast<std::size_t>(axis), static_cast<std::uint32_t>(steps), 4);
        }
        for (std::size_t i = 0; i < 4; ++i) put(report, 20 + 4 * i, static_cast<std::uint32_t>(rotation[i]), 4);
        put(report, 36, buttons, 4);
        put(report, 40, faults, 2);
        put(report, 42, echo, 2);
        report[44] = heat;
        sum(report);
        return report;
    }
    /// Corrects a report's checksum.
    static void sum(Report& report) {
        if (report.size() == OPEN_STYLUS_INPUT_SIZE) put(report, 46, open_stylus_crc(report.data(), 46), 2);
    }
    static void put(Report& report, std::size_t at, std::uint32_t value, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) report[at + i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xffU);
    }
};

/// Reports of a device that is broken, or built to do harm: noise of all lengths, wrong ids, damage with correct and
/// wrong checksums, huge and meaningless values, sequence numbers that repeat, skip and go back, time that runs
/// backwards. Seeded.
class HostileReports {
public:
    explicit HostileReports(unsigned seed) : random_(seed) {}

    /// @param good the last valid report
    Report next(const InputReport& good) {
        InputReport reading = good;
        reading.sequence = static_cast<std::uint16_t>(good.sequence + ++ahead_);
        reading.microseconds += 250U * ahead_;
        Report report;
        switch (random_() % 14) {
        case 0: // noise; sometimes longer than any report, up to the kernel's limit
            return noise(random_() % 64 == 0 ? 1 + random_() % 4096 : 1 + random_() % 64, any() & 3U);
        case 1:
            return noise(OPEN_STYLUS_INPUT_SIZE, static_cast<std::uint8_t>(any()));
        case 2:
            return damaged(reading.bytes(), false);
        case 3:
            return damaged(reading.bytes(), true);
        case 4: // of valid form, with arbitrary values
            reading.position = {place(), place(), place()};
            break;
        case 5:
            for (auto& number : reading.rotation) number = static_cast<std::int32_t>(any());
            break;
        case 6: // the most negative numbers, whose magnitude no signed number can represent
            report = reading.bytes();
            for (std::size_t at = 8; at < (random_() % 2 == 0 ? 20U : 36U); at += 4)
                InputReport::put(report, at, 0x80000000U, 4);
            InputReport::sum(report);
            return report;
        case 7:
            reading.sequence = static_cast<std::uint16_t>(any());
            break;
        case 8:
            return last_; // repeated
        case 9:
            reading.microseconds = any();
            break;
        case 10:
            reading.microseconds = good.microseconds - any() % 100'000U;
            break;
        case 11:
            reading.faults = static_cast<std::uint16_t>(1U << random_() % 16);
            break;
        case 12:
            reading.flags = static_cast<std::uint8_t>(any());
            reading.heat = static_cast<std::uint8_t>(any());
            reading.buttons = any();
            reading.echo = static_cast<std::uint16_t>(any());
            break;
        default: // truncated, or with bytes appended
            report = reading.bytes();
            report.resize(1 + random_() % 96, static_cast<std::uint8_t>(any()));
            return report;
        }
        last_ = reading.bytes();
        return last_;
    }
    /// Good reports follow.
    void pause() { ahead_ = 0; }

private:
    std::uint32_t any() { return static_cast<std::uint32_t>(random_()); }
    double place() { return std::uniform_real_distribution(-32767.0, 32767.0)(random_); }
    Report noise(std::size_t size, std::uint32_t id) {
        Report report(size);
        for (auto& byte : report) byte = static_cast<std::uint8_t>(any());
        report[0] = static_cast<std::uint8_t>(id);
        return report;
    }
    Report damaged(Report report, bool mended) {
        for (unsigned bits = 1 + random_() % 4; bits > 0; --bits)
            report[random_() % report.size()] ^= static_cast<std::uint8_t>(1U << random_() % 8);
        if (mended) InputReport::sum(report);
        return report;
    }

    std::mt19937 random_;
    std::uint32_t ahead_ = 0;
    Report last_ = InputReport{}.bytes();
};

} // namespace burin::test

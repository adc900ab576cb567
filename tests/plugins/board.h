// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/open_stylus/firmware/open_stylus.h"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace burin::test {

/// A board with the reference firmware whose hardware is simulated by a test: the test sets the measured values and
/// reads the motors' output. Single-threaded.
class Board {
public:
    using Report = std::vector<std::uint8_t>;

    /// Limits of a desktop device, in round numbers.
    static open_stylus_limits limits() {
        open_stylus_limits limits{};
        limits.firmware_major = 1;
        limits.firmware_minor = 2;
        limits.firmware_patch = 3;
        limits.sensed_translations = limits.sensed_rotations = 3;
        limits.actuated_translations = limits.actuated_rotations = 3;
        limits.buttons = 2;
        limits.source = 2;
        limits.rate = 1000;
        limits.watchdog = 20;
        limits.delay = 100;
        limits.maximum_speed = 1000;
        limits.maximum_force = 3U << 16U;
        limits.continuous_force = 1U << 16U;
        limits.maximum_torque = 100U << 16U;
        limits.maximum_stiffness = 400U << 8U;
        limits.maximum_damping = 4U << 16U;
        limits.maximum_turning_stiffness = 300U << 8U;
        limits.workspace_radius = 80U << 16U;
        limits.position_step = 335544;
        limits.rotation_step = 536870;
        limits.handle_mass = 2048;
        return limits;
    }

    /// @param send  passes a report to the transport; returns false if there is no room
    explicit Board(std::function<bool(const Report&)> send, const open_stylus_limits& wanted = limits())
        : send_(std::move(send)) {
        reading.rotation[0] = 1 << 30;
        reading.heat = OPEN_STYLUS_HEAT_UNKNOWN;
        const open_stylus_port port{
            this,
            [](void* board) { return static_cast<Board*>(board)->microseconds; },
            [](void* board, open_stylus_reading* out) { *out = static_cast<Board*>(board)->reading; },
            [](void* board, const std::int32_t* newForce, const std::int32_t* newTorque) {
                static_cast<Board*>(board)->drive(newForce, newTorque);
            },
            [](void* board) { static_cast<Board*>(board)->release(); },
            [](void* board, const std::uint8_t* report, std::size_t size) {
                return static_cast<Board*>(board)->send_(Report(report, report + size));
            }};
        open_stylus_start(&firmware_, &wanted, &port);
    }
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;

    /// Advances by one period.
    void step(std::uint32_t elapsed = 1000) {
        microseconds += elapsed;
        open_stylus_step(&firmware_);
    }
    bool receive(const Report& report) { return open_stylus_receive(&firmware_, report.data(), report.size()); }
    Report feature() const {
        Report report(OPEN_STYLUS_FEATURE_SIZE);
        report.resize(open_stylus_feature(&firmware_, OPEN_STYLUS_FEATURE_ID, report.data(), report.size()));
        return report;
    }
    void moveTo(double x, double y, double z) {
        const std::array place{x, y, z};
        for (std::size_t i = 0; i < 3; ++i) reading.position[i] = static_cast<std::int32_t>(place[i] * 65536.0);
    }

    open_stylus_reading reading{};
    std::uint32_t microseconds = 0;
    bool motorsOn = false;
    std::array<std::int32_t, 3> force{}, torque{}; ///< output of the motors
    std::uint64_t largestForceSquared = 0;         ///< maximum so far, in steps

private:
    void drive(const std::int32_t* wantedForce, const std::int32_t* wantedTorque) {
        motorsOn = true;
        std::uint64_t square = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            force[i] = wantedForce[i];
            torque[i] = wantedTorque[i];
            square += static_cast<std::uint64_t>(static_cast<std::int64_t>(force[i]) * force[i]);
        }
        if (square > largestForceSquared) largestForceSquared = square;
    }
    void release() {
        motorsOn = false;
        force = torque = {};
    }

    std::function<bool(const Report&)> send_;
    open_stylus firmware_{};
};

} // namespace burin::test

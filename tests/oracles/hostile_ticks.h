// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <limits>
#include <optional>
#include <random>

namespace burin::test {

/// What a loop may meet in one tick.
struct HostileTick {
    StylusState state;
    double period = 0.001;           ///< s that the loop says have passed
    bool bad = false;                ///< no force may follow this tick
    std::optional<double> allowance; ///< mm, set before the tick
};

/// A hand that wanders through stock and into the part, and in one of a hundred ticks something that must not happen:
/// numbers that are none, infinite or huge, missing readings, jumps of 50 mm, late ticks, pauses, clocks that stand or
/// go back. The same ticks for the same seed.
class HostileTicks {
public:
    explicit HostileTicks(unsigned seed) : random_(seed) {}

    HostileTick next() {
        HostileTick tick;
        velocity_ = 0.98 * velocity_ + 0.01 * glm::dvec3(unit(), unit(), unit());
        hand_ = glm::clamp(hand_ + velocity_, glm::dvec3(-15, -15, -16), glm::dvec3(15, 15, 9));
        tick.state.pose.position = hand_;
        tick.state.valid = true;
        tick.bad = true;
        switch (std::uniform_int_distribution(0, 999)(random_)) {
        case 0:
            tick.state.pose.position.y = none;
            break;
        case 1:
            tick.state.pose.position.z = -std::numeric_limits<double>::infinity();
            break;
        case 2:
            tick.state.pose.rotation.w = none;
            break;
        case 3:
            tick.state.valid = false;
            break;
        case 4:
            tick.state.pose.position += glm::dvec3(0, 50, 0);
            break;
        case 5:
            tick.period = 0.004;
            break;
        case 6:
            tick.period = 0.3;
            break;
        case 7:
            tick.period = unit() < 0.0 ? none : -0.001;
            break;
        case 8:
            tick.state.pose.position *= 1e300;
            break;
        case 9:
            tick.allowance = unit();
            [[fallthrough]];
        default:
            tick.bad = false;
        }
        return tick;
    }

private:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double unit() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }

    std::mt19937_64 random_;
    glm::dvec3 hand_{0, 0, 5}, velocity_{0.0};
};

} // namespace burin::test

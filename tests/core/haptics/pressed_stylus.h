// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/loop_clock.h"
#include "tests/core/haptics/haptic_rig.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace burin::test {

inline void waitFor(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Motors that another thread may cut.
struct Motors {
    std::atomic<double> force{0.0};     ///< N, rendered
    std::atomic<std::int64_t> cutAt{0}; ///< ns
    std::atomic<int> cuts{0};
    void cut() noexcept {
        force = 0.0;
        cutAt = now();
        ++cuts;
    }
};

/// A hand that always presses a millimetre deep into the floor of `stockOnPart`.
inline StylusState pressing(double time) {
    StylusState state;
    state.time = time;
    state.pose.position = {0.0, 0.0, std::max(floorHeight - 1.0, 2.0 - 400.0 * time)};
    state.valid = true;
    return state;
}

/// The action of a test at one reading.
struct Trick {
    int at = -1;         ///< reading, from 0
    double blocks = 0.0; ///< s, before the reading
    void play(int reading) const {
        if (reading == at) waitFor(blocks);
    }
};

/// A stylus that is called by the loop.
class CalledStylus final : public Stylus {
public:
    explicit CalledStylus(Motors& motors, Trick trick = {}) : motors_(motors), trick_(trick) {}
    StylusDescription description() const override { return desktopStylus(); }
    Result<void> open() override { return {}; }
    void close() noexcept override {}
    void cutMotors() noexcept override { motors_.cut(); }
    StylusState read(double time) noexcept override {
        trick_.play(readings_++);
        return pressing(time);
    }
    void write(const Wrench& wrench) noexcept override { motors_.force = glm::length(wrench.force); }

private:
    Motors& motors_;
    Trick trick_;
    int readings_ = 0;
};

/// A field that blocks one of its callers once.
class BlockingField final : public ClearanceField {
public:
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        if (blocks.exchange(false)) {
            blockedAt = now();
            waitFor(seconds);
        }
        return field_.at(tip);
    }
    double errorBound() const noexcept override { return field_.errorBound(); }
    double spacing() const noexcept override { return field_.spacing(); }

    mutable std::atomic<bool> blocks{false};
    mutable std::atomic<std::int64_t> blockedAt{0};
    double seconds = 0.0;

private:
    FloorField field_{FloorSolid{}, 3.0};
};

} // namespace burin::test

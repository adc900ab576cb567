// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "tests/plugins/board.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace burin::test {

/// A powered board: runs its firmware once a millisecond in a thread of its own. Thread-safe.
class RunningBoard {
public:
    using Clock = std::chrono::steady_clock;

    explicit RunningBoard(std::function<bool(const Board::Report&)> send,
                          const open_stylus_limits& limits = Board::limits())
        : send_(std::move(send)), board_([this](const Board::Report& report) { return transmit(report); }, limits) {}
    ~RunningBoard() { stop(); }
    RunningBoard(const RunningBoard&) = delete;
    RunningBoard& operator=(const RunningBoard&) = delete;

    void start() {
        thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }
    void stop() {
        if (!thread_.joinable()) return;
        thread_.request_stop();
        thread_.join();
    }
    /// Delivers an output report to the board.
    void deliver(const Board::Report& report) {
        const std::lock_guard lock(mutex_);
        if (!board_.receive(report)) return;
        if ((report[1] & 1U) == 0) ++offs;
        const std::size_t answered = report[28]; // low byte of the echo
        if (sentAt_[answered] != Clock::time_point{}) {
            roundTrips_.push_back(std::chrono::duration<double>(Clock::now() - sentAt_[answered]).count());
            sentAt_[answered] = {};
        }
        show();
    }
    Board::Report feature() {
        const std::lock_guard lock(mutex_);
        return board_.feature();
    }
    /// The times from sending each reading to the arrival of its answer since the last call, s.
    std::vector<double> takeRoundTrips() {
        const std::lock_guard lock(mutex_);
        return std::exchange(roundTrips_, {});
    }
    std::uint64_t largestForceSquared() {
        const std::lock_guard lock(mutex_);
        return board_.largestForceSquared;
    }

    std::atomic<double> x{0.0}, y{0.0}, z{0.0}; ///< mm, position of the stylus
    std::atomic<std::uint32_t> buttons{0};
    std::atomic<std::uint8_t> heat{OPEN_STYLUS_HEAT_UNKNOWN};
    std::atomic<bool> silent{false}; ///< sends nothing
    std::atomic<double> force{0.0};  ///< N, along x, output of the motors
    std::atomic<bool> motors{false};
    std::atomic<int> offs{0}; ///< valid output reports that switched the motors off

private:
    bool transmit(const Board::Report& report) {
        sentAt_[report[2]] = Clock::now(); // by the low byte of its number
        return send_(report);
    }
    void show() {
        force = board_.force[0] / 65536.0;
        motors = board_.motorsOn;
    }
    void run(const std::stop_token& stop) {
        const auto start = Clock::now();
        auto due = start;
        while (!stop.stop_requested()) {
            due = std::max(due + std::chrono::milliseconds(1), Clock::now() - std::chrono::milliseconds(1));
            std::this_thread::sleep_until(due);
            const std::lock_guard lock(mutex_);
            if (silent.load()) continue;
            board_.moveTo(x.load(), y.load(), z.load());
            board_.reading.heat = heat.load();
            board_.reading.buttons = buttons.load();
            const auto passed = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start).count();
            board_.step(static_cast<std::uint32_t>(passed) - board_.microseconds);
            show();
        }
    }

    std::function<bool(const Board::Report&)> send_;
    std::mutex mutex_;
    std::array<Clock::time_point, 256> sentAt_{};
    std::vector<double> roundTrips_;
    Board board_;
    std::jthread thread_;
};

/// A wall at x = 0 that pushes out with 0.1 N/mm and counts the readings that it received. Its answers to invalid
/// readings must not be rendered.
class Wall final : public StylusClient {
public:
    void begins() noexcept override { thread_ = std::this_thread::get_id(); }
    Wrench tick(const StylusState& state) noexcept override {
        timeRises = timeRises && state.time > lastTime_;
        lastTime_ = state.time;
        oneThread = oneThread && thread_ == std::this_thread::get_id();
        if (!state.valid) {
            ++invalid;
            return {{1000.0, 1000.0, 1000.0}, {}};
        }
        ++valid;
        return {{state.pose.position.x < 0.0 ? -0.1 * state.pose.position.x : 0.0, 0.0, 0.0}, {}};
    }
    void ends() noexcept override { ended = true; }

    std::atomic<int> valid{0}, invalid{0};
    std::atomic<bool> timeRises{true}, oneThread{true}, ended{false};

private:
    std::thread::id thread_;
    double lastTime_ = -1.0;
};

/// Pushes with 1 N along x and hangs in a tick while `hang` is set.
class HangingClient final : public StylusClient {
public:
    Wrench tick(const StylusState& state) noexcept override {
        if (hang) held = true;
        while (hang) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++(state.valid ? valid : invalid);
        return {{1.0, 0.0, 0.0}, {}};
    }
    void answered() noexcept override { ++answers; }

    std::atomic<bool> hang{false}, held{false};
    std::atomic<int> valid{0}, invalid{0}, answers{0};
};

} // namespace burin::test

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/haptics/loop/loop_watchdog.h"
#include "core/haptics/loop/tick_sink.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace burin {

/// Where flight records go, and whose they are.
struct FlightSettings {
    std::filesystem::path folder;       ///< is made when the first record is written
    std::string device;                 ///< name of the stylus
    double period = 0.001;              ///< s, of the loop
    int keep = 8;                       ///< records in the folder; the oldest go
    std::vector<std::string> materials; ///< ids of the workpiece's property list, each at its index
};

/// A fault, and the file that tells of it.
struct FlightReport {
    TickFault fault = TickFault::none;
    std::filesystem::path file; ///< empty: it could not be written
};

/// Keeps the last two seconds of a loop in fixed memory, and writes them to a file when a fault begins: every reading
/// as it came, what became of it, and how the loop kept up. The sink behind it goes on as without it. The tick copies
/// some hundred bytes: no allocation, lock or system call. While a record is written, which takes some milliseconds, no
/// ticks are kept; faults meanwhile are told with that file. The file: see core/haptics/README.md.
class FlightRecorder final : public TickSink, public LoopAlarm {
public:
    static constexpr double length = 2.0; ///< s

    /// @param next outlives the recorder
    FlightRecorder(FlightSettings settings, TickSink& next);
    ~FlightRecorder() override { finish(); }
    FlightRecorder(const FlightRecorder&) = delete;
    FlightRecorder& operator=(const FlightRecorder&) = delete;

    AtEdge edge() noexcept override { return next_.edge(); }
    void tick(const Sample& sample, const TickTiming& timing) noexcept override;
    void loopDied() noexcept override { raise(TickFault::dead); }

    /// Owner's thread, once no tick runs any more: what was triggered is written when this returns.
    void finish();
    /// Any thread: the oldest record that nobody took yet.
    std::optional<FlightReport> take();
    /// Any thread: a record is about to be written, and will be there to take.
    bool writing() const noexcept {
        return wanted_.load(std::memory_order_acquire) || writing_.load(std::memory_order_acquire);
    }

    /// One tick of a record.
    struct Entry {
        Sample sample;
        TickTiming timing;
    };

private:
    /// Who may touch the entries right now.
    enum class Turn : std::uint8_t { nobody, loop, writer };

    void raise(TickFault fault) noexcept;
    void run(const std::stop_token& stop);
    void writeRaised();
    void writeRecord();
    std::vector<Entry> freeze();

    const FlightSettings settings_;
    TickSink& next_;
    std::vector<Entry> entries_;
    std::uint64_t count_ = 0; ///< ticks ever kept; the newest at (count_ - 1) % size
    std::atomic<Turn> turn_{Turn::nobody};
    BoxOf<TickFault> raised_;
    std::atomic<bool> wanted_{false}, writing_{false};

    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::vector<FlightReport> reports_; ///< guarded by mutex_
    std::jthread thread_;               // last: it uses the above
};

/// The text of a record. @param entries the oldest first. @param unixTime s since 1970, UTC
std::string formatFlight(const FlightSettings& settings, TickFault fault, double unixTime,
                         const std::vector<FlightRecorder::Entry>& entries);

} // namespace burin

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

/// Settings of the flight records: their folder, and the session that they describe.
struct FlightSettings {
    std::filesystem::path folder; ///< created when the first record is written
    std::string device;           ///< name of the stylus
    double period = 0.001;        ///< s, of the loop
    int keep = 8;                 ///< maximum number of records in the folder; the oldest are deleted
    /// ids of the materials in the workpiece's property list, in the order of their indices
    std::vector<std::string> materials;
};

/// A fault, and the file that records it.
struct FlightReport {
    TickFault fault = TickFault::none;
    std::filesystem::path file; ///< empty if it could not be written
};

/// Keeps the last two seconds of a loop in fixed memory, and writes them to a file when a fault begins: every reading
/// as it arrived, the resulting sample, and the timing of the loop. All calls are passed on to the next sink unchanged.
/// Each tick copies some hundred bytes: no allocation, lock or system call. While a record is written, which takes some
/// milliseconds, no ticks are kept; faults in the meantime are reported with that file. File format: see
/// core/haptics/README.md.
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

    /// Owner's thread, once no more ticks run. When it returns, all triggered records have been written.
    void finish();
    /// Any thread. The oldest report that was not taken yet.
    std::optional<FlightReport> take();
    /// Any thread. Whether a record is about to be written, which can be taken afterwards.
    bool writing() const noexcept {
        return wanted_.load(std::memory_order_acquire) || writing_.load(std::memory_order_acquire);
    }

    /// One tick in a record.
    struct Entry {
        Sample sample;
        TickTiming timing;
    };

private:
    /// Which thread may access the entries right now.
    enum class Turn : std::uint8_t { nobody, loop, writer };

    void raise(TickFault fault) noexcept;
    void run(const std::stop_token& stop);
    void writeRaised();
    void writeRecord();
    std::vector<Entry> freeze();

    const FlightSettings settings_;
    TickSink& next_;
    std::vector<Entry> entries_;
    std::uint64_t count_ = 0; ///< number of ticks kept so far; the newest is at (count_ - 1) % size
    std::atomic<Turn> turn_{Turn::nobody};
    BoxOf<TickFault> raised_;
    std::atomic<bool> wanted_{false}, writing_{false};

    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::vector<FlightReport> reports_; ///< guarded by mutex_
    std::jthread thread_;               // last: it uses the above
};

/// Returns the text of a record. @param entries oldest first. @param unixTime s since 1970, UTC
std::string formatFlight(const FlightSettings& settings, TickFault fault, double unixTime,
                         const std::vector<FlightRecorder::Entry>& entries);

} // namespace burin

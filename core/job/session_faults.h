// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/device/stylus.h"
#include "core/haptics/loop/flight_recorder.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// The faults of a session, of its stylus and of its loop, as messages that name the record of what led to them.
/// Owner's thread, but for the sink and the alarm, which are the loop's.
class SessionFaults {
public:
    /// @param flights folder; empty: nothing is recorded, as for a simulated stylus, whose user no force can hurt
    /// @param materials ids of the workpiece's property list, each at its index
    SessionFaults(StylusDevice& device, double period, const std::filesystem::path& flights,
                  std::vector<std::string> materials, TickSink& loop);
    /// Where records of a project's sessions stand: "part.flights" beside "part.burin".
    static std::filesystem::path folderBeside(const std::filesystem::path& project);

    TickSink& sink() noexcept; ///< that the servo loop tells its ticks
    LoopAlarm* alarm() noexcept { return recorder_.get(); }
    /// The oldest fault that nobody took yet; waits for no file: a fault whose record is about to be written, or may
    /// be, comes later.
    std::optional<Error> take();

    /// Once the loop has ended: all records are written, and what they tell can be taken.
    void finish() {
        if (recorder_) recorder_->finish();
        finished_ = true;
    }

private:
    using Clock = std::chrono::steady_clock;
    std::optional<Error> takeOfLoop();
    std::optional<Error> takeOfStylus();

    StylusDevice& device_;
    std::string name_;
    TickSink& loop_;
    std::unique_ptr<FlightRecorder> recorder_; ///< null: none
    std::filesystem::path newest_;             ///< record
    Clock::time_point newestAt_;
    std::optional<Error> held_; ///< of the stylus
    Clock::time_point heldSince_;
    bool finished_ = false;
};

} // namespace burin

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

/// The faults of a session, of its stylus and of its loop, as messages that name the record of what led to them. Call
/// on the owner's thread; the sink and the alarm belong to the loop.
class SessionFaults {
public:
    /// @param flights folder; empty: nothing is recorded, as for a simulated stylus, which can't hurt its user
    /// @param materials ids of the workpiece's property list, each at its index
    SessionFaults(StylusDevice& device, double period, const std::filesystem::path& flights,
                  std::vector<std::string> materials, TickSink& loop);
    /// Returns the folder of the records of a project's sessions: "part.flights" next to "part.burin".
    static std::filesystem::path folderBeside(const std::filesystem::path& project);

    TickSink& sink() noexcept; ///< to which the servo loop reports its ticks
    LoopAlarm* alarm() noexcept { return recorder_.get(); }
    /// Returns the oldest fault that was not taken yet. Does not wait for files: a fault whose record is being written,
    /// or may still be written, is returned by a later call.
    std::optional<Error> take();

    /// Call after the loop has ended: all records are written, and their faults can be taken.
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

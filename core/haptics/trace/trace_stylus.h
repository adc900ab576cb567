// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/recording/trace_playback.h"

#include <memory>
#include <vector>

namespace burin {

/// Plays a recorded trace open loop: forces written to it have no effect. At a recorded time it returns that reading
/// exactly, to the bit; between two readings it interpolates; before the first and after the last it returns these. A
/// trace of ticks (readings with periods) is played tick by tick instead, whatever the time: one reading per call, each
/// with its period, so that a step does the same as when it was recorded.
class TraceStylus final : public Stylus {
public:
    /// @param states as returned by readTrace. @param description its limits apply to the computed forces.
    TraceStylus(std::vector<StylusState> states, StylusDescription description);
    /// @param readings source of the same readings; it may wait for the disk, as nobody feels a trace
    TraceStylus(std::unique_ptr<TracePlayback> readings, StylusDescription description);

    StylusDescription description() const override { return description_; }
    /// A repeated call starts from the beginning. Errors: argumentInvalid (no state, or times that don't rise without
    /// periods), those of TracePlayback::rewind.
    Result<void> open() override;
    /// @param time s; not earlier than in the previous call
    StylusState read(double time) noexcept override;
    void write(const Wrench&) noexcept override {}
    bool finished() const noexcept override { return played_; }
    void close() noexcept override {}
    /// The error that ended the readings before the trace's end, if any. Called after `close`.
    Result<void> outcome() { return readings_->outcome(); }

private:
    StylusState nextTick(double time) noexcept;
    StylusState at(double time) noexcept;
    void advance() noexcept;

    std::unique_ptr<TracePlayback> readings_;
    StylusDescription description_;
    StylusState before_, after_; ///< the newest reading that was reached, and the following one
    bool reached_ = false;       ///< whether `before_` is valid
    bool more_ = false;          ///< whether `after_` is valid
    bool played_ = false;
};

} // namespace burin

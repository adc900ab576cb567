// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/recording/trace_playback.h"

#include <memory>
#include <vector>

namespace burin {

/// Plays a recorded trace open loop: forces written to it go nowhere. At a recorded time it returns that reading bit by
/// bit; between two it interpolates; before the first and after the last it rests there. A trace of ticks (readings
/// with periods) is played tick by tick instead, whatever the time: one reading a call, each told with its period, so
/// that a step does what it did.
class TraceStylus final : public Stylus {
public:
    /// @param states as readTrace returns them. @param description whose limits bound the forces that are computed.
    TraceStylus(std::vector<StylusState> states, StylusDescription description);
    /// @param readings give the same, and may wait for the disk: nobody feels a trace
    TraceStylus(std::unique_ptr<TracePlayback> readings, StylusDescription description);

    StylusDescription description() const override { return description_; }
    /// Again: starts anew. Errors: argumentInvalid (no state, or times that don't rise without periods), those of
    /// TracePlayback::rewind.
    Result<void> open() override;
    /// @param time s; no earlier than in the call before
    StylusState read(double time) noexcept override;
    void write(const Wrench&) noexcept override {}
    bool finished() const noexcept override { return played_; }
    void close() noexcept override {}
    /// What ended the readings before the trace's end. After `close`.
    Result<void> outcome() { return readings_->outcome(); }

private:
    StylusState nextTick(double time) noexcept;
    StylusState at(double time) noexcept;
    void advance() noexcept;

    std::unique_ptr<TracePlayback> readings_;
    StylusDescription description_;
    StylusState before_, after_; ///< the newest reading that was reached, and the one behind it
    bool reached_ = false;       ///< there is a `before_`
    bool more_ = false;          ///< there is an `after_`
    bool played_ = false;
};

} // namespace burin

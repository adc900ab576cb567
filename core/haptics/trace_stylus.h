// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

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

    StylusDescription description() const override { return description_; }
    /// Again: starts anew. Errors: argumentInvalid (no state, or times that don't rise without periods).
    Result<void> open() override;
    StylusState read(double time) noexcept override;
    void write(const Wrench&) noexcept override {}
    bool finished() const noexcept override { return played_; }
    void close() noexcept override {}

private:
    StylusState nextTick(double time) noexcept;

    std::vector<StylusState> states_;
    StylusDescription description_;
    bool ticks_ = false;
    std::size_t next_ = 0; ///< tick
    bool played_ = false;
};

} // namespace burin

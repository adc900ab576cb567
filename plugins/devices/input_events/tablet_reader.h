// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libevdev/libevdev.h>

#include <cstdint>

namespace burin::input_events {

/// The state of a pen on its tablet.
struct Pen {
    bool near = false;               ///< the tablet detects the pen; otherwise the other values are old
    double x = 0.0, y = 0.0;         ///< mm from the centre of the tablet: right, away from the user
    double pressure = 0.0;           ///< 0 … 1
    double leanX = 0.0, leanY = 0.0; ///< rad, tilt to the right and away from the user
    std::uint32_t buttons = 0;       ///< bit 0: it touches; the other bits: buttons of its barrel
};

/// Converts the events of a tablet to the state of a pen: all events of a report at once. Source of the codes: the
/// kernel's Documentation/input/event-codes.rst. One thread; no allocation, no exception.
class TabletReader {
public:
    static constexpr double assumedWidth = 200.0; ///< mm, for a tablet that states no resolution

    explicit TabletReader(const libevdev& device) noexcept;

    /// Returns true if a report is complete; `pen` is its content then.
    bool take(const input_event& event) noexcept;
    const Pen& pen() const noexcept { return told_; }
    /// The pen is lost together with the tablet.
    void rest() noexcept;
    /// whether the tablet reports the tilt of the pen
    bool leans() const noexcept { return tiltX_.known && tiltY_.known; }
    bool statesSize() const noexcept { return statesSize_; }
    double width() const noexcept { return x_.span() / x_.perUnit; }  ///< mm
    double height() const noexcept { return y_.span() / y_.perUnit; } ///< mm
    double step() const noexcept { return 1.0 / x_.perUnit; }         ///< mm, resolution

private:
    struct Axis {
        bool known = false;
        double low = 0.0, high = 1.0;
        double perUnit = 0.0; ///< values per millimetre, or per radian
        double span() const noexcept { return high - low; }
        double fromMiddle(int value) const noexcept;
        double share(int value) const noexcept;
    };
    static Axis axisOf(const libevdev& device, unsigned int code) noexcept;
    void move(const input_event& event) noexcept;
    void press(const input_event& event) noexcept;

    Axis x_, y_, pressure_, tiltX_, tiltY_;
    bool statesSize_ = false;
    Pen pen_;  ///< according to the report in progress
    Pen told_; ///< according to the last complete report
};

} // namespace burin::input_events

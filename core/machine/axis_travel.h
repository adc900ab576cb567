// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis_values.h"
#include "core/machine/machine_profile.h"

#include <limits>
#include <optional>

namespace burin {

/// Judges whether the axes of a machine get wherever a program sends them. It is told one place after the other; from
/// the first two on the way between them can be longer than an axis, wherever on it the setup stands. Lengths are mm,
/// of rotary axes degrees; axes without a stated travel, as rotary ones are, have no end.
class AxisTravel {
public:
    /// @param ends of X, Y and Z, counted as the values that follow; empty: nobody knows where they lie
    explicit AxisTravel(const MachineProfile& machine, const Box& ends = {}) noexcept;

    void goTo(AxisSet axes, const AxisValues& values) noexcept;
    void goTo(Axis axis, double value) noexcept;

    /// Way that an axis would have to have for its last place, and all before: more than it has. Nothing: it gets
    /// there.
    std::optional<double> wayBeyond(Axis axis) const noexcept;
    double length(Axis axis) const noexcept { return ends_[axis].length; } ///< that an axis has; infinite: no end

private:
    struct Ends {
        double length = std::numeric_limits<double>::infinity();
        double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    };
    struct Way {
        double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
        double last = 0.0;
    };

    ByAxis<Ends> ends_;
    ByAxis<Way> ways_;
};

} // namespace burin

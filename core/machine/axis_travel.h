// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis_values.h"
#include "core/machine/machine_profile.h"

#include <limits>
#include <optional>

namespace burin {

/// Checks whether the travel of a machine's axes is enough for a program. It receives one position after the other;
/// from the second on, the range between them can exceed the travel of an axis, wherever in that travel the setup is
/// placed. Lengths are mm, for rotary axes degrees; axes without a stated travel have no limits.
class AxisTravel {
public:
    /// @param limits of X, Y and Z, in the same coordinates as the values that follow; empty: their position is not
    /// known
    explicit AxisTravel(const MachineProfile& machine, const Box& ends = {}) noexcept;

    void goTo(AxisSet axes, const AxisValues& values) noexcept;
    void goTo(Axis axis, double value) noexcept;

    /// The travel that an axis would need for its last position together with all previous ones, if that exceeds the
    /// travel it has. Empty if the position can be reached.
    std::optional<double> wayBeyond(Axis axis) const noexcept;
    double length(Axis axis) const noexcept { return ends_[axis].length; } ///< travel of an axis; infinite: no limits

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

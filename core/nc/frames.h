// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis_values.h"
#include "core/nc/machine_state.h"

namespace burin {

/// The positions of the axes in the frame of the work offset in force, as far as text and machine state them, and the
/// offsets between that frame, the machine frame and the program's frame. Lengths in mm, angles in degrees. Not
/// thread-safe.
class Frames {
public:
    /// @param axes the axes that programs move
    Frames(const MachineState& start, AxisSet axes);

    const AxisValues& place() const noexcept { return place_; }
    AxisSet known() const noexcept { return known_; } ///< axes whose position is known; for others it has no meaning
    const AxisValues& shift() const noexcept { return shift_; }
    int workOffset() const noexcept { return workOffset_; }
    int lengthOffsetNumber() const noexcept { return lengthNumber_; }
    bool ownZero() const noexcept { return ownZero_; }

    void moveTo(const AxisValues& place, AxisSet known);
    /// For a tool change: where it leaves the axes depends on the machine.
    void forgetPlace() noexcept { known_ = {}; }

    void setWorkOffset(int number);
    /// G10 L2: sets the zero of an offset in the machine frame, for the axes given.
    void writeWorkOffset(int number, const PartialPlace& zero);
    /// G10 L20: sets the zero of an offset such that the tool is at `here` in it.
    void writeWorkOffsetHere(int number, const PartialPlace& here);
    /// @param length empty if not known
    void setLengthOffset(int number, std::optional<double> length) noexcept;
    std::optional<double> lengthOf(int number) const;

    void shiftSoThatHereIs(const PartialPlace& here); ///< G92
    void setShift(const PartialPlace& shift);         ///< G52
    void dropShift(bool keep);                        ///< G92.1, or G92.2 that keeps it for G92.3
    void restoreShift() { shift_ = keptShift_; }      ///< G92.3

    /// Converts a position from the machine frame to that of the work offset; empty if an offset between them is not
    /// known.
    std::optional<double> fromMachine(Axis axis, double value) const;
    std::optional<double> inMachine(Axis axis) const; ///< machine position of the axis
    const PartialPlace& home(std::size_t which) const noexcept { return homes_[which]; }
    void storeHome(std::size_t which);

    /// The value of one of the control's own parameters; empty if not known. @param length mm of the unit in force
    std::optional<double> parameter(int number, double length, int tool) const;

private:
    std::optional<double> offsetOf(int number, Axis axis) const;
    /// The axis of a parameter in a series that begins with X; empty if programs do not move that axis.
    std::optional<Axis> axisOf(int number, int first) const noexcept;

    AxisSet axes_;
    AxisValues place_, shift_, keptShift_;
    AxisSet known_;
    int workOffset_ = 54;
    int lengthNumber_ = 0;
    std::optional<double> length_;
    bool ownZero_ = false;
    std::map<int, PartialPlace> offsets_;
    std::map<int, double> lengths_;
    std::array<PartialPlace, 2> homes_{};
    double unit_ = 1.0;
};

} // namespace burin

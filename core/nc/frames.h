// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis_values.h"
#include "core/nc/machine_state.h"

namespace burin {

/// Where the axes stand, in the frame of the work offset in force, as far as the text (and the machine) tell, and the
/// offsets between that frame, the machine's and the program's. Lengths in mm, angles in degrees. One thread.
class Frames {
public:
    /// @param axes that programs move
    Frames(const MachineState& start, AxisSet axes);

    const AxisValues& place() const noexcept { return place_; }
    AxisSet known() const noexcept { return known_; } ///< axes whose place is known; of others it has no meaning
    const AxisValues& shift() const noexcept { return shift_; }
    int workOffset() const noexcept { return workOffset_; }
    int lengthOffsetNumber() const noexcept { return lengthNumber_; }
    bool ownZero() const noexcept { return ownZero_; }

    void moveTo(const AxisValues& place, AxisSet known);
    /// A tool change: where it leaves the machine is the machine's own affair.
    void forgetPlace() noexcept { known_ = {}; }

    void setWorkOffset(int number);
    /// G10 L2: zeros of an offset in the machine frame, of the axes given.
    void writeWorkOffset(int number, const PartialPlace& zero);
    /// G10 L20: zeros such that the tool stands at `here` in it.
    void writeWorkOffsetHere(int number, const PartialPlace& here);
    /// @param length nothing: not known
    void setLengthOffset(int number, std::optional<double> length) noexcept;
    std::optional<double> lengthOf(int number) const;

    void shiftSoThatHereIs(const PartialPlace& here); ///< G92
    void setShift(const PartialPlace& shift);         ///< G52
    void dropShift(bool keep);                        ///< G92.1, or G92.2 that keeps it for G92.3
    void restoreShift() { shift_ = keptShift_; }      ///< G92.3

    /// A place of the machine frame in that of the work offset; nothing where an offset between them is not known.
    std::optional<double> fromMachine(Axis axis, double value) const;
    std::optional<double> inMachine(Axis axis) const; ///< where the axis stands
    const PartialPlace& home(std::size_t which) const noexcept { return homes_[which]; }
    void storeHome(std::size_t which);

    /// One of the control's own parameters; nothing where it is not known. @param length mm of the unit in force
    std::optional<double> parameter(int number, double length, int tool) const;

private:
    std::optional<double> offsetOf(int number, Axis axis) const;
    /// The axis of a parameter, of a row that begins with X; nothing: none that programs move.
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/machine_state.h"

namespace burin {

/// Where the tool stands, in the frame of the work offset in force, as far as the text (and the machine) tell, and the
/// offsets between that frame, the machine's and the program's. Lengths in mm. One thread.
class Frames {
public:
    explicit Frames(const MachineState& start);

    const glm::dvec3& place() const noexcept { return place_; }
    const std::array<bool, 3>& known() const noexcept { return known_; }
    const glm::dvec3& shift() const noexcept { return shift_; }
    int workOffset() const noexcept { return workOffset_; }
    int lengthOffsetNumber() const noexcept { return lengthNumber_; }
    bool ownZero() const noexcept { return ownZero_; }

    void moveTo(const glm::dvec3& place, const std::array<bool, 3>& known) noexcept;
    /// A tool change: where it leaves the machine is the machine's own affair.
    void forgetPlace() noexcept { known_ = {false, false, false}; }

    void setWorkOffset(int number);
    /// G10 L2: zeros of an offset in the machine frame, of the axes given.
    void writeWorkOffset(int number, const PartialPlace& zero);
    /// G10 L20: zeros such that the tool stands at `here` in it.
    void writeWorkOffsetHere(int number, const PartialPlace& here);
    /// @param length nothing: not known
    void setLengthOffset(int number, std::optional<double> length) noexcept;
    std::optional<double> lengthOf(int number) const;

    void shiftSoThatHereIs(const PartialPlace& here) noexcept; ///< G92
    void setShift(const PartialPlace& shift) noexcept;         ///< G52
    void dropShift(bool keep) noexcept;                        ///< G92.1, or G92.2 that keeps it for G92.3
    void restoreShift() noexcept { shift_ = keptShift_; }      ///< G92.3

    /// A place of the machine frame in that of the work offset; nothing where an offset between them is not known.
    std::optional<double> fromMachine(int axis, double value) const;
    std::optional<double> inMachine(int axis) const; ///< where the tool stands
    const PartialPlace& home(std::size_t which) const noexcept { return homes_[which]; }
    void storeHome(std::size_t which);

    /// One of the control's own parameters; nothing where it is not known. @param length mm of the unit in force
    std::optional<double> parameter(int number, double length, int tool) const;

private:
    std::optional<double> offsetOf(int number, int axis) const;

    glm::dvec3 place_{0.0}, shift_{0.0}, keptShift_{0.0};
    std::array<bool, 3> known_{false, false, false};
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/axis.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>

namespace burin {

/// Positions of a machine's axes: mm, for A, B and C degrees, relative to a zero that the owner of the object defines.
/// It does not say which axes a machine has. A value type: copies are independent. X, Y and Z are stored in the object;
/// the six other axes are allocated separately as soon as one of them is not 0, because a program holds millions of
/// these objects and seldom has more than three axes.
class AxisValues {
public:
    AxisValues() noexcept = default;
    AxisValues(double x, double y, double z) noexcept : linear_(x, y, z) {}
    /// @param linear X, Y, Z, mm
    explicit AxisValues(const glm::dvec3& linear) noexcept : linear_(linear) {}

    AxisValues(const AxisValues& other) : linear_(other.linear_) {
        if (other.further_) further_ = std::make_unique<Further>(*other.further_);
    }
    AxisValues& operator=(const AxisValues& other) {
        if (other.further_ || further_)
            further_ = other.further_ ? std::make_unique<Further>(*other.further_) : nullptr;
        linear_ = other.linear_;
        return *this;
    }
    AxisValues(AxisValues&&) noexcept = default;
    AxisValues& operator=(AxisValues&&) noexcept = default;
    ~AxisValues() = default;

    double operator[](Axis axis) const noexcept {
        if (!isFurther(axis)) return linear_[static_cast<int>(axis)];
        return further_ ? (*further_)[placeOf(axis)] : 0.0;
    }
    void set(Axis axis, double value) {
        if (!isFurther(axis)) {
            linear_[static_cast<int>(axis)] = value;
        } else if (further_ || value != 0.0) {
            if (!further_) further_ = std::make_unique<Further>();
            (*further_)[placeOf(axis)] = value;
        }
    }

    const glm::dvec3& linear() const noexcept { return linear_; } ///< X, Y, Z, mm
    void setLinear(const glm::dvec3& linear) noexcept { linear_ = linear; }
    /// Whether all axes except X, Y and Z are at their zero.
    bool onlyLinear() const noexcept { return !further_ || *further_ == Further{}; }

    friend bool operator==(const AxisValues& a, const AxisValues& b) noexcept {
        if (a.linear_ != b.linear_) return false;
        return a.further_ && b.further_ ? *a.further_ == *b.further_ : a.onlyLinear() && b.onlyLinear();
    }
    /// Adds axis by axis.
    friend AxisValues operator+(AxisValues a, const AxisValues& b) {
        a.linear_ += b.linear_;
        for (std::size_t i = 3; b.further_ && i < axisCount; ++i) {
            const auto axis = static_cast<Axis>(i);
            a.set(axis, a[axis] + b[axis]);
        }
        return a;
    }

private:
    using Further = std::array<double, axisCount - 3>; // A B C U V W
    static constexpr bool isFurther(Axis axis) noexcept { return static_cast<std::size_t>(axis) >= 3; }
    static constexpr std::size_t placeOf(Axis axis) noexcept { return static_cast<std::size_t>(axis) - 3; }

    glm::dvec3 linear_{0.0};
    std::unique_ptr<Further> further_; // null or all zeros if none of these axes is off its zero
};

/// Linear interpolation between two positions, axis by axis. @param share 0: `from`, 1: `to`
inline AxisValues between(const AxisValues& from, const AxisValues& to, double share) {
    AxisValues values(glm::mix(from.linear(), to.linear(), share));
    for (std::size_t i = 3; !(from.onlyLinear() && to.onlyLinear()) && i < axisCount; ++i) {
        const auto axis = static_cast<Axis>(i);
        values.set(axis, glm::mix(from[axis], to[axis], share));
    }
    return values;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// Axes of a machine, with the names that programs use (ISO 841), in the order in which controls number them.
enum class Axis : std::uint8_t { x, y, z, a, b, c, u, v, w };
inline constexpr std::size_t axisCount = 9;
inline constexpr std::string_view axisLetters = "XYZABCUVW"; ///< in the order of Axis

constexpr char letterOf(Axis axis) noexcept {
    return axisLetters[static_cast<std::size_t>(axis)];
}
/// The axis with this letter, upper case; empty if there is none.
constexpr std::optional<Axis> axisOfLetter(char letter) noexcept {
    const std::size_t place = axisLetters.find(letter);
    return place == std::string_view::npos ? std::nullopt : std::optional(static_cast<Axis>(place));
}
/// Whether an axis is rotary, so that its values are degrees rather than mm.
constexpr bool isRotary(Axis axis) noexcept {
    return axis == Axis::a || axis == Axis::b || axis == Axis::c;
}
/// X, Y or Z. @param component 0, 1 or 2, as GLM counts
constexpr Axis linearAxis(int component) noexcept {
    return static_cast<Axis>(component);
}

/// A set of axes. Its iterator visits them in the order of Axis.
class AxisSet {
public:
    class Iterator {
    public:
        explicit constexpr Iterator(std::uint16_t left) noexcept : left_(left) {}
        constexpr Axis operator*() const noexcept { return static_cast<Axis>(std::countr_zero(left_)); }
        constexpr Iterator& operator++() noexcept {
            left_ = static_cast<std::uint16_t>(left_ & (left_ - 1));
            return *this;
        }
        friend constexpr bool operator==(Iterator, Iterator) noexcept = default;

    private:
        std::uint16_t left_; // axes that are still to be visited
    };

    constexpr AxisSet() noexcept = default;
    template <class... Axes>
    explicit constexpr AxisSet(Axis first, Axes... others) noexcept
        : bits_(static_cast<std::uint16_t>((bitOf(first) | ... | bitOf(others)))) {}

    constexpr bool has(Axis axis) const noexcept { return (bits_ & bitOf(axis)) != 0; }
    constexpr bool hasAll(AxisSet axes) const noexcept { return (bits_ & axes.bits_) == axes.bits_; }
    constexpr bool empty() const noexcept { return bits_ == 0; }
    constexpr void set(Axis axis, bool member = true) noexcept {
        bits_ = static_cast<std::uint16_t>(member ? bits_ | bitOf(axis) : bits_ & ~bitOf(axis));
    }
    constexpr Iterator begin() const noexcept { return Iterator(bits_); }
    constexpr Iterator end() const noexcept { return Iterator(0); }

    friend constexpr AxisSet operator|(AxisSet a, AxisSet b) noexcept {
        a.bits_ = static_cast<std::uint16_t>(a.bits_ | b.bits_);
        return a;
    }
    friend constexpr bool operator==(AxisSet, AxisSet) noexcept = default;

private:
    static constexpr unsigned bitOf(Axis axis) noexcept { return 1U << static_cast<unsigned>(axis); }

    std::uint16_t bits_ = 0;
};

inline constexpr AxisSet linearAxes(Axis::x, Axis::y, Axis::z);
inline constexpr AxisSet allAxes(Axis::x, Axis::y, Axis::z, Axis::a, Axis::b, Axis::c, Axis::u, Axis::v, Axis::w);

/// One value for each axis.
template <class T>
struct ByAxis {
    std::array<T, axisCount> values{}; ///< in the order of Axis

    constexpr T& operator[](Axis axis) noexcept { return values[static_cast<std::size_t>(axis)]; }
    constexpr const T& operator[](Axis axis) const noexcept { return values[static_cast<std::size_t>(axis)]; }
    friend bool operator==(const ByAxis&, const ByAxis&) = default;
};

} // namespace burin

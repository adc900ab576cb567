// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/controls.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::spacenav {

/// Adds what spacenavd sends to controls: packets of eight 32-bit numbers of the machine's own order, which a stream
/// may hand over in pieces. 0: motion (three displacements, three rotations, x right, y up, z away from the user, full
/// scale 500); 1 and 2: a button, by its number, goes down and up; others are none of ours.
/// One thread; no allocation, no exception.
/// Source: spacenavd (proto_unix.c) and libspnav (util.c), which take z with the other sign than x and y.
class EventReader {
public:
    enum class Kind : std::uint8_t { none, motion, button };
    static constexpr std::size_t packetSize = 32; ///< bytes
    static constexpr int fullScale = 500;

    /// Takes as many bytes as the packet under way still lacks. @return what it was, where it is complete
    /// @param[in,out] bytes those that are taken are taken off
    Kind take(std::span<const std::uint8_t>& bytes) noexcept;
    const cap::Controls& controls() const noexcept { return controls_; }
    void reset() noexcept { *this = EventReader(); }

private:
    Kind read() noexcept;

    std::array<std::uint8_t, packetSize> packet_{};
    std::size_t filled_ = 0;
    cap::Controls controls_;
};

} // namespace burin::spacenav

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/controls.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::spacenav {

/// Applies the messages of spacenavd to the controls: packets of eight 32-bit numbers in native byte order, which a
/// stream may deliver in pieces. 0: motion (three displacements, three rotations, x right, y up, z away from the user,
/// full scale 500); 1 and 2: the button with a given number is pressed and released; other packets are ignored.
/// One thread; no allocation, no exception.
/// Source: spacenavd (proto_unix.c) and libspnav (util.c), which use the opposite sign for z than for x and y.
class EventReader {
public:
    enum class Kind : std::uint8_t { none, motion, button };
    static constexpr std::size_t packetSize = 32; ///< bytes
    static constexpr int fullScale = 500;

    /// Takes the bytes that complete the current packet, as far as they are available. @return the kind of the packet
    /// if it is complete
    /// @param[in,out] bytes the bytes taken are removed
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace burin::spacemouse {

/// A 3D mouse of 3Dconnexion (formerly Logitech), identified by its vendor and product numbers.
struct Model {
    std::uint16_t vendor = 0, product = 0;
    const char* name = "";
    int buttons = 0;       ///< highest button number that it may report
    bool wireless = false; ///< has a battery that it may report
};

/// The model with these numbers; null for an unknown device.
const Model* modelOf(std::uint16_t vendor, std::uint16_t product) noexcept;

/// Whether an interface belongs to a 3D mouse: a multi-axis controller (usage page 1, usage 8) of the vendors, known or
/// not, except for their mice and keyboards. If the usage is not known (0), only known models count.
bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage) noexcept;

} // namespace burin::spacemouse

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <string>

namespace burin::benchmarks {

/// Four slots, each milled in three passes with a flat end mill into a plate, and their volume in closed form. None of
/// its points is on the border of a voxel. Owns all of it; must not be moved.
struct SlotPlate {
    SlotPlate();
    SlotPlate(const SlotPlate&) = delete;
    SlotPlate& operator=(const SlotPlate&) = delete;

    static constexpr double radius = 3.0, length = 43.3, depth = 4.27; ///< mm
    static constexpr int slots = 4, passes = 3;

    std::string text;    ///< the program
    double volume = 0.0; ///< mm³ of the slots
    Model model;         ///< a thin plate under the slots
    MeshDistance part;
    VerifyRequest request; ///< without a program
};

} // namespace burin::benchmarks

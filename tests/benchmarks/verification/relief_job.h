// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <string>

namespace burin::benchmarks {

/// A block whose top is a relief, its stock, and a finishing program for it with a ball end mill, rows along x.
struct ReliefJob {
    double side = 92.4;      ///< mm, of the part, square; 5 mm of stock all around
    double base = 11.5;      ///< mm, mean height of the relief above the part's underside
    double overTop = 0.0;    ///< mm of stock above the highest point
    double below = 0.0;      ///< mm of stock below the part
    double voxel = 0.2;      ///< mm
    int rows = 138;          ///< of the program
    int movesPerRow = 120;   ///< including the one to the next row
    int meshCells = 256;     ///< along each side: chordal deviation below 0.005 mm
    double toolRadius = 3.0; ///< mm
};

/// What verification needs of a job. Owns all of it; must not be moved once a request has been made from it.
struct ReliefScene {
    explicit ReliefScene(const ReliefJob& job);
    ReliefScene(const ReliefScene&) = delete;
    ReliefScene& operator=(const ReliefScene&) = delete;

    std::string text; ///< the program
    Model model;
    MeshDistance part;
    VerifyRequest request; ///< without a program
};

} // namespace burin::benchmarks

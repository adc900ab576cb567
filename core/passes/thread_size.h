// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <string_view>

namespace burin {

/// A thread of 60° by its two determining sizes.
struct ThreadSize {
    std::string_view name; ///< "M8"; empty if it is not one of the table
    double diameter = 0.0; ///< mm, major (D)
    double pitch = 0.0;    ///< mm (P)

    friend bool operator==(const ThreadSize&, const ThreadSize&) = default;
};

/// The usual metric threads of coarse pitch from M3 to M24, by diameter (ISO 261:1998).
extern const std::array<ThreadSize, 14> coarseThreads;

/// The size of a designation: "M8" (coarse pitch) or "M8x1" (diameter and pitch). Errors: nameUnknown (detail: what is
/// known).
Result<ThreadSize> threadSizeNamed(std::string_view designation);

/// Depth of the basic profile of an internal thread between minor and major diameter, mm: 5/8 H with H = √3/2 P (ISO
/// 68-1:1998).
double threadDepth(double pitch) noexcept;
/// The minor diameter of an internal thread, mm: the diameter of its core hole, D1 = D - 2 · 5/8 H (ISO 724:1993).
double minorDiameter(const ThreadSize& size) noexcept;

/// Depth of an external thread of 60° between its major diameter and a root with a flat, mm, where its flanks have the
/// basic pitch diameter: the crest lies H/8 inside of the sharp profile, a flat w its √3/2 w (ISO 68-1:1998). With the
/// flat of P/4 of the basic profile 5/8 H, with the P/8 of a tooth for internal threads 3/4 H.
double externalDepth(double pitch, double flat) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// mm: the search for the end of the stock stops here, because such stock was never touched. An excess of this value
/// means "at least".
inline constexpr double longestExcess = 20.0;

/// Which of the points with stock over them the tools reach, batch by batch of points: it depends on the part, the
/// tools and these points alone.
struct KeptReach {
    struct Batch {
        std::vector<std::uint32_t> covered; ///< numbers of the points that face a cutter and are not bare
        std::vector<std::uint8_t> reached;  ///< for each of them
    };
    std::vector<Batch> batches;

    std::size_t bytes() const noexcept;
};

/// Measures how much stock a workpiece leaves over the part, at points about a voxel apart over the surface of the
/// part: the distance along the outward normal to the end of the stock, at most `longestExcess`. A point is reachable
/// if it faces upwards or sideways and is bare, or if the cutter can touch it from above (tip not below the part's
/// lowest point) without entering the part elsewhere.
/// @param tools the tools of the program: a point is reachable if one of them can touch it
/// @param kept of measurements with the same part and tools, or empty; the result does not depend on it
/// Errors: cancelled.
Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, KeptReach& kept, Progress& progress);
/// The same, measured for the first time.
Result<std::vector<DeviationSample>> measureExcess(const RunVolume& workpiece, const VerifyRequest& request,
                                                   std::span<const Tool> tools, Progress& progress);

/// Statistics of the excess over all reachable samples.
struct ExcessSummary {
    double mean = 0.0, most = 0.0; ///< mm; 0 if nothing is reachable
    double reachableShare = 0.0;   ///< of the samples, 0 … 1
};
ExcessSummary summaryOf(std::span<const DeviationSample> samples) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace burin {

/// How a place of the part came out.
enum class DeviationBand : std::uint8_t {
    gouge,       ///< deeper in the part than allowed
    inTolerance, ///< within the tolerance of the allowance
    excess,      ///< more stock than that
    unreachable, ///< no tool of the program can touch the part there: what is left is not its fault
};
/// Stable id of a band: "gouge", "in_tolerance", "excess", "unreachable".
const char* idOf(DeviationBand band);

/// Where the bands end, mm, signed along the outward normal.
struct DeviationTolerance {
    double gouge = 0.02;    ///< deviation below -gouge is a gouge
    double excess = 0.1;    ///< beyond allowance + excess there is too much
    double allowance = 0.0; ///< that is meant to stay

    friend bool operator==(const DeviationTolerance&, const DeviationTolerance&) = default;
};

/// mm: stock that is left, or what is missing as a negative number.
double deviationOf(const DeviationSample& sample) noexcept;
DeviationBand bandOf(const DeviationSample& sample, const DeviationTolerance& tolerance) noexcept;

/// Samples over a part that can be asked for by place: the number under the cursor. Keeps a reference to the samples.
class DeviationMap {
public:
    /// @param cell mm, about as far as samples are apart, > 0
    DeviationMap(const std::vector<DeviationSample>& samples, double cell);

    /// Place among the samples of the one nearest to a place, mm, setup frame; nothing where none is within `reach` mm.
    /// Cost: the samples in the cells that far around.
    std::optional<std::size_t> nearest(const glm::dvec3& place, double reach) const;
    /// What the samples around a point of the part say of it: the deepest gouge that is marked nearer than a cell, else
    /// their mean, the nearer the more. Those of other faces, farther from the tangent plane, count little.
    /// @param place mm, setup frame, on the part; @param normal of the part there, unit
    /// Nothing where no sample is within 2.5 cells. `reachable`: of most of them.
    std::optional<DeviationSample> at(const glm::dvec3& place, const glm::dvec3& normal) const;
    /// Area shares, by samples, of each band.
    struct Shares {
        double gouge = 0.0, inTolerance = 0.0, excess = 0.0, unreachable = 0.0; ///< 0 … 1, together 1 or all 0
    };
    Shares shares(const DeviationTolerance& tolerance) const;

private:
    using Cell = std::uint64_t;
    Cell cellOf(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept;
    /// Calls `visit(number of the sample)` for those in all cells within `reach` mm along each axis.
    template <class Visit>
    void forEachNear(const glm::dvec3& place, double reach, const Visit& visit) const;
    std::optional<DeviationSample> meanAt(const glm::dvec3& place, const glm::dvec3& normal) const;

    const std::vector<DeviationSample>& samples_;
    double cell_;
    std::unordered_map<Cell, std::vector<std::uint32_t>> cells_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace burin {

/// The result of the machining at a point of the part.
enum class DeviationBand : std::uint8_t {
    gouge,       ///< deeper in the part than allowed
    inTolerance, ///< within the tolerance of the allowance
    excess,      ///< more stock than that allows
    unreachable, ///< no tool of the program can touch the part there, so the program is not at fault for the stock left
};
/// Stable id of a band: "gouge", "in_tolerance", "excess", "unreachable".
const char* idOf(DeviationBand band);

/// The limits of the bands, mm, signed along the outward normal.
struct DeviationTolerance {
    double gouge = 0.02;    ///< deviation below -gouge is a gouge
    double excess = 0.1;    ///< deviation above allowance + excess is too much stock
    double allowance = 0.0; ///< stock that is meant to stay

    friend bool operator==(const DeviationTolerance&, const DeviationTolerance&) = default;
};

/// Stock that is left, mm; negative where material is missing.
double deviationOf(const DeviationSample& sample) noexcept;
DeviationBand bandOf(const DeviationSample& sample, const DeviationTolerance& tolerance) noexcept;

/// Samples over a part that can be looked up by position, e.g. for the value under the cursor. Keeps a reference to the
/// samples.
class DeviationMap {
public:
    /// @param cell mm, about the distance between samples, > 0
    DeviationMap(const std::vector<DeviationSample>& samples, double cell);

    /// The index of the sample nearest to a point, mm, setup frame; empty if none is within `reach` mm. Cost: the
    /// samples in the cells within that distance.
    std::optional<std::size_t> nearest(const glm::dvec3& place, double reach) const;
    /// The deviation at a point of the part, from the samples around it: the deepest gouge marked within a cell,
    /// otherwise their mean, weighted by proximity. Samples of other faces, which are farther from the tangent plane,
    /// count little.
    /// @param place mm, setup frame, on the part @param normal of the part there, unit vector
    /// @return empty if no sample is within 2.5 cells; `reachable` is that of most samples
    std::optional<DeviationSample> at(const glm::dvec3& place, const glm::dvec3& normal) const;
    /// Shares of the area in each band, estimated by the number of samples.
    struct Shares {
        double gouge = 0.0, inTolerance = 0.0, excess = 0.0, unreachable = 0.0; ///< 0 … 1, together 1 or all 0
        double& of(DeviationBand band) noexcept;
    };
    Shares shares(const DeviationTolerance& tolerance) const;

private:
    using Cell = std::uint64_t;
    Cell cellOf(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept;
    /// Calls `visit(index of the sample)` for those in all cells within `reach` mm along each axis.
    template <class Visit>
    void forEachNear(const glm::dvec3& place, double reach, const Visit& visit) const;
    std::optional<DeviationSample> meanAt(const glm::dvec3& place, const glm::dvec3& normal) const;

    const std::vector<DeviationSample>& samples_;
    double cell_;
    std::unordered_map<Cell, std::vector<std::uint32_t>> cells_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/met_material.h"
#include "core/recording/sample.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

/// A cut as displayed and as used for feed proposals: smoothed, with all materials that were cut.
struct SmoothedCut {
    double area = 0.0;    ///< mm², of the cut, perpendicular to the motion; 0: nothing is cut
    double surface = 0.0; ///< mm², of the flutes' surface that is engaged
    double arc = 0.0;     ///< rad, as in Engagement
    double depth = 0.0;   ///< mm, as in Engagement
    double energy = 0.0;  ///< J/mm³, of the mixture of materials
    /// Indices of the workpiece's properties, each once; the rest is air.
    std::array<std::uint8_t, 8> materials{};

    bool cuts() const noexcept { return area > 0.0; }
};

/// Tracks the engagement of the flutes from tick to tick. Does not allocate or block. Call on the loop's thread.
class RecentCut {
public:
    /// @param period s
    void add(const Sample& sample, const MetMaterial& met, double period) noexcept {
        time_ += period;
        for (const RemovedMaterial& removed : sample.removed)
            if (removed.units > 0) note(removed.property);
        if (!(met.area > leastArea) || !(met.engagement.area > 0.0)) {
            newest_ = {};
            age_ = 0.0;
            return;
        }
        const double share = newest_.cuts() ? 1.0 - std::exp(-period / smoothing) : 1.0;
        const auto follow = [share](double& value, double now) { value += share * (now - value); };
        follow(newest_.area, met.area);
        follow(newest_.surface, met.engagement.area);
        follow(newest_.arc, met.engagement.arc);
        follow(newest_.depth, met.engagement.depth);
        follow(newest_.energy, met.energy);
        listMaterials();
        age_ += period;
        if (age_ >= settled && newest_.area * newest_.energy > heaviest_.area * heaviest_.energy) heaviest_ = newest_;
    }
    void beginTake() noexcept { heaviest_ = {}; }
    const SmoothedCut& newest() const noexcept { return newest_; }
    /// Returns the cut of the take with the most energy per millimetre of tool motion. Cuts of less than 0.1 s are
    /// ignored.
    const SmoothedCut& heaviest() const noexcept { return heaviest_; }

private:
    static constexpr double leastArea = 1e-3; ///< mm²
    static constexpr double smoothing = 0.05; ///< s
    static constexpr double settled = 0.1;    ///< s, shortest cut that counts
    static constexpr double window = 0.1;     ///< s, for which a material is listed

    struct Seen {
        std::uint8_t property = 0;
        double time = 0.0;
    };
    void note(std::uint8_t property) noexcept {
        Seen* oldest = &seen_.front();
        for (Seen& seen : seen_) {
            if (seen.property == property) {
                seen.time = time_;
                return;
            }
            if (seen.property == 0 || (oldest->property != 0 && seen.time < oldest->time)) oldest = &seen;
        }
        *oldest = {property, time_};
    }
    /// Lists the recent materials. A tool that rests in a cut keeps the last ones.
    void listMaterials() noexcept {
        std::array<std::uint8_t, 8> recent{};
        auto* next = recent.begin();
        for (const Seen& seen : seen_)
            if (seen.property != 0 && time_ - seen.time <= window) *next++ = seen.property;
        if (recent.front() != 0) newest_.materials = recent;
    }

    SmoothedCut newest_, heaviest_;
    std::array<Seen, 8> seen_{};
    double time_ = 0.0, age_ = 0.0; ///< s
};

} // namespace burin

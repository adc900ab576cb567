// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/brick_field.h"
#include "core/field/field_builder.h"
#include "core/field/part_sample.h"
#include "core/field/tip_asker.h"

#include <optional>

namespace burin {

/// Fills the fine bricks of a tool's field. Where the corners of a brick say that the clearance is smooth, and its middle
/// agrees, its samples follow from them by cubics (Hermite). Elsewhere samples 4 apart are asked of the part, with their
/// gradients, and where lines between these are not smooth either, every second sample; what lies between those follows
/// from its own lines, or is asked.
class BrickSampler {
public:
    /// @param fine numbers of the fine bricks, in the order of their samples
    /// @param corners  of the bricks, mm, with their gradients
    BrickSampler(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                 BrickField& field, const std::vector<std::uint32_t>& fine, const std::vector<PartSample>& corners);

    /// Parallel, reported between the fractions.
    void fill(Progress& progress, double from, double to);

private:
    /// Samples of a level that a brick owns: all but those on its upper faces.
    struct Level {
        int step;                       ///< cells between them
        std::vector<std::int32_t> place; ///< per fine brick, where its samples are, or none
        std::vector<PartSample> samples;
        int along() const noexcept { return BrickField::cells / step; } ///< owned, along an axis
        std::size_t owned() const noexcept { return static_cast<std::size_t>(along() * along() * along()); }
        void lay(const std::vector<std::uint8_t>& wanted);
    };
    static constexpr std::int32_t none = -1;

    TipAsker asker() const;
    glm::dvec3 place(std::size_t order, const glm::ivec3& sample) const noexcept;
    bool fillFromCorners(std::size_t order, TipAsker& ask, SampleGrid& nine);
    void own(std::size_t order, Level& level, const Level* coarser, TipAsker& ask) const;
    bool fillFromFours(std::size_t order, TipAsker& ask, SampleGrid& nine);
    void fillFromTwos(std::size_t order, TipAsker& ask);
    void gather(std::size_t order, const Level& level, TipAsker& ask, SampleGrid& all) const;
    bool isSmooth(const LineCheck& check, float mostBend) const noexcept;
    std::optional<double> between(const SampleGrid& twos, const glm::ivec3& sample) const noexcept;
    void pack(std::size_t order, const SampleGrid& nine);
    std::int16_t packed(double value) const noexcept;

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    const FieldResolution resolution_;
    BrickField& field_;
    const std::vector<std::uint32_t>& fine_;
    const std::vector<PartSample>& corners_;
    const double deep_; ///< mm: clearances below only have to lead out
    Level fours_{4, {}, {}}, twos_{2, {}, {}};
};

} // namespace burin

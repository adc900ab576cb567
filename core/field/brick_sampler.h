// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/brick_field.h"
#include "core/field/field_builder.h"
#include "core/field/sample_grid.h"
#include "core/field/tip_asker.h"

#include <optional>

namespace burin {

/// Fills the fine bricks of a tool's field. If the clearance is smooth according to the corners of a brick, and its
/// middle agrees, its samples are computed from the corners by cubics (Hermite). Otherwise samples 4 apart are
/// evaluated with the part, with their gradients, and where lines between these are not smooth either, every second
/// sample; the samples between those follow from their own lines, or are evaluated as well.
class BrickSampler {
public:
    /// @param fine     numbers of the fine bricks, in the order of their samples
    /// @param corners  of the bricks, mm, with their gradients
    BrickSampler(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                 BrickField& field, const std::vector<std::uint32_t>& fine, const std::vector<TipSample>& corners);

    /// Memory of the sampler and the field for a fine brick, if none of them is smooth.
    static constexpr std::size_t bytesPerBrick() noexcept {
        return BrickField::samplesPerBrick * sizeof(std::int16_t) + sizeof(float) + (8 + 64) * sizeof(TipSample);
    }

    /// Parallel; reports progress between the two fractions.
    void fill(Progress& progress, double from, double to);

private:
    /// Samples of a level that belong to a brick: all but those on its upper faces.
    struct Level {
        int step;                        ///< cells between them
        std::vector<std::int32_t> place; ///< per fine brick, index of its samples, or none
        std::vector<TipSample> samples;
        int along() const noexcept { return BrickField::cells / step; } ///< own samples along an axis
        std::size_t owned() const noexcept { return static_cast<std::size_t>(along() * along() * along()); }
        void lay(const std::vector<std::uint8_t>& wanted);
    };
    static constexpr std::int32_t none = -1;

    /// A brick's samples of a level, straightened, and their gains.
    struct Grid {
        explicit Grid(int along) : samples(along), gains(samples.values[0].size()) {}
        SampleGrid samples;
        std::vector<float> gains;
        void set(const glm::ivec3& at, const TipSample& sample) noexcept {
            const std::size_t place = samples.at(at.x, at.y, at.z);
            samples.set(place, sample.straightened());
            gains[place] = sample.gain;
        }
        /// Interpolated between the grid's gains. @param share  position in the brick, along each axis
        float gainAt(const glm::vec3& share) const noexcept;
    };
    /// Working storage. One per thread.
    struct Grids {
        Grid two{2}, three{3}, five{5};
        SampleGrid middle{3}, fine{5}, nine{9};
    };

    TipAsker asker() const;
    glm::dvec3 place(std::size_t order, const glm::ivec3& sample) const noexcept;
    bool fillFromCorners(std::size_t order, TipAsker& ask, Grids& grids);
    void own(std::size_t order, Level& level, const Level* coarser, TipAsker& ask) const;
    bool fillFromFours(std::size_t order, TipAsker& ask, Grids& grids);
    void fillFromTwos(std::size_t order, TipAsker& ask, Grids& grids);
    void gather(std::size_t order, const Level& level, TipAsker& ask, Grid& all) const;
    bool isSmooth(const LineCheck& check, float mostBend) const noexcept;
    /// Value that is known without evaluating the part, and its possible error, mm.
    struct Between {
        double value, error;
    };
    std::optional<Between> between(const Grid& twos, const glm::ivec3& sample) const noexcept;
    void pack(std::size_t order, const Grid& gains, const SampleGrid& nine, double lineError);
    double gainError(double straightened, float least, float most) const noexcept;
    void bound(std::size_t order, double sampleError) noexcept;
    std::int16_t packed(double value) const noexcept;

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    const FieldResolution resolution_;
    BrickField& field_;
    const std::vector<std::uint32_t>& fine_;
    const std::vector<TipSample>& corners_;
    const double deep_; ///< mm: clearances below this only have to lead outwards
    Level fours_{4, {}, {}}, twos_{2, {}, {}};
};

} // namespace burin

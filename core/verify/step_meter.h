// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// What the flutes met of one material in one of the equal steps that a move is divided into. n: outward normal of the
/// flutes at the contact; t: direction in which a tooth moves there with a clockwise spindle; r: distance from the
/// tool's axis; d: direction of the move. Sums over the surface that met material, averaged over the step. Setup frame.
struct StepCut {
    std::uint32_t move = 0;
    std::uint32_t step = 0;  ///< from 0 to `steps` - 1
    std::uint32_t steps = 1; ///< of the move
    PropertyIndex material = airProperty;
    float volume = 0.0F;      ///< mm³
    float surface = 0.0F;     ///< mm²
    float bottom = 0.0F;      ///< mm above the tip, of the material met
    float top = 0.0F;         ///< mm above the tip
    glm::vec3 place{0.0F};    ///< mm, centroid of the material removed
    glm::vec3 tangentChip{0}; ///< mm: sum of t (n · d) / r
    glm::vec3 tangentEdge{0}; ///< mm: sum of t / r
    glm::vec3 normalChip{0};  ///< mm: sum of n (n · d) / r
    glm::vec3 normalEdge{0};  ///< mm: sum of n / r

    /// Adds what another row of bricks met in the same step.
    void add(const StepCut& other) noexcept;
};

/// Determines when on a move, and where on the flutes, each piece of a removed run was met: at the first point of the
/// move at which the flutes contain it. This is exact because the pieces of a tool are convex; of hollow flutes, the
/// edges of their section are met one by one. Not thread-safe.
class StepMeter {
public:
    explicit StepMeter(const RunVolume& workpiece);

    /// @param flutes, section must outlive the move @param section ToolSolid::section of hollow flutes, oriented, or
    /// empty
    /// @param from, to tips, mm, line frame @param axis of the tool, line frame
    void begin(std::uint32_t move, std::span<const RevolvedPiece> flutes, const PlanRegion& section,
               const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis);
    /// Adds an interval that the move removed from what the workpiece held there before all moves. @param low, high run
    /// units
    void add(LineIndex line, double low, double high);
    /// Appends what the steps of the move met, in their order, separately for each material.
    void finish(std::vector<StepCut>& cuts);

private:
    struct Met {
        double way = 0.0;      ///< mm along the move
        double height = 0.0;   ///< mm above the tip
        double radius = 0.0;   ///< mm from the axis
        glm::dvec3 outward{0}; ///< unit, away from the axis
        glm::dvec3 normal{0};  ///< unit, of the flutes, outwards
        double surface = 0.0;  ///< mm² of flutes for each mm² seen along the move
    };
    struct Sum {
        double volume = 0.0, surface = 0.0, bottom = 0.0, top = 0.0;
        glm::dvec3 moment{0.0}, tangentChip{0.0}, tangentEdge{0.0}, normalChip{0.0}, normalEdge{0.0};
    };
    void prepare();
    void addRun(LineIndex line, double low, double high);
    Met meet(const glm::dvec3& place) const;
    Met meetPieces(const glm::dvec3& place) const;
    std::optional<Met> meetSection(const glm::dvec3& place) const;
    Met metAt(const glm::dvec3& place, double way, const glm::dvec2& normal) const;
    double surfaceFor(const Met& met) const;
    void addSlice(const glm::dvec3& place, double volume, double halfHeight);
    void addTo(std::size_t step, const Met& met, const glm::dvec3& place, double volume, double halfHeight);

    const RunVolume* workpiece_;
    const Grid* grid_;
    std::vector<PropertyIndex> materials_;    ///< that can be milled
    std::array<std::uint8_t, 256> placeOf_{}; ///< index of each property among them; 0 for what can't be milled
    std::size_t material_ = 0;                ///< index of what is being added
    std::span<const RevolvedPiece> flutes_;
    const PlanRegion* section_ = nullptr; ///< null: the flutes are the pieces
    std::uint32_t move_ = 0;
    glm::dvec3 from_{0.0}, direction_{0.0}, axis_{0.0};
    double length_ = 0.0;     ///< mm
    double slice_ = 1.0;      ///< largest piece of a removed run that is treated as one, run units
    std::uint32_t steps_ = 0; ///< of the move; 0: it has removed nothing yet
    std::vector<Sum> sums_;   ///< by step, then by material; all zero except those touched
    std::vector<std::size_t> touched_;
};

/// Number of steps for which the load of a move is recorded: each of a voxel, or a 16th of the radius if that is more.
std::uint32_t loadStepsOf(double length, double edge, double radius) noexcept;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/touched_face.h"
#include "core/setup/setup.h"
#include "core/setup/stock_solid.h"

#include <memory>
#include <optional>

namespace burin {

/// A side of the stock that was touched.
struct TouchedSide {
    double coordinate = 0.0; ///< mm, along the axis of the face, setup frame
    /// mm: the largest distance of the stock itself from it. 0 for a plane side that is known exactly; the chord of its
    /// mesh for a curved one; half a voxel for a stock that is known by its voxels alone.
    double error = 0.0;
};

/// The stock before milling as a surface that holds the tool, for touching off: a box, the outside of a cylinder within
/// `cylinderChord`, the meshes of solids, and around a stock from a file a surface that is no farther than a voxel from
/// it. Immutable, thread-safe, cheap to copy.
class TouchableStock {
public:
    /// Costs little for a box or a cylinder; a search tree for solids; for a stock from a file it is unpacked, and its
    /// surface made (`isQuick`).
    /// @param model in the setup frame @param setup as placed by placeStock
    /// Errors: those of StockSolid::of, notSupported (a stock of solids without a surface), cancelled, outOfMemory.
    static Result<TouchableStock> of(const Model& model, const Setup& setup, Progress& progress);
    /// Whether it is made in a moment, whatever the size of the stock.
    static bool isQuick(const Setup& setup) noexcept { return setup.form != StockForm::file; }

    /// Never null.
    const std::shared_ptr<const MeshDistance>& surface() const noexcept { return surface_; }
    /// mm: where a tool starts that is led to the stock from any side
    const Box& box() const noexcept { return box_; }
    double voxel() const noexcept { return voxel_; } ///< mm

    /// Returns the side that a tool touches: that of the stock itself, without the error of the contact; of a cylinder
    /// its outermost line. Empty if the stock is not what holds the tool squarely there: a flank of a tilted cylinder,
    /// a fixture.
    /// @param face touched without an allowance, which the stock does not have
    std::optional<TouchedSide> sideTouched(const TouchedFace& face, const Tool& tool) const;

private:
    TouchableStock() = default;
    std::optional<TouchedSide> sideOfBox(const TouchedFace& face, double slack) const;
    std::optional<double> sideOfVoxels(const TouchedFace& face, const Tool& tool, const glm::dvec3& contact) const;
    double slack(const Tool& tool) const noexcept;

    StockForm form_ = StockForm::box;
    Box box_;
    double radius_ = 0.0, voxel_ = 0.0, chord_ = 0.0; ///< mm: of a cylinder; of its voxels; of the meshes of solids
    std::shared_ptr<const MeshDistance> surface_;
    StockSolid solid_; ///< of solids, or from a file
};

/// Moves an upright tool as a hand does until the stock holds it, and presses on by 1 mm. No session is needed.
/// The contact is found to Proxy::contactGap (0.001 mm).
/// @param tip start of the tip, mm, setup frame, clear of the stock @param towards unit
/// Errors: argumentInvalid (a tip in the stock, a direction that misses it).
Result<TouchedFace> touchStock(const TouchableStock& stock, const Tool& tool, const glm::dvec3& tip,
                               const glm::dvec3& towards);

} // namespace burin

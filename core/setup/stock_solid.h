// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"
#include "core/geometry/placement.h"
#include "core/volume/runs/run_volume.h"

#include <functional>
#include <memory>
#include <optional>

namespace burin {

struct Model;
struct Setup;

/// The stock before milling, as fixtures meet it: a box exactly; a cylinder as a prism in it that is nowhere farther
/// than `stockChord` from it; solids as their meshes; a stock from a file as its scanlines. Immutable, cheap to copy,
/// thread-safe.
class StockSolid {
public:
    StockSolid() = default; ///< empty
    // Not explicit: a box is a stock.
    StockSolid(const Box& box) : box_(box) {} // NOLINT(google-explicit-constructor)
    /// Allocates; unpacks a stock from a file. @param setup as placed by placeStock @param model in the setup frame
    /// Errors: those of StockVolume::unpack.
    static Result<StockSolid> of(const Model& model, const Setup& setup, Progress& progress);

    const Box& box() const noexcept { return box_; } ///< around it, mm, setup frame
    bool empty() const noexcept { return box_.empty(); }
    bool isBox() const noexcept { return !surface_ && !runs_; }
    /// Whether each question is answered within some milliseconds, so that it may be asked on the user interface's
    /// thread.
    bool isQuick() const noexcept;
    /// Of a cylinder and of solids, closed and oriented outwards where the bodies are; null for any other stock.
    const std::shared_ptr<const MeshDistance>& surface() const noexcept { return surface_; }
    const std::shared_ptr<const VolumeSnapshot>& runs() const noexcept { return runs_; } ///< from a file; else null

    /// Extent along an axis of the part of the stock that lies in a region, mm; empty if there is none. A voxel belongs
    /// to it as a whole.
    /// @param frame of the region in the setup frame @param region mm; unbounded along `axis` @param axis 0, 1, 2
    struct Extent {
        double low = 0.0, high = 0.0;
    };
    std::optional<Extent> extentIn(const Placement& frame, const Box& region, int axis) const;

    // Only for a stock that is no box:
    /// How deep the stock is in a convex solid, mm: the depth of its deepest point in the solid; 0: not at all. Voxels
    /// are judged by the centre lines of their runs, so by half a voxel too little at most.
    /// @param solid in its frame @param frame of it in the setup frame
    double depthInBox(const Box& solid, const Placement& frame) const;
    /// Likewise, for an upright cylinder; in a stock with a surface also the depth of an end of its axis in the stock,
    /// if that is greater. @param centre mm, setup frame
    double depthInCylinder(const glm::dvec2& centre, double radius, double low, double high) const;

    /// The first point of the stock on a ray, mm. @param direction of any length but 0
    std::optional<glm::dvec3> hit(const glm::dvec3& origin, const glm::dvec3& direction) const;

private:
    /// Depth of a point in a convex solid, mm; negative outside. Concave.
    using Depth = std::function<double(const glm::dvec3&)>;
    double depthOfRuns(const Box& around, const Depth& depth) const;

    Box box_;
    std::shared_ptr<const MeshDistance> surface_; ///< null: the box, or runs
    std::shared_ptr<RunVolume> volume_;           ///< owns what `runs_` shows
    std::shared_ptr<const VolumeSnapshot> runs_;  ///< of a stock from a file
};

inline constexpr double stockChord = 0.0005; ///< mm

} // namespace burin

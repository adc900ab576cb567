// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/place_table.h"
#include "core/volume/surface/surface.h"
#include "ui/scene/bare_rims.h"

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace burin {

/// Prepares a workpiece's surface for drawing together with the part's own mesh, which replaces bare part. Voxels
/// resolve the border between stock and bare part only to whole cells: the stock is straightened along the border and
/// continued beneath the part's surface, so that it visibly ends in a line where it meets the part, without a gap. One
/// object per thread.
class BareBorder {
public:
    /// Makes all triangles of another tile at the same level, not simplified.
    using OtherTile = std::function<void(SurfaceTile, SurfaceMesh&)>;

    /// Moves bare part one cell below its surface. Points on the border move along the surface, by less than half a
    /// cell; other points of the stock don't move. The border is continuous across tiles.
    /// @param mesh all triangles of a tile at a level, not simplified
    /// @param rims of the level's tiles
    void draw(const VolumeSnapshot& workpiece, SurfaceTile tile, int level, const OtherTile& other, BareRims& rims,
              SurfaceMesh& mesh);

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< two points, the lower index first
    struct Border {                                       ///< sum over points of the border
        glm::vec3 places{0.0F}, normals{0.0F};
        float count = 0.0F;
        void add(const glm::vec3& place, const glm::vec3& normal) {
            places += place;
            normals += normal;
            ++count;
        }
    };
    /// A point that is shared with other tiles.
    struct Shared {
        std::uint32_t point = 0;
        TileLimit limit;
        BareRims::Point drawn;
        bool known = false; ///< whether it is already known how it is drawn
    };
    struct BareShared {
        glm::vec3 place;
        TileLimit limit;
    };
    enum class Role : std::uint8_t { free, stays, known };

    bool markBare(const PropertyList& properties, const SurfaceMesh& mesh);
    void findShared(const TileLimits& limits, const BareRims& rims, float cell, const SurfaceMesh& mesh);
    void findBareShared(const SurfaceMesh& mesh, int axisOfRuns);
    bool isBareBeside(const Shared& shared, float reach) const;
    void addBeyond(const TileLimits& limits, float reach, const OtherTile& other, SurfaceMesh& mesh);
    void weld(const SurfaceMesh& mesh);
    void classify();
    void takeKnown(SurfaceMesh& mesh);
    void findBorder();
    void findNeighbours();
    void straighten(SurfaceMesh& mesh, int rounds, float cell);
    void continueStock(SurfaceMesh& mesh);
    void sink(SurfaceMesh& mesh, float cell) const;
    void keepShared(BareRims& rims, SurfaceMesh& mesh);
    void leadOn(SurfaceMesh& mesh, std::size_t point, float cell) const;

    PlaceTable table_;
    std::vector<std::uint32_t> placeOf_;  ///< of each point: the first one at its position, representing the others
    std::vector<std::uint32_t> corners_;  ///< of the triangles
    std::vector<std::uint8_t> bare_;      ///< of each point
    std::vector<std::uint8_t> triangles_; ///< of each triangle: bare part or stock
    std::vector<std::uint8_t> around_;    ///< of each point: the kinds of its triangles
    std::vector<Border> besideBorder_;    ///< of each point of bare part: its neighbours on the border
    std::vector<Edge> bareEdges_, stockEdges_, border_;
    std::vector<std::array<std::uint32_t, 2>> beside_; ///< of each point on the border: its neighbours along the border
    std::vector<std::uint8_t> besideCount_;
    std::vector<Shared> shared_;
    std::vector<BareShared> bareShared_; ///< sorted by their position along the runs
    int axisOfRuns_ = 2;
    std::vector<Role> roles_; ///< of each point
    SurfaceMesh beyond_;
    std::vector<std::uint32_t> moved_; ///< points of the border with exactly two neighbours
    std::vector<glm::vec3> from_, to_;
};

/// Removes bare part from a mesh.
/// @param mesh simplified: triangles of one material
/// @param rim  two points per edge; edges of bare part are removed as well
void leaveOutBarePart(SurfaceMesh& mesh, std::vector<std::uint32_t>& rim, const PropertyList& properties);

} // namespace burin

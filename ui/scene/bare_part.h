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

/// Prepares a workpiece's surface for being drawn together with the part's own mesh, which takes the place of bare
/// part. Voxels know the border between stock and bare part by whole cells: the stock is straightened along it and led
/// on beneath the part, so that it is seen to end in a line where it meets the part, without a gap. One object a
/// thread.
class BareBorder {
public:
    /// Makes all triangles of another tile at the same level, not simplified.
    using OtherTile = std::function<void(SurfaceTile, SurfaceMesh&)>;

    /// Lays bare part a cell beneath where it is. On the border points go along the surface, by less than half a cell;
    /// other points of the stock stay. The border leads from tile to tile as if there were none.
    /// @param mesh all triangles of a tile at a level, not simplified
    /// @param rims of the level's tiles
    void draw(const VolumeSnapshot& workpiece, SurfaceTile tile, int level, const OtherTile& other, BareRims& rims,
              SurfaceMesh& mesh);

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< two points, the lower first
    struct Border {                                       ///< points of it, summed up
        glm::vec3 places{0.0F}, normals{0.0F};
        float count = 0.0F;
        void add(const glm::vec3& place, const glm::vec3& normal) {
            places += place;
            normals += normal;
            ++count;
        }
    };
    /// A point that other tiles have as well.
    struct Shared {
        std::uint32_t point = 0;
        TileLimit limit;
        BareRims::Point drawn;
        bool known = false; ///< how it is drawn
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
    std::vector<std::uint32_t> placeOf_;  ///< of each point: the first one at the same place, for which the rest stands
    std::vector<std::uint32_t> corners_;  ///< of the triangles
    std::vector<std::uint8_t> bare_;      ///< of each point
    std::vector<std::uint8_t> triangles_; ///< of each triangle: what it is
    std::vector<std::uint8_t> around_;    ///< of each point: what its triangles are
    std::vector<Border> besideBorder_;    ///< of each point of bare part: what it has for neighbours
    std::vector<Edge> bareEdges_, stockEdges_, border_;
    std::vector<std::array<std::uint32_t, 2>> beside_; ///< of each point on the border: its neighbours there
    std::vector<std::uint8_t> besideCount_;
    std::vector<Shared> shared_;
    std::vector<BareShared> bareShared_; ///< by their place along the runs
    int axisOfRuns_ = 2;
    std::vector<Role> roles_; ///< of each point
    SurfaceMesh beyond_;
    std::vector<std::uint32_t> moved_; ///< points of the border between two others
    std::vector<glm::vec3> from_, to_;
};

/// Leaves out what is bare part.
/// @param mesh simplified: triangles of one material
/// @param rim  two points an edge; edges of bare part are left out alike
void leaveOutBarePart(SurfaceMesh& mesh, std::vector<std::uint32_t>& rim, const PropertyList& properties);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_net.h"

#include "core/volume/surface_faces.h"

#include <algorithm>

namespace burin {

namespace {

constexpr int margin = SurfaceWindow::margin, marginNodes = SurfaceWindow::marginNodes;
constexpr int firstCube = margin - 1; ///< column or row of the lowest cube that touches an owned node

/// Bits begin … end - 1.
constexpr std::uint64_t bitsBetween(int begin, int end) {
    return begin < end ? (std::uint64_t{1} << end) - (std::uint64_t{1} << begin) : 0;
}

/// Where a window's own edges begin, by column or row. The first tile also owns those that start beside the grid.
int firstOwned(int firstCell) {
    return firstCell < 0 ? firstCube : margin;
}

SurfaceCrossings::Owned ownedOf(const SurfaceWindow& window, const SurfaceBox& box) {
    const int first = marginNodes - box.nodes.first, end = std::min(first + window.owned, box.nodes.count - 1);
    SurfaceCrossings::Owned owned;
    owned.firstColumn = firstCube;
    owned.endColumn = box.columns.count - margin;
    owned.firstEdgeColumn = std::max(firstOwned(window.firstU) - box.columns.first, firstCube);
    owned.cubes = bitsBetween(std::max(first - 1, 0), end);
    owned.nodes = bitsBetween(std::max(first, 0), end);
    return owned;
}

SurfaceFrame frameOf(const SurfaceWindow& window, const SurfaceBox& box, const Grid& grid) {
    SurfaceFrame frame;
    frame.firstU = window.firstU + box.columns.first;
    frame.firstNode = window.firstNode + box.nodes.first;
    frame.axes = {grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    const double size = grid.edge() * window.cell();
    for (std::size_t i = 0; i < 3; ++i) frame.low[i] = static_cast<float>(grid.low()[frame.axes[i]] + 0.5 * size);
    frame.size = static_cast<float>(size);
    return frame;
}

template <class Element>
void makeRoom(std::vector<Element>& elements, std::size_t count) {
    if (elements.size() < count) elements.resize(count);
}

} // namespace

void SurfaceNet::start(SurfaceMesh& mesh) {
    mesh_ = &mesh;
    pointCount_ = cornerCount_ = 0;
}

void SurfaceNet::finish() {
    mesh_->points.resize(pointCount_);
    mesh_->normals.resize(pointCount_);
    mesh_->properties.resize(pointCount_);
    mesh_->triangles.resize(cornerCount_);
}

void SurfaceNet::add(const SurfaceWindow& window, const SurfaceLines& lines, const Grid& grid) {
    const SurfaceBox& box = lines.box();
    if (box.empty()) return;
    const SurfaceCrossings::Owned owned = ownedOf(window, box);
    field_.start(window, lines);
    frame_ = frameOf(window, box, grid);
    frame_.stride = field_.stride();
    for (int i = 0; i < box.rows.count; ++i) {
        field_.advance();
        const int row = field_.row();
        if (row < box.rows.first + firstCube) continue;
        crossings_.find(field_.rowPair(), field_.stride(), owned, row >= firstOwned(window.firstV));
        frame_.v = window.firstV + row;
        addPoints(row);
        addFaces(row);
    }
}

void SurfaceNet::addPoints(int row) {
    const std::span<const std::uint32_t> cubes = crossings_.cubes();
    if (cubes.empty()) return;
    std::uint32_t* const points = pointsOf(row).data();
    auto point = static_cast<std::uint32_t>(pointCount_);
    for (const std::uint32_t cube : cubes) points[SurfaceCrossings::placeOf(cube)] = point++;
    const std::size_t room = pointCount_ + cubes.size() + SurfaceFrame::spare;
    makeRoom(mesh_->points, room);
    makeRoom(mesh_->normals, room);
    placeSurfacePoints(frame_, field_.rowPair(), cubes, mesh_->points.data() + pointCount_,
                       mesh_->normals.data() + pointCount_);
    pointCount_ += cubes.size();
}

void SurfaceNet::addFaces(int row) {
    const std::uint32_t *here = pointsOf(row).data(), *before = pointsOf(row - 1).data();
    const int stride = field_.stride();
    const std::array<QuadrangleCorners, 3> corners{{{before - 1, here - 1, here, before},
                                                    {here - stride - 1, here - stride, here, here - 1},
                                                    {before - stride, before, here, here - stride}}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::span<const std::uint32_t> edges = crossings_.edges(axis);
        makeRoom(mesh_->triangles, cornerCount_ + 6 * edges.size());
        writeSurfaceFaces(edges, corners[axis], mesh_->points.data(), mesh_->triangles.data() + cornerCount_);
        cornerCount_ += 6 * edges.size();
    }
}

} // namespace burin

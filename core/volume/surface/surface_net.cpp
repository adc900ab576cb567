// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_net.h"

#include <algorithm>

namespace burin {

namespace {

constexpr int margin = SurfaceWindow::margin, marginNodes = SurfaceWindow::marginNodes;
constexpr int firstCube = margin - 1; ///< column or row of the lowest cube that touches an owned node

/// Bits begin … end - 1.
constexpr std::uint64_t bitsBetween(int begin, int end) {
    return begin < end ? (std::uint64_t{1} << end) - (std::uint64_t{1} << begin) : 0;
}

/// Where a window's own edges begin, by column or row. The first tile also owns those that start outside the grid.
int firstOwned(int firstCell) {
    return firstCell < 0 ? firstCube : margin;
}

SurfaceCubes::Owned ownedOf(const SurfaceWindow& window, const SurfaceBox& box) {
    const int first = marginNodes - box.nodes.first, end = std::min(first + window.owned, box.nodes.count - 1);
    return {firstCube, box.columns.count - margin, bitsBetween(std::max(first - 1, 0), end)};
}

SurfaceFrame frameOf(const SurfaceWindow& window, const SurfaceBox& box, int stride, const Grid& grid) {
    SurfaceFrame frame;
    frame.stride = stride;
    frame.placesPerRow = box.columns.count * stride;
    frame.firstU = window.firstU + box.columns.first;
    frame.firstV = window.firstV + box.rows.first;
    frame.firstNode = window.firstNode + box.nodes.first;
    frame.firstEdgeColumn = firstOwned(window.firstU) - box.columns.first;
    frame.firstEdgeRow = firstOwned(window.firstV) - box.rows.first;
    frame.firstEdgeNode = marginNodes - box.nodes.first;
    frame.axisOfRuns = grid.axisOfRuns();
    const std::array axes{grid.axisOfU(), grid.axisOfV(), grid.axisOfRuns()};
    const double size = grid.edge() * window.cell();
    for (std::size_t i = 0; i < 3; ++i) frame.low[i] = static_cast<float>(grid.low()[axes[i]] + 0.5 * size);
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
    const SurfaceCubes::Owned owned = ownedOf(window, box);
    field_.start(window, lines);
    frame_ = frameOf(window, box, field_.stride(), grid);
    for (int i = 0; i < box.rows.count; ++i) {
        field_.advance();
        const int row = field_.row() - box.rows.first;
        if (row < firstCube) continue;
        cubes_.find(field_.rowPair(), field_.stride(), owned);
        addCubes(row);
    }
    addBatch();
    writeFaces();
}

void SurfaceNet::addCubes(int row) {
    constexpr int rowsKept = SurfaceFrame::rowsKept;
    if (batch_.count() == 0) firstRow_ = row;
    if (row - firstRow_ == rowsKept - 1) { // the row before the batch's first is still needed
        addBatch();
        firstRow_ = row;
    }
    const int slot = row % rowsKept;
    std::uint32_t* const here = pointAt_.data() + placesBefore + slot * frame_.placesPerRow;
    const auto firstPoint = static_cast<std::uint32_t>(pointCount_ + batch_.count());
    if (slot == rowsKept - 1) {
        std::uint32_t* const again = pointAt_.data() + placesBefore - frame_.placesPerRow;
        auto point = firstPoint;
        for (const std::uint32_t cube : cubes_.listed()) again[SurfaceCubes::placeOf(cube)] = point++;
    }
    const SurfaceBatch::Row of{field_.rowPair(), static_cast<std::uint32_t>(row), frame_.stride};
    for (std::span<const std::uint32_t> cubes = cubes_.listed(); !cubes.empty();) {
        cubes = batch_.add(cubes, of, here, static_cast<std::uint32_t>(pointCount_ + batch_.count()));
        if (batch_.full()) addBatch();
    }
}

void SurfaceNet::addBatch() {
    if (batch_.count() == 0) return;
    const std::size_t room = pointCount_ + batch_.count() + SurfaceFrame::spare;
    makeRoom(mesh_->points, room);
    makeRoom(mesh_->normals, room);
    placeSurfacePoints(frame_, batch_, mesh_->points.data() + pointCount_, mesh_->normals.data() + pointCount_, edges_);
    pointCount_ += batch_.count();
    batch_.clear();
    addFaces();
}

void SurfaceNet::addFaces() {
    const std::uint32_t *here = pointAt_.data() + placesBefore, *before = here - frame_.placesPerRow;
    const int stride = frame_.stride;
    const std::array<QuadrangleCorners, 3> corners{{{before - 1, here - 1, here, before},
                                                    {here - stride - 1, here - stride, here, here - 1},
                                                    {before - stride, before, here, here - stride}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::span<const std::uint32_t> edges = edges_.listed(axis); !edges.empty();) {
            edges = faces_.lookUp(edges, corners[axis], mesh_->points.data());
            if (faces_.full()) writeFaces();
        }
}

void SurfaceNet::writeFaces() {
    const std::size_t written = faces_.cornerCount();
    makeRoom(mesh_->triangles, cornerCount_ + written + SurfaceFaces::spareCorners);
    faces_.write(mesh_->triangles.data() + cornerCount_);
    cornerCount_ += written;
}

} // namespace burin

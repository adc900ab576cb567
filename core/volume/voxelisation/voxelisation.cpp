// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/voxelisation.h"

#include "core/base/parallel_progress.h"
#include "core/volume/voxelisation/line_filling.h"
#include "core/volume/voxelisation/sorted_crossings.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>

namespace burin {

namespace {

/// A body, prepared for processing row by row.
struct PreparedBody {
    const TriangleMesh* mesh = nullptr; ///< closed
    PropertyIndex property = airProperty;
    std::unique_ptr<OpenMesh> open; ///< owns `mesh` if the caller's was open
    std::optional<SortedCrossings> crossings;
};

Result<void> sortCrossings(PreparedBody& body, const Grid& grid) {
    Result<std::vector<LatticeVertex>> vertices = projectVertices(*body.mesh, grid);
    if (!vertices) return vertices.error();
    const std::size_t firstCap = body.open ? body.open->firstCap() : body.mesh->triangles.size();
    body.crossings.emplace(*body.mesh, firstCap, grid, *std::move(vertices));
    return {};
}

Result<void> prepare(const BodyMesh& body, const Grid& grid, PreparedBody& prepared, VoxelisationReport& report) {
    prepared.mesh = body.mesh;
    prepared.property = body.property;
    if (Result<void> done = sortCrossings(prepared, grid); !done || prepared.crossings->closed()) return done;
    constexpr double slit = static_cast<double>(LineFilling::slit) / unitsPerVoxel; // voxels
    prepared.open = std::make_unique<OpenMesh>(*body.mesh, slit * grid.edge());
    prepared.mesh = &prepared.open->closed();
    report.openEdges = prepared.open->capCount();
    report.holes = prepared.open->holes();
    report.duplicateTriangles = prepared.open->duplicates();
    return sortCrossings(prepared, grid);
}

/// Fills rows of bricks on one thread, one after the other.
class RowFilling {
public:
    explicit RowFilling(const Grid& grid)
        : grid_(grid)
        , filling_(grid)
        , cells_(grid.lineCountU())
        , lines_(grid.lineEnd())
        , earlier_(static_cast<std::size_t>((grid.lineCountU() + brickSide - 1) / brickSide)) {}

    /// @param bodies lowest priority first
    void fill(const RunVolume& volume, std::int32_t row, std::span<const PreparedBody> bodies,
              std::span<VoxelisationReport> reports, BrickSink& sink) {
        for (std::size_t body = 0; body < bodies.size(); ++body) {
            bodies[body].crossings->collect(row, cells_);
            const bool last = body + 1 == bodies.size();
            for (LineIndex low{0, row * brickSide}; low.u < grid_.lineCountU(); low.u += brickSide) {
                const std::int32_t column = low.u / brickSide;
                std::unique_ptr<BrickLines>& earlier = earlier_[static_cast<std::size_t>(column)];
                if (cells_.touched(column)) {
                    paint(earlier ? earlier->segments() : volume.brick(low), low, bodies[body], reports[body]);
                    if (last) {
                        sink.put(low, lines_);
                        earlier.reset();
                    } else if (earlier) {
                        std::swap(*earlier, lines_);
                    } else {
                        earlier = std::make_unique<BrickLines>(std::exchange(lines_, BrickLines(grid_.lineEnd())));
                    }
                } else if (last && earlier) {
                    sink.put(low, *earlier);
                    earlier.reset();
                }
            }
            cells_.clear();
        }
    }

private:
    /// Makes the new content of a brick.
    void paint(std::span<const Segment> present, LineIndex low, const PreparedBody& body, VoxelisationReport& report) {
        lines_.clear();
        std::uint64_t* const replaced = report.replaced.units.data();
        for (int line = 0; line < linesPerBrick; ++line) {
            std::size_t count = 1;
            while (present[count - 1].end() != grid_.lineEnd()) ++count;
            const std::span<const Segment> before = present.first(count);
            present = present.subspan(count);
            const std::span<const LineCrossing> crossings = cells_.take(low.u / brickSide, line);
            if (count == 1 && crossings.empty()) {
                lines_.appendLine(0, 0, body.property, before[0].property());
            } else if (count == 1 && LineFilling::isPlain(crossings, grid_.lineEnd())) {
                const auto from = static_cast<RunPosition>(crossings[0].position());
                const auto to = static_cast<RunPosition>(crossings[1].position());
                lines_.appendLine(from, to, body.property, before[0].property());
                replaced[before[0].property()] += to - from;
                report.filledUnits += to - from;
            } else {
                std::span<const InnerSpan> inside;
                if (!crossings.empty())
                    inside = filling_.spans(crossings, {low.u + line % brickSide, low.v + line / brickSide},
                                            body.open.get(), report);
                appendPainted(before, inside, body.property, lines_, report.replaced);
            }
        }
        cells_.leave(low.u / brickSide);
    }

    Grid grid_;
    LineFilling filling_;
    CrossingCells cells_;
    BrickLines lines_;
    std::vector<std::unique_ptr<BrickLines>> earlier_; ///< content of a brick after the bodies filled before
};

void add(VoxelisationReport& sum, const VoxelisationReport& part) {
    sum.linesWithOddCrossings += part.linesWithOddCrossings;
    sum.throughHoles.add(part.throughHoles);
    sum.turnedFaces.add(part.turnedFaces);
    sum.insideOut.add(part.insideOut);
    sum.overlaps.add(part.overlaps);
    sum.clippedLines += part.clippedLines;
    sum.filledUnits += part.filledUnits;
    for (std::size_t i = 0; i < sum.replaced.units.size(); ++i) sum.replaced.units[i] += part.replaced.units[i];
}

/// State shared by all threads.
class Filling {
public:
    Filling(RunVolume& volume, std::span<const PreparedBody> bodies, Progress& progress)
        : volume_(volume), bodies_(bodies), progress_(progress), rows_(rowCount(volume.grid())) {}

    bool run() {
        ParallelProgress done(progress_, rows_.size());
        return volume_.rewriteBricks([&](std::int32_t row, BrickSink& sink) {
            if (progress_.cancelled()) return;
            std::unique_ptr<RowFilling> worker = takeWorker();
            std::vector<VoxelisationReport>& reports = rows_[static_cast<std::size_t>(row)];
            reports.assign(bodies_.size(), {}); // reset if the row is described again
            worker->fill(volume_, row, bodies_, reports, sink);
            giveBack(std::move(worker));
            done.add();
        });
    }
    VoxelisationReport sum(std::size_t body) const {
        VoxelisationReport all;
        for (const auto& row : rows_)
            if (!row.empty()) add(all, row[body]);
        return all;
    }

private:
    static std::size_t rowCount(const Grid& grid) {
        return static_cast<std::size_t>((grid.lineCountV() + brickSide - 1) / brickSide);
    }
    std::unique_ptr<RowFilling> takeWorker() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::make_unique<RowFilling>(volume_.grid());
        std::unique_ptr<RowFilling> worker = std::move(idle_.back());
        idle_.pop_back();
        return worker;
    }
    void giveBack(std::unique_ptr<RowFilling> worker) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(worker));
    }

    RunVolume& volume_;
    std::span<const PreparedBody> bodies_;
    Progress& progress_;
    std::vector<std::vector<VoxelisationReport>> rows_; ///< by row of bricks, then by body
    std::mutex mutex_;
    std::vector<std::unique_ptr<RowFilling>> idle_;
};

Result<std::vector<VoxelisationReport>> fillAll(std::span<const BodyMesh> bodies, RunVolume& volume,
                                                Progress& progress) {
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t body) { return bodies[body].priority; });
    std::vector<VoxelisationReport> reports(bodies.size());
    std::vector<PreparedBody> prepared(bodies.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (progress.cancelled()) break;
        if (Result<void> done = prepare(bodies[order[i]], volume.grid(), prepared[i], reports[order[i]]); !done)
            return done.error();
    }
    Filling filling(volume, prepared, progress);
    const bool enough = filling.run();
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "voxelisation", {}, {}};
    if (!enough) return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
    for (std::size_t i = 0; i < order.size(); ++i) add(reports[order[i]], filling.sum(i));
    return reports;
}

} // namespace

Result<std::vector<VoxelisationReport>> voxelise(std::span<const BodyMesh> bodies, RunVolume& volume,
                                                 Progress& progress) {
    try {
        return fillAll(bodies, volume, progress);
    } catch (const std::bad_alloc&) {
        std::size_t triangles = 0;
        for (const BodyMesh& body : bodies) triangles += body.mesh->triangles.size();
        return Error{ErrorCode::outOfMemory, "voxelisation", {}, std::to_string(triangles) + " triangles"};
    }
}

Result<VoxelisationReport> voxelise(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                    Progress& progress) {
    const BodyMesh body{&mesh, property, 0};
    Result<std::vector<VoxelisationReport>> reports = voxelise(std::span(&body, 1), volume, progress);
    if (!reports) return reports.error();
    return std::move(reports->front());
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/setup/cylinder_stock.h"
#include "core/setup/insert_overlap.h"
#include "core/setup/material_change.h"
#include "core/setup/setup.h"
#include "core/setup/setup_materials.h"
#include "core/setup/stock_shape.h"
#include "core/volume/operations/graded.h"
#include "core/volume/operations/repaint.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double roundingOfBoxes = 1e-6; // mm

/// Returns the distance by which a box protrudes from another, mm.
double beyond(const Box& box, const Box& outer) {
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        most = std::max({most, outer.low[axis] - box.low[axis], box.high[axis] - outer.high[axis]});
    return most;
}

Result<void> requireInside(const Model& model, const Setup& setup) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (!isEmbedded(roleOf(setup, i))) continue;
        if (const double out = beyond(model.bodies[i].box, setup.stock); out > roundingOfBoxes)
            return Error{ErrorCode::partOutsideStock, nameOf(model, i), formatFixed(out, 3) + " mm", {}};
    }
    return {};
}

/// Returns the findings about a body on its own.
std::vector<EmbeddingFinding> findingsOf(const Body& body, const VoxelisationReport& report) {
    using Kind = EmbeddingFinding::Kind;
    std::vector<EmbeddingFinding> findings;
    const auto add = [&](Kind kind, const DoubtfulLines& lines) {
        if (lines.count > 0) findings.push_back({.kind = kind, .count = lines.count, .place = lines.place});
    };
    if (report.openEdges > 0)
        findings.push_back({.kind = report.throughHoles.count > 0 ? Kind::openSurface : Kind::unseenOpening,
                            .count = report.throughHoles.count,
                            .openEdges = report.openEdges,
                            .rims = report.holes,
                            .place = report.throughHoles.place});
    else if (body.openEdges > 0 && report.clean()) // closed slits
        findings.push_back({.kind = Kind::unseenOpening, .openEdges = body.openEdges});
    add(Kind::turnedFaces, report.turnedFaces);
    add(Kind::insideOut, report.insideOut);
    add(Kind::overlappingShells, report.overlaps);
    if (report.duplicateTriangles > 0)
        findings.push_back({.kind = Kind::duplicateTriangles, .count = report.duplicateTriangles});
    if (report.filledUnits == 0) findings.push_back({.kind = Kind::tooSmall, .place = body.box});
    return findings;
}

/// Adds the findings about a body, including its overlaps with other protected bodies.
void note(const Model& model, std::size_t body, const Setup& setup, const VoxelisationReport& report,
          EmbeddedSetup& embedded) {
    std::vector<EmbeddingFinding> findings = findingsOf(model.bodies[body], report);
    for (std::size_t earlier = 0; earlier < body && isProtected(roleOf(setup, body)); ++earlier) {
        if (!isProtected(roleOf(setup, earlier))) continue;
        const std::uint64_t lost = report.replaced.units[embedded.bodyProperties[earlier]];
        if (lost > 0)
            findings.push_back({.kind = EmbeddingFinding::Kind::overlappingBodies,
                                .otherBody = nameOf(model, earlier),
                                .volume = static_cast<double>(lost) * embedded.workpiece.grid().unitVolume()});
    }
    for (EmbeddingFinding& finding : findings) {
        finding.body = nameOf(model, body);
        embedded.findings.push_back(std::move(finding));
    }
}

/// Checks that the part does not protrude from the stock, as there would be no material to mill it from. A box stock
/// was checked before; the extent of a stock of another form is only known once it is filled.
Result<void> requireStockAround(const Model& model, std::size_t body, const Setup& setup,
                                const VoxelisationReport& report, const RunVolume& workpiece) {
    if (setup.form == StockForm::box || !isProtected(roleOf(setup, body))) return {};
    // The largest deviation between the meshes of coincident curved faces; a volume is no finer than half a voxel.
    const double skin = setup.form == StockForm::file ? 0.5 * setup.voxel : 0.02; // mm
    const double out = static_cast<double>(report.replaced.units[airProperty]) * workpiece.grid().unitVolume();
    if (out <= skin * model.bodies[body].area) return {};
    return Error{ErrorCode::partOutsideStock, nameOf(model, body), formatFixed(out, 1) + " mm^3", {}};
}

Result<void> requireVoxels(const Model& model, std::size_t body, const Setup& setup, const VoxelisationReport& report) {
    if (roleOf(setup, body) != BodyRole::insert || report.filledUnits > 0) return {};
    return Error{ErrorCode::argumentInvalid, nameOf(model, body), "insert",
                 "a body that a scanline meets; smaller voxels may help"};
}

/// Fills inserts first, then the protected bodies, which take precedence.
Result<void> fillBodies(const Model& model, const Setup& setup, EmbeddedSetup& embedded, Progress& progress) {
    std::vector<BodyMesh> meshes;
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const BodyRole role = roleOf(setup, i);
        if (!isEmbedded(role)) continue;
        meshes.push_back({&model.bodies[i].mesh, embedded.bodyProperties[i], isProtected(role) ? 1 : 0});
        bodies.push_back(i);
    }
    const Result<std::vector<VoxelisationReport>> reports = voxelise(meshes, embedded.workpiece, progress);
    if (!reports) return reports.error();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const VoxelisationReport& report = (*reports)[i];
        if (Result<void> sound = requireStockAround(model, bodies[i], setup, report, embedded.workpiece); !sound)
            return sound;
        if (Result<void> sound = requireVoxels(model, bodies[i], setup, report); !sound) return sound;
        note(model, bodies[i], setup, report, embedded);
    }
    return {};
}

Error outOfReserve(const RunVolume& volume) {
    return {ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
}

/// Returns the stock's own runs, with its materials mapped to the entries of the setup's list.
Result<RunVolume> ownRuns(const StockVolume& stock, const SetupMaterials& materials, Progress& progress) {
    const Result<RunVolume> unpacked = stock.unpack(progress);
    if (!unpacked) return unpacked.error();
    return assemble(stock.grid(), materials.list, [&](LineIndex line, std::vector<Segment>& segments) {
        for (const Segment segment : unpacked->line(line))
            segments.emplace_back(segment.end(), materials.volume[segment.property()]);
    });
}

Result<void> fillStock(const Model& model, const Setup& setup, EmbeddedSetup& embedded, Progress& progress) {
    RunVolume& workpiece = embedded.workpiece;
    if (setup.form == StockForm::file) return {}; // already filled
    if (setup.form == StockForm::box)
        return BoxStock(setup.stock).fill(workpiece, embedded.stockProperty) ? Result<void>() : outOfReserve(workpiece);
    if (setup.form == StockForm::cylinder)
        return fillCylinder(workpiece, setup.cylinder, embedded.stockProperty) ? Result<void>()
                                                                               : outOfReserve(workpiece);
    std::vector<BodyMesh> solids;
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (roleOf(setup, i) == BodyRole::stock) solids.push_back({&model.bodies[i].mesh, embedded.stockProperty});
    const Result<std::vector<VoxelisationReport>> filled = voxelise(solids, workpiece, progress);
    return filled ? Result<void>() : filled.error();
}

RegionGrading gradingOf(const MaterialRegion& region, const GradedMaterial& graded, const PropertyList& list) {
    const NamedValue& value = list[graded.base].values.find(region.grade->value)->second;
    return {region.name,           region.grade->value, value.unit,    graded.grading.low(),
            graded.grading.high(), graded.entries,      graded.error()};
}

/// Fills the layers in their order: the later layer takes precedence.
Result<void> fillRegions(const Setup& setup, const SetupMaterials& materials, EmbeddedSetup& embedded) {
    for (std::size_t i = 0; i < setup.regions.size(); ++i) {
        const MaterialRegion& region = setup.regions[i];
        const PropertyIndex property = materials.regions[i];
        if (Result<void> done = repaint(embedded.workpiece, property, region.axis, region.from, region.to); !done)
            return done;
        const std::optional<GradedMaterial>& graded = materials.graded[i];
        if (!graded) continue;
        if (Result<void> done = gradeRuns(embedded.workpiece, *graded); !done) return done;
        embedded.gradings.push_back(gradingOf(region, *graded, embedded.workpiece.properties()));
    }
    return {};
}

void measure(EmbeddedSetup& embedded) {
    const RunVolume& workpiece = embedded.workpiece;
    std::uint64_t part = 0, stock = 0;
    embedded.untouched = workpiece.amounts();
    for (int i = 1; i < workpiece.properties().size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        (workpiece.properties().isProtected(property) ? part : stock) += workpiece.amounts().units[property];
    }
    embedded.partVolume = static_cast<double>(part) * workpiece.grid().unitVolume();
    embedded.stockVolume = static_cast<double>(stock) * workpiece.grid().unitVolume();
}

/// Returns a stock from a file as it is; for other forms, a grid filled with air.
Result<RunVolume> emptyOrOwn(const Setup& setup, const EmbeddingSize& size, const SetupMaterials& materials,
                             Progress& progress) {
    if (setup.form == StockForm::file) return ownRuns(*setup.volume, materials, progress);
    const Result<Grid> grid = Grid::make(setup.stock.low, setup.voxel, size.voxels, setup.runs);
    if (!grid) return grid.error();
    return RunVolume::make(*grid, materials.list);
}

} // namespace

Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& known,
                            Progress& progress) {
    const Result<EmbeddingSize> size = embeddingSize(setup);
    if (!size) return size.error();
    if (Result<void> inside = requireInside(model, setup); !inside) return inside.error();
    if (Result<void> apart = requireInsertsApart(model, setup, progress); !apart) return std::move(apart).error();
    Result<SetupMaterials> materials = setupMaterials(model, setup, known);
    if (!materials) return materials.error();
    Result<RunVolume> volume = emptyOrOwn(setup, *size, *materials, progress);
    if (!volume) return std::move(volume).error();

    EmbeddedSetup embedded{
        *std::move(volume), materials->bodies, materials->stock, materials->regions, {}, {}, 0.0, 0.0, {}};
    if (Result<void> filled = fillStock(model, setup, embedded, progress); !filled) return std::move(filled).error();
    if (Result<void> filled = fillRegions(setup, *materials, embedded); !filled) return std::move(filled).error();
    if (Result<void> filled = fillBodies(model, setup, embedded, progress); !filled) return std::move(filled).error();
    measure(embedded);
    return embedded;
}

Result<EmbeddedSetup> withMaterials(const EmbeddedSetup& embedded, const Model& model, const Setup& setup,
                                    const std::vector<Property>& materials) {
    Result<SetupMaterials> gathered = setupMaterials(model, setup, materials);
    if (!gathered) return std::move(gathered).error();
    const RunVolume& before = embedded.workpiece;
    Result<RunVolume> workpiece =
        assemble(before.grid(), std::move(gathered->list), [&](LineIndex line, std::vector<Segment>& segments) {
            const std::span<const Segment> kept = before.line(line);
            segments.assign(kept.begin(), kept.end());
        });
    if (!workpiece) return std::move(workpiece).error();
    EmbeddedSetup changed{*std::move(workpiece),        std::move(gathered->bodies), gathered->stock,
                          std::move(gathered->regions), embedded.gradings,           embedded.untouched,
                          embedded.partVolume,          embedded.stockVolume,        embedded.findings};
    return changed;
}

} // namespace burin

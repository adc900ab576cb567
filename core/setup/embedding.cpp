// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/setup/material_change.h"
#include "core/setup/setup.h"
#include "core/setup/stock_shape.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// The entries of a setup, in the order of the property list: stock, then one a body.
struct Materials {
    PropertyList list;
    PropertyIndex stock = airProperty;
    std::vector<PropertyIndex> bodies;
};

std::string nameOf(const Model& model, std::size_t body) {
    const std::string& name = model.bodies[body].name;
    return name.empty() ? "Body " + std::to_string(body + 1) : name;
}

/// Ids of a property list are unique; bodies of one name get numbers.
Result<PropertyIndex> addNumbered(PropertyList& list, Property property) {
    const auto taken = [&](const std::string& id) {
        for (int i = 0; i < list.size(); ++i)
            if (list[static_cast<PropertyIndex>(i)].id == id) return true;
        return false;
    };
    const std::string id = property.id;
    for (int number = 2; taken(property.id); ++number) property.id = id + " " + std::to_string(number);
    return list.add(std::move(property));
}

Result<Property> materialOf(const std::string& id, const std::vector<Property>& known) {
    for (const Property& material : known)
        if (material.id == id) return material;
    return loadMaterial(id);
}

Result<Materials> gatherMaterials(const Model& model, const Setup& setup, const std::vector<Property>& known) {
    Materials materials;
    Result<Property> stock = materialOf(setup.stockMaterial, known);
    if (!stock) return stock.error();
    stock->machinability = Machinability::machinable;
    const Property stockMaterial = *stock;
    const Result<PropertyIndex> stockIndex = materials.list.add(*std::move(stock));
    if (!stockIndex) return stockIndex.error();
    materials.stock = *stockIndex;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const bool own = i < setup.bodyMaterials.size() && !setup.bodyMaterials[i].empty();
        Result<Property> material = own ? materialOf(setup.bodyMaterials[i], known) : Result<Property>(stockMaterial);
        if (!material) return material.error();
        material->machinability = Machinability::isProtected;
        material->id += " (" + nameOf(model, i) + ")";
        material->name += " (" + nameOf(model, i) + ")";
        if (model.bodies[i].colour) material->colour = *model.bodies[i].colour;
        const Result<PropertyIndex> index = addNumbered(materials.list, *std::move(material));
        if (!index) return index.error();
        materials.bodies.push_back(*index);
    }
    return materials;
}

Result<void> requireInside(const Model& model, const Box& stock) {
    constexpr double roundingOfBoxes = 1e-6; // mm
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Box& box = model.bodies[i].box;
        double beyond = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            beyond = std::max({beyond, stock.low[axis] - box.low[axis], box.high[axis] - stock.high[axis]});
        if (beyond > roundingOfBoxes)
            return Error{ErrorCode::partOutsideStock, nameOf(model, i), formatFixed(beyond, 3) + " mm", {}};
    }
    return {};
}

/// What was odd about a body by itself.
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
    else if (body.openEdges > 0 && report.clean()) // slits that closed
        findings.push_back({.kind = Kind::unseenOpening, .openEdges = body.openEdges});
    add(Kind::turnedFaces, report.turnedFaces);
    add(Kind::insideOut, report.insideOut);
    add(Kind::overlappingShells, report.overlaps);
    if (report.duplicateTriangles > 0)
        findings.push_back({.kind = Kind::duplicateTriangles, .count = report.duplicateTriangles});
    if (report.filledUnits == 0) findings.push_back({.kind = Kind::tooSmall, .place = body.box});
    return findings;
}

/// And about it among the others.
void note(const Model& model, std::size_t body, const VoxelisationReport& report, EmbeddedSetup& embedded) {
    std::vector<EmbeddingFinding> findings = findingsOf(model.bodies[body], report);
    for (std::size_t earlier = 0; earlier < body; ++earlier) {
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

/// Where bodies overlap the later one has the place.
Result<void> fillBodies(const Model& model, EmbeddedSetup& embedded, Progress& progress) {
    std::vector<BodyMesh> bodies;
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        bodies.push_back({&model.bodies[i].mesh, embedded.bodyProperties[i]});
    const Result<std::vector<VoxelisationReport>> reports = voxelise(bodies, embedded.workpiece, progress);
    if (!reports) return reports.error();
    for (std::size_t i = 0; i < model.bodies.size(); ++i) note(model, i, (*reports)[i], embedded);
    return {};
}

} // namespace

Result<EmbeddedSetup> embed(const Model& model, const Setup& setup, const std::vector<Property>& known,
                            Progress& progress) {
    const Result<EmbeddingSize> size = embeddingSize(setup);
    if (!size) return size.error();
    if (Result<void> inside = requireInside(model, setup.stock); !inside) return inside.error();
    Result<Materials> materials = gatherMaterials(model, setup, known);
    if (!materials) return materials.error();
    const Result<Grid> grid = Grid::make(setup.stock.low, setup.voxel, size->voxels, setup.runs);
    if (!grid) return grid.error();
    Result<RunVolume> volume = RunVolume::make(*grid, std::move(materials->list));
    if (!volume) return volume.error();

    EmbeddedSetup embedded{*std::move(volume), std::move(materials->bodies), materials->stock, 0.0, 0.0, {}};
    if (!BoxStock(setup.stock).fill(embedded.workpiece, embedded.stockProperty))
        return Error{ErrorCode::volumeOutOfMemory, std::to_string(embedded.workpiece.reservedBytes()), {}, {}};
    if (Result<void> filled = fillBodies(model, embedded, progress); !filled) return filled.error();
    const RunAmounts& amounts = embedded.workpiece.amounts();
    for (const PropertyIndex property : embedded.bodyProperties)
        embedded.partVolume += static_cast<double>(amounts.units[property]) * grid->unitVolume();
    embedded.stockVolume = static_cast<double>(amounts.units[embedded.stockProperty]) * grid->unitVolume();
    return embedded;
}

Result<PropertyList> propertyListOf(const Model& model, const Setup& setup, const std::vector<Property>& materials) {
    Result<Materials> gathered = gatherMaterials(model, setup, materials);
    if (!gathered) return gathered.error();
    return std::move(gathered->list);
}

std::vector<std::string> idsOf(const PropertyList& list) {
    std::vector<std::string> ids;
    for (int i = 0; i < list.size(); ++i) ids.push_back(list[static_cast<PropertyIndex>(i)].id);
    return ids;
}

Result<EmbeddedSetup> withMaterials(const EmbeddedSetup& embedded, const Model& model, const Setup& setup,
                                    const std::vector<Property>& materials) {
    Result<Materials> gathered = gatherMaterials(model, setup, materials);
    if (!gathered) return std::move(gathered).error();
    const RunVolume& before = embedded.workpiece;
    Result<RunVolume> workpiece =
        assemble(before.grid(), std::move(gathered->list), [&](LineIndex line, std::vector<Segment>& segments) {
            const std::span<const Segment> kept = before.line(line);
            segments.assign(kept.begin(), kept.end());
        });
    if (!workpiece) return std::move(workpiece).error();
    return EmbeddedSetup{std::move(*workpiece), std::move(gathered->bodies), gathered->stock,
                         embedded.partVolume,   embedded.stockVolume,        embedded.findings};
}

} // namespace burin

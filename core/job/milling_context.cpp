// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/milling_context.h"

#include "core/job/milling_materials.h"
#include "core/job/part_distance.h"
#include "core/machine/machine_library.h"
#include "core/setup/material_change.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double travelAboveStock = 5.0; // mm

/// The field of a missing part, which never stops the tool.
class OpenField final : public ClearanceField {
public:
    explicit OpenField(double voxel) noexcept : voxel_(voxel) {}
    FieldSample at(const glm::dvec3&) const noexcept override { return {1e6, {0.0, 0.0, 0.0}, false}; }
    double errorBound() const noexcept override { return 0.0; }
    double spacing() const noexcept override { return voxel_; }

private:
    double voxel_;
};

/// Returns a function that makes the stock from copies of the request's model, setup and materials, independent of the
/// request's lifetime.
std::function<Result<RunVolume>(Progress&)> stockMaker(const MillingContextRequest& request) {
    return [model = request.model, setup = request.setup,
            materials = request.materials](Progress& progress) -> Result<RunVolume> {
        Result<EmbeddedSetup> embedded = embed(*model, setup, materials, progress);
        if (!embedded) return std::move(embedded).error();
        return std::move(embedded->workpiece);
    };
}

} // namespace

double MillingContext::safeHeight() const {
    const double working = setup.stock.high.z + travelAboveStock;
    double height = working;
    for (const Obstacle& obstacle : surroundings()) {
        const Box box = boundsOf(obstacle);
        if (obstacle.on && box.low.z < working)
            height = std::max(height, box.high.z + obstacle.margin + travelAboveStock);
    }
    return height;
}

std::vector<Obstacle> MillingContext::surroundings() const {
    std::vector<Obstacle> all = obstacles;
    all.insert(all.end(), bodyFixtures.begin(), bodyFixtures.end());
    return all;
}

Box MillingContext::tipRegion() const {
    return tipRegion(tool);
}

Box MillingContext::tipRegion(const Tool& other) const {
    Box region = setup.stock.grown(2.0 * other.cutter.diameter + travelAboveStock);
    region.high.z = setup.stock.high.z + 3.0 * travelAboveStock;
    return region;
}

double MillingContext::workpieceVolume() const {
    const RunVolume& workpiece = embedded.workpiece;
    std::uint64_t units = 0;
    for (int property = 1; property < workpiece.properties().size(); ++property)
        if (!workpiece.properties().isProtected(static_cast<PropertyIndex>(property)))
            units += workpiece.amounts().units[static_cast<std::size_t>(property)];
    return static_cast<double>(units) * workpiece.grid().unitVolume();
}

Result<Tool> toolFor(const Project& project, const std::string& id) {
    Result<std::vector<Tool>> own = project.tools();
    if (!own) return std::move(own).error();
    for (Tool& tool : *own)
        if (tool.id == id) return std::move(tool);
    return loadTool(id);
}

Result<MillingContext> makeMillingContext(const MillingContextRequest& request, Progress& progress) {
    progress.stage(0.0, 0.3);
    for (const Obstacle& obstacle : request.obstacles)
        if (Result<void> usable = checkObstacle(obstacle); !usable) return std::move(usable).error();
    Result<MachineProfile> machine = loadMachine(request.machineId);
    if (!machine) return std::move(machine).error();
    Result<std::vector<Obstacle>> fixtures = bodyFixtures(*request.model, request.setup);
    if (!fixtures) return std::move(fixtures).error();
    std::shared_ptr<const Model> partModel = protectedPart(request.model, request.setup);
    MeshDistance part = distanceFrom(*partModel);
    progress.stage(0.3, 1.0);
    Result<EmbeddedSetup> embedded = embed(*request.model, request.setup, request.materials, progress);
    if (!embedded) return std::move(embedded).error();
    const Property& material = embedded->workpiece.properties()[embedded->stockProperty];
    const Result<CuttingConditions> conditions =
        cuttingConditions(request.tool, material, machine->maximumSpindleSpeed, machine->maximumFeed);
    if (!conditions) return conditions.error();
    auto stock = std::make_shared<MilledStock>(stockMaker(request));
    return MillingContext{request.model,        std::move(partModel), request.setup,        request.materials,
                          request.tool,         std::move(*machine),  *conditions,          std::move(part),
                          std::move(*embedded), request.obstacles,    std::move(*fixtures), request.travel,
                          std::move(stock)};
}

Result<MillingContext> makeMillingContext(const Project& project, const Tool& tool, const std::string& machineId,
                                          Progress& progress) {
    Result<std::shared_ptr<const Model>> model = project.placedModel();
    if (!model) return std::move(model).error();
    Result<Setup> setup = project.setup();
    if (!setup) return std::move(setup).error();
    Result<std::vector<Property>> materials = project.materials();
    if (!materials && materials.error().code != ErrorCode::projectIncomplete) return std::move(materials).error();
    Result<std::vector<Obstacle>> obstacles = project.obstacles();
    if (!obstacles) return std::move(obstacles).error();
    const Result<TravelPlacement> travel = project.travelPlacement();
    if (!travel) return travel.error();
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    MillingContextRequest request{
        std::move(*model), std::move(*setup), tool, machineId.empty() ? target->machine : machineId, {}};
    request.obstacles = std::move(*obstacles);
    request.travel = *travel;
    if (materials) request.materials = std::move(*materials);
    return makeMillingContext(request, progress);
}

Result<void> changeMaterials(MillingContext& milling, const Setup& setup, const std::vector<Property>& materials) {
    Result<EmbeddedSetup> embedded = withMaterials(milling.embedded, *milling.model, setup, materials);
    if (!embedded) return std::move(embedded).error();
    const Result<CuttingConditions> conditions =
        cuttingConditions(milling.tool, embedded->workpiece.properties()[embedded->stockProperty],
                          milling.machine.maximumSpindleSpeed, milling.machine.maximumFeed);
    if (!conditions) return conditions.error();
    milling.setup = setup;
    milling.materials = materials;
    milling.embedded = std::move(*embedded);
    milling.conditions = *conditions;
    milling.stock =
        std::make_shared<MilledStock>(stockMaker({milling.model, setup, milling.tool, milling.machine.id, materials}));
    return {};
}

Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, double maximumAllowance,
                                                             Progress& progress) {
    return clearanceField(milling, milling.tool, maximumAllowance, progress);
}

Result<std::unique_ptr<const ClearanceField>> clearanceField(const MillingContext& milling, const Tool& tool,
                                                             double maximumAllowance, Progress& progress) {
    using Field = std::unique_ptr<const ClearanceField>;
    if (milling.partModel->bodies.empty()) return Field(std::make_unique<OpenField>(milling.setup.voxel));
    ToolFieldRequest request;
    request.tool = pieces(tool.cutter);
    request.tips = milling.tipRegion(tool);
    request.voxel = milling.setup.voxel;
    request.maximumAllowance = maximumAllowance;
    Result<ToolField> field = ToolField::build(milling.part, request, progress);
    if (!field) return std::move(field).error();
    return Field(std::make_unique<ToolField>(std::move(*field)));
}

} // namespace burin

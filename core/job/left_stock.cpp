// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/left_stock.h"
#include "core/job/job_paths.h"
#include "core/job/recorded_cuts.h"

#include "core/job/kept_program.h"
#include "core/volume/operations/moved.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/runs/property_entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

/// Switches a project to another setup for the lifetime of the object.
class UsedElsewhere {
public:
    explicit UsedElsewhere(Project& project) noexcept : project_(project), before_(project.usedSetup()) {}
    ~UsedElsewhere() { static_cast<void>(project_.useSetup(before_)); } // it was in use, so it exists
    UsedElsewhere(const UsedElsewhere&) = delete;
    UsedElsewhere& operator=(const UsedElsewhere&) = delete;

private:
    Project& project_;
    SetupId before_;
};

/// Returns the box around all material: exact along the runs, to the scanline across them.
Box materialBox(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    Box box;
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            RunPosition from = 0;
            for (const Segment segment : volume.line(line)) {
                if (segment.property() != airProperty) {
                    glm::dvec3 low, high;
                    low[grid.axisOfRuns()] = grid.toMillimetres(from);
                    high[grid.axisOfRuns()] = grid.toMillimetres(segment.end());
                    const glm::dvec2 centre = grid.lineCentre(line), half(0.5 * grid.edge());
                    low[grid.axisOfU()] = centre.x - half.x;
                    high[grid.axisOfU()] = centre.x + half.x;
                    low[grid.axisOfV()] = centre.y - half.y;
                    high[grid.axisOfV()] = centre.y + half.y;
                    box.include(low);
                    box.include(high);
                }
                from = segment.end();
            }
        }
    return box;
}

/// Replaces the sides of the material's box that reach a face of the original stock by that face, whose position is
/// known more exactly than the scanlines show.
Box withKnownFaces(Box material, const Box& stock, double voxel) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(material.low[axis] - stock.low[axis]) <= voxel) material.low[axis] = stock.low[axis];
        if (std::abs(material.high[axis] - stock.high[axis]) <= voxel) material.high[axis] = stock.high[axis];
    }
    return material;
}

Result<Property> materialOf(const MillingContext& milling, const std::string& id) {
    const auto known = std::ranges::find(milling.materials, id, &Property::id);
    return known != milling.materials.end() ? Result<Property>(*known) : loadMaterial(id);
}

/// The materials of a workpiece's entries when nothing is protected any more: a part becomes its raw material.
struct RawMaterials {
    PropertyList list;
    std::array<PropertyIndex, 256> of{};
};

Result<RawMaterials> rawMaterials(const MillingContext& milling) {
    RawMaterials raw{milling.embedded.workpiece.properties(), {}};
    for (std::size_t i = 0; i < raw.of.size(); ++i) raw.of[i] = static_cast<PropertyIndex>(i);
    const Setup& setup = milling.setup;
    for (std::size_t body = 0; body < milling.embedded.bodyProperties.size(); ++body) {
        const PropertyIndex entry = milling.embedded.bodyProperties[body];
        if (!raw.list.isProtected(entry)) continue;
        const bool own = body < setup.bodyMaterials.size() && !setup.bodyMaterials[body].empty();
        const std::string& id = own ? setup.bodyMaterials[body] : setup.stockMaterial;
        std::optional<PropertyIndex> material = entryOf(raw.list, id);
        if (!material) {
            Result<Property> added = materialOf(milling, id);
            if (!added) return std::move(added).error();
            const Result<PropertyIndex> index = raw.list.add(std::move(*added));
            if (!index) return index.error();
            material = *index;
        }
        raw.of[entry] = *material;
    }
    return raw;
}

Result<RunVolume> asRaw(const VolumeSnapshot& workpiece, const MillingContext& milling) {
    Result<RawMaterials> raw = rawMaterials(milling);
    if (!raw) return std::move(raw).error();
    return assemble(workpiece.grid(), raw->list, [&](LineIndex line, std::vector<Segment>& segments) {
        for (const Segment segment : workpiece.line(line))
            segments.emplace_back(segment.end(), raw->of[segment.property()]);
    });
}

struct Moved {
    StockVolume::Shared volume;
    Box box;
    double greatestDisplacement = 0.0;
};

/// @param stock the box that contains the material, in the frame of the volume
Result<Moved> movedStock(const VolumeSnapshot& volume, const Box& stock, const Placement& by, const std::string& name,
                         Progress& progress) {
    const Box material = withKnownFaces(materialBox(volume), stock, volume.grid().edge());
    Result<MovedVolume> other = moved(volume, by, progress);
    if (!other) return std::move(other).error();
    const VolumeSnapshot result = other->volume.snapshot();
    Result<StockVolume::Shared> packed = StockVolume::of(result, name, progress);
    if (!packed) return std::move(packed).error();
    const Box box = alongAxes(by) ? boxAround(material, by) : materialBox(result);
    return Moved{std::move(*packed), box, other->greatestDisplacement};
}

Result<VolumeSnapshot> afterRecordings(MillingContext& milling, const Project& project, Progress& progress) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    // Computed passes cut nothing before their program has been checked.
    if (takes->empty())
        return Error{ErrorCode::projectIncomplete, "checked program", "burin post", project.file().string()};
    if (Result<void> cut = replayTakes(project, milling, progress); !cut) return std::move(cut).error();
    return milling.embedded.workpiece.snapshot();
}

Result<MillingContext> millingOf(const Project& project, Progress& progress) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    if (sources->empty())
        return Error{ErrorCode::projectIncomplete, "recording", "burin mill", project.file().string()};
    const Result<Tool> tool = toolFor(project, sources->front().toolId);
    if (!tool) return tool.error();
    return makeMillingContext(project, *tool, {}, progress);
}

std::string nameOf(const Project& project, SetupId id) {
    const Result<std::vector<SetupName>> setups = project.setups();
    if (setups)
        for (const SetupName& setup : *setups)
            if (setup.id == id && !setup.name.empty()) return setup.name;
    return "setup " + std::to_string(numberOf(id));
}

} // namespace

Result<LeftStock> leftStock(const MillingContext& milling, const VolumeSnapshot& left, const LeftBy& by,
                            const Placement& to, const std::string& name, Progress& progress) {
    Result<RunVolume> raw = asRaw(left, milling);
    if (!raw) return std::move(raw).error();
    const Placement way = combined(inverse(milling.setup.placement), to);
    Result<Moved> stock = movedStock(raw->snapshot(), milling.setup.stock, way, name, progress);
    if (!stock) return std::move(stock).error();
    return LeftStock{std::move(stock->volume), stock->box, by, false, stock->greatestDisplacement};
}

Result<VolumeSnapshot> leftByProgram(const MillingContext& milling, const CheckedProgram& program, Progress& progress) {
    if (!program.machined.empty()) return program.machined;
    ProgramRequest request;
    request.dialect = program.dialect;
    request.exactSamples = 0; // the verdict is known already
    request.tools = program.tools;
    request.anyNumber = program.tools.size() == 1;
    Result<CheckedProgram> checked = checkProgram(milling, program.text, "program", request, progress);
    if (!checked) return std::move(checked).error();
    return std::move(checked->machined);
}

Result<LeftStock> leftStock(Project& project, SetupId setup, const Placement& to, Progress& progress) {
    const UsedElsewhere back(project);
    if (Result<void> used = project.useSetup(setup); !used) return std::move(used).error();
    const Result<std::int64_t> digest = project.jobDigest();
    if (!digest) return digest.error();
    Result<MillingContext> milling = [&] {
        const ProgressPart embedding(progress, 0.0, 0.3);
        return millingOf(project, progress);
    }();
    if (!milling) return std::move(milling).error();
    const Result<std::optional<ReopenedProgram>> program = reopenProgram(project);
    if (!program) return program.error();
    const bool byProgram = *program && (*program)->upToDate && (*program)->program->released();
    Result<VolumeSnapshot> left = [&] {
        const ProgressPart cutting(progress, 0.3, 0.8);
        return byProgram ? leftByProgram(*milling, *(*program)->program, progress)
                         : afterRecordings(*milling, project, progress);
    }();
    if (!left) return std::move(left).error();
    const ProgressPart moving(progress, 0.8, 1.0);
    Result<LeftStock> stock = leftStock(*milling, *left, {setup, *digest}, to, nameOf(project, setup), progress);
    if (stock) stock->byProgram = byProgram;
    return stock;
}

Setup withStock(Setup setup, const LeftStock& stock) {
    setup.form = StockForm::file;
    setup.volume = stock.volume;
    setup.stock = stock.box;
    setup.leftBy = stock.by;
    setup.regions.clear(); // contained in the volume
    return setup;
}

Result<Setup> placedFurther(Setup setup, const Placement& by, Progress& progress) {
    setup.placement = combined(setup.placement, by);
    setup.zero = moved(setup.zero, by);
    if (!setup.leftBy || !setup.volume) return setup;
    Result<RunVolume> volume = setup.volume->unpack(progress);
    if (!volume) return std::move(volume).error();
    Result<Moved> stock = movedStock(volume->snapshot(), setup.stock, by, setup.volume->name(), progress);
    if (!stock) return std::move(stock).error();
    setup.volume = std::move(stock->volume);
    setup.stock = stock->box;
    return setup;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/stock_file.h"

#include "core/exchange/volume_input.h"
#include "core/setup/setup.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <vector>

namespace burin {

namespace {

/// Returns the bodies of a model as runs of one material, in a grid around them.
Result<RunVolume> filled(const Model& model, const StockFileRequest& request, Progress& progress) {
    Setup around;
    around.voxel = request.voxel;
    around.stock = model.box();
    const Result<EmbeddingSize> size = embeddingSize(around);
    if (!size) return size.error();
    const Result<Grid> grid = Grid::make(around.stock.low, around.voxel, size->voxels);
    if (!grid) return grid.error();
    PropertyList materials;
    const Result<PropertyIndex> stock = materials.add(request.material);
    if (!stock) return stock.error();
    Result<RunVolume> volume = RunVolume::make(*grid, std::move(materials));
    if (!volume) return volume;
    std::vector<BodyMesh> solids;
    for (const Body& body : model.bodies) solids.push_back({&body.mesh, *stock});
    const Result<std::vector<VoxelisationReport>> reports = voxelise(solids, *volume, progress);
    if (!reports) return reports.error();
    for (std::size_t i = 0; i < reports->size(); ++i)
        if ((*reports)[i].throughHoles.count > 0)
            return Error{ErrorCode::stockInvalid, nameOf(model, i), {}, "a closed surface; close its holes"};
    return volume;
}

Result<RunVolume> fromModel(const StockFileRequest& request, Progress& progress) {
    const Result<Model> model = [&] {
        const ProgressPart importing(progress, 0.0, 0.6);
        return importModel(request.file, request.import, progress);
    }();
    if (!model) return model.error();
    const ProgressPart filling(progress, 0.6, 1.0);
    return filled(*model, request, progress);
}

} // namespace

Result<StockFile> readStockFile(const StockFileRequest& request, Progress& progress) {
    const Result<VolumeSource> source = volumeSourceOf(request.file);
    if (!source) return source.error();
    bool unitKnown = true;
    Result<RunVolume> volume = [&]() -> Result<RunVolume> {
        const ProgressPart reading(progress, 0.0, 0.7);
        if (*source == VolumeSource::other) return fromModel(request, progress);
        Result<VolumeInput> input = readAnyVolume(request.file, request.table, progress);
        if (!input) return std::move(input).error();
        unitKnown = input->unitKnown;
        return std::move(input->volume);
    }();
    if (!volume) return std::move(volume).error();
    const ProgressPart packing(progress, 0.7, 1.0);
    Result<StockVolume::Shared> stock = StockVolume::of(volume->snapshot(), request.file.filename().string(), progress);
    if (!stock) return std::move(stock).error();
    return StockFile{std::move(*stock), unitKnown};
}

} // namespace burin

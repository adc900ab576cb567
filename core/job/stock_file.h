// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "core/setup/stock_volume.h"

#include <filesystem>

namespace burin {

struct StockFileRequest {
    std::filesystem::path file, table; ///< of a voxel array the table of its materials
    double voxel = 0.5;                ///< mm, of a model; volumes have their own
    Property material;                 ///< of a model
    ImportOptions import;
};

struct StockFile {
    StockVolume::Shared volume;
    bool unitKnown = true; ///< false: a voxel array states no unit of length, and mm were taken
};

/// Raw material as a file has it: a volume file, a voxel array, or a model (of any format of importModel) whose solids
/// are filled with one material. The kind is found from the content. Any thread. Errors: those of readAnyVolume,
/// importModel, voxelise and StockVolume::of, volumeTooLarge, stockInvalid (a model whose surface is open where
/// scanlines see it: what it encloses would be a guess).
Result<StockFile> readStockFile(const StockFileRequest& request, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "core/setup/stock_volume.h"

#include <filesystem>

namespace burin {

struct StockFileRequest {
    std::filesystem::path file, table; ///< table: of the materials of a voxel array
    double voxel = 0.5;                ///< mm, for a model; volumes have their own
    Property material;                 ///< for a model
    ImportOptions import;
};

struct StockFile {
    StockVolume::Shared volume;
    bool unitKnown = true; ///< false: a voxel array states no unit of length, and mm were assumed
};

/// Reads raw material from a file: a volume file, a voxel array, or a model (of any format of importModel) whose solids
/// are filled with one material. The kind is detected from the content. Thread-safe. Errors: those of readAnyVolume,
/// importModel, voxelise and StockVolume::of, volumeTooLarge, stockInvalid (a model whose surface is open on scanlines:
/// what it encloses would be a guess).
Result<StockFile> readStockFile(const StockFileRequest& request, Progress& progress);

} // namespace burin

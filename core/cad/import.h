// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/cad/model_preview.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace burin {

struct ImportLimits {
    double seconds = 120.0;               ///< processor time of the child process, which does not depend on the load of
                                          ///< the machine
    double waitSeconds = 1200.0;          ///< wall time of the child process, for one that waits instead of working
    std::size_t memoryBytes = 4ULL << 30; ///< address space of the child process
};

struct ImportOptions {
    double meshChord = 0.005;          ///< mm, largest distance between mesh and surface
    double fileUnit = 1.0;             ///< mm per unit of a file that states none (STL, OBJ, PLY, OFF)
    std::optional<double> unitInstead; ///< mm per unit, whatever the file states; empty: as stated, or `fileUnit`
    ImportLimits limits;
    std::filesystem::path worker; ///< the import program; empty: `burin-import` in the folder of the running program
};

/// Receives a preview of a model while its mesh is still being made. Called on the importing thread, rarely more than
/// once: again if the file had to be read a second time after a crash.
using PreviewSink = std::function<void(ModelPreview preview)>;

/// Reads the formats of import_formats.h (chosen by the content, not by the suffix) in a child process with time and
/// memory limits: heals, sews, meshes and measures the model. A file that hangs or crashes OpenCASCADE causes an error,
/// but does not harm the caller.
/// Thread-safe. Errors: fileNotFound, fileNotReadable, fileEmpty, fileFormatUnknown, fileDamaged, modelHasNoSolid
/// (detail: the files of an assembly that are not in the folder of the file), modelTooLarge, meshIncomplete,
/// importTimedOut, importOutOfMemory, importCrashed, cancelled.
/// @param show receives a preview of a B-rep whose mesh takes time. If it is empty, no preview is made.
Result<Model> importModel(const std::filesystem::path& file, const ImportOptions& options, Progress& progress,
                          const PreviewSink& show = {});

/// Returns the exact signed distances from points to a model's B-rep, mm, negative inside, computed by OpenCASCADE's
/// extrema in child processes. Measured: 1 to 3 ms a point. Errors: as importModel, argumentInvalid (no B-rep).
Result<std::vector<double>> exactSignedDistances(const Model& model, std::span<const glm::dvec3> points,
                                                 const ImportOptions& options, Progress& progress);

} // namespace burin

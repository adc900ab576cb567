// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/cad/model_preview.h"

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace burin {

struct ImportLimits {
    double seconds = 120.0;               ///< processor time of the child process: what a busy machine does not stretch
    double waitSeconds = 1200.0;          ///< from its start to its end, for one that waits instead of working
    std::size_t memoryBytes = 4ULL << 30; ///< address space of the child process
};

struct ImportOptions {
    double meshChord = 0.005; ///< mm, distance between mesh and surface, at most
    double fileUnit = 1.0;    ///< mm per unit of a file that states none (STL, OBJ, PLY, OFF)
    ImportLimits limits;
    std::filesystem::path worker; ///< the import program; empty: `burin-import` beside the running program
};

/// Gets what there is to see of a model while its mesh is still made. Called by the thread that imports, seldom more
/// than once: again where a crash made the file be read again.
using PreviewSink = std::function<void(ModelPreview preview)>;

/// Reads the formats of import_formats.h (the contents decide, not the suffix) in a child process with time and memory
/// limits: heals, sews, meshes, measures. A file that hangs or kills OpenCASCADE costs an error, not the caller.
/// Thread: any. Errors: fileNotFound, fileNotReadable, fileEmpty, fileFormatUnknown, fileDamaged, modelHasNoSolid
/// (detail: the files of an assembly that are not beside it), modelTooLarge, meshIncomplete, importTimedOut,
/// importOutOfMemory, importCrashed, cancelled.
/// @param show gets a preview of a B-rep whose mesh takes time. Without it none is made.
Result<Model> importModel(const std::filesystem::path& file, const ImportOptions& options, Progress& progress,
                          const PreviewSink& show = {});

/// Exact distances from points to a model's B-rep, mm, negative inside: OpenCASCADE's extrema, in child processes.
/// Measured: 1 to 3 ms a point. Errors: as importModel, argumentInvalid (no B-rep).
Result<std::vector<double>> exactSignedDistances(const Model& model, std::span<const glm::dvec3> points,
                                                 const ImportOptions& options, Progress& progress);

} // namespace burin

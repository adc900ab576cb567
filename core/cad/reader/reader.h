// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/worker_message.h"

#include <functional>

namespace burin {

// The part of importing that may hang, abort or use up memory: it runs only in the import program.

/// Callbacks for the reader's progress and its preview.
struct ReaderReports {
    std::function<void(double)> fraction;                     ///< 0 … 1
    std::function<void(const ModelPreview& preview)> preview; ///< called at most once, if the request asks for it
    /// What the reader is doing, with the amounts of ImportStage; before the fractions of that stage.
    std::function<void(ImportStage stage, double done, double total)> stage;

    void tell(ImportStage now, double done = 0.0, double total = 0.0) const {
        if (stage) stage(now, done, total);
    }
};

/// Reads, heals, meshes and measures a model file. Errors, with an empty subject: as importModel.
Result<Model> readModel(const ReadRequest& request, const ReaderReports& report);

/// Returns the exact signed distances of the points, in order. Errors, with an empty subject: fileDamaged,
/// importOutOfMemory.
Result<std::vector<double>> measureDistances(const DistanceRequest& request, const std::function<void(double)>& report);

/// Errors, with an empty subject: fileDamaged, importOutOfMemory.
Result<std::vector<PartEdge>> followEdges(const EdgeRequest& request);

/// Errors, with an empty subject: fileDamaged, importOutOfMemory.
Result<PartFace> findFace(const FaceRequest& request);

/// Errors, with an empty subject: fileDamaged, importOutOfMemory.
Result<PartMeasure> measureFaces(const MeasureRequest& request);

/// Returns all faces, in the order of the shape. Errors, with an empty subject: fileDamaged, meshIncomplete,
/// importOutOfMemory.
Result<std::vector<PartFacePatch>> meshFaces(const PatchRequest& request, const std::function<void(double)>& report);

} // namespace burin

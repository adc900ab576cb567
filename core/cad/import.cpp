// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/import.h"

#include "core/base/clean_text.h"
#include "core/base/file.h"
#include "core/cad/part_edge.h"
#include "core/cad/worker_process.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <new>
#include <unistd.h>

namespace burin {

namespace fs = std::filesystem;

namespace {

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

Result<void> checkOptions(const ImportOptions& options) {
    if (!isPositive(options.meshChord))
        return Error{ErrorCode::argumentInvalid, "meshChord", std::to_string(options.meshChord), "> 0 mm"};
    if (!isPositive(options.fileUnit))
        return Error{ErrorCode::argumentInvalid, "fileUnit", std::to_string(options.fileUnit), "> 0 mm"};
    if (options.unitInstead && !isPositive(*options.unitInstead))
        return Error{ErrorCode::argumentInvalid, "unit", std::to_string(*options.unitInstead), "> 0 mm"};
    return {};
}

/// Finds the simple errors of a file without starting a process.
Result<void> checkFile(const fs::path& file) {
    std::error_code failed;
    const fs::file_status status = fs::status(file, failed);
    if (failed) return readError(file, failed.value());
    if (fs::is_directory(status)) return readError(file, EISDIR);
    // A pipe or a device could block for ever.
    if (!fs::is_regular_file(status)) return Error{ErrorCode::fileNotReadable, file.string(), {}, "is no plain file"};
    if (::access(file.c_str(), R_OK) != 0) return readError(file, errno);
    if (fs::file_size(file, failed) == 0) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    return {};
}

/// Splits the points into one part for each process; starting a process takes about as long as measuring a few points.
std::vector<WorkerRequest> shares(const Model& model, std::span<const glm::dvec3> points) {
    constexpr std::size_t processes = 2, leastShare = 16;
    const std::size_t count = std::clamp<std::size_t>(points.size() / leastShare, 1, processes);
    std::vector<WorkerRequest> requests;
    const Placement back = inverse(model.brepPlacement);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = points.size() * i / count, last = points.size() * (i + 1) / count;
        DistanceRequest request{model.brep, model.brepSolids, {}};
        for (const glm::dvec3& point : points.subspan(first, last - first)) request.points.push_back(back.point(point));
        requests.emplace_back(std::move(request));
    }
    return requests;
}

} // namespace

Result<Model> importModel(const fs::path& file, const ImportOptions& options, Progress& progress,
                          const PreviewSink& show) try {
    if (Result<void> valid = checkOptions(options); !valid) return std::move(valid).error();
    if (Result<void> valid = checkFile(file); !valid) return std::move(valid).error();
    std::error_code ignored;
    const fs::path whole = fs::absolute(file, ignored).lexically_normal();
    ReadRequest request{whole.string(), options.meshChord, options.unitInstead.value_or(options.fileUnit)};
    request.unitInstead = options.unitInstead.value_or(0.0);
    request.preview = show != nullptr;
    const auto showClean = [&](ModelPreview preview) {
        preview.sourceFile = whole.string();
        for (PreviewBody& body : preview.bodies) body.name = cleanLine(body.name);
        show(std::move(preview));
    };
    const PreviewSink sink = show ? PreviewSink(showClean) : PreviewSink();
    auto answers = runWorkers({request}, options, whole.string(), progress, sink);
    if (!answers && answers.error().code == ErrorCode::importCrashed) {
        request.careful = true;
        const ProgressPart rest(progress, progress.fractionOfStage(), 1.0); // what was shown is not taken back
        answers = runWorkers({request}, options, whole.string(), progress, sink);
    }
    progress.describe(textOf(ImportStage::none));
    if (!answers) return std::move(answers).error();
    auto* model = std::get_if<Model>(&answers->front());
    if (!model) return Error{ErrorCode::importCrashed, whole.string(), {}, "it answered something else"};
    model->sourceFile = whole.string();
    // Names of bodies from the file appear in lists, terminals, projects and programs.
    for (Body& body : model->bodies) body.name = cleanLine(body.name);
    for (ImportNote& note : model->notes) note.text = cleanLine(note.text);
    return std::move(*model);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, file.string(), {}, "for the imported model"};
}

Result<std::vector<double>> exactSignedDistances(const Model& model, std::span<const glm::dvec3> points,
                                                 const ImportOptions& options, Progress& progress) try {
    const std::string subject = "B-rep";
    if (model.brep.empty()) return Error{ErrorCode::argumentInvalid, subject, "", "a model with a B-rep"};
    if (points.empty()) return std::vector<double>{};
    auto answers = runWorkers(shares(model, points), options, subject, progress);
    if (!answers) return std::move(answers).error();
    std::vector<double> distances;
    for (const WorkerAnswer& answer : *answers)
        if (const auto* share = std::get_if<std::vector<double>>(&answer))
            distances.insert(distances.end(), share->begin(), share->end());
    if (distances.size() != points.size())
        return Error{ErrorCode::importCrashed, subject, {}, "it answered something else"};
    return distances;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "exact distances", {}, std::to_string(points.size()) + " points"};
}

Result<std::vector<PartEdge>> partEdges(const Model& model, double chord, const ImportOptions& options,
                                        Progress& progress) try {
    const std::string subject = "B-rep";
    if (model.brep.empty()) return Error{ErrorCode::argumentInvalid, subject, "", "a model with a B-rep"};
    if (!isPositive(chord)) return Error{ErrorCode::argumentInvalid, "chord", std::to_string(chord), "> 0 mm"};
    auto answers = runWorkers({EdgeRequest{model.brep, model.brepSolids, chord}}, options, subject, progress);
    if (!answers) return std::move(answers).error();
    auto* edges = std::get_if<std::vector<PartEdge>>(&answers->front());
    if (!edges) return Error{ErrorCode::importCrashed, subject, {}, "it answered something else"};
    for (PartEdge& edge : *edges) {
        for (glm::dvec3& point : edge.points) point = model.brepPlacement.point(point);
        for (glm::dvec3& tangent : edge.tangents) tangent = model.brepPlacement.direction(tangent);
    }
    return std::move(*edges);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "edges", {}, {}};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/cad/import_stages.h"
#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/cad/part_edge.h"
#include "core/cad/part_face.h"
#include "core/cad/part_faces.h"
#include "core/cad/part_measure.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace burin {

// The messages between Burin and its import program. The request is passed on the program's standard input; the program
// writes frames to its standard output: any number of progress frames, at most one preview among them, then one frame
// with the answer.

/// Request to read a model file.
struct ReadRequest {
    std::string file;         ///< absolute path
    double meshChord = 0.005; ///< mm
    double fileUnit = 1.0;    ///< mm per unit of a file that states none
    double unitInstead = 0.0; ///< mm per unit, whatever the file states; 0: as stated
    bool careful = false;     ///< do not use the faster of the two meshers: a process that used it crashed
    bool preview = false;     ///< send a preview as soon as there is one
};

/// Request to measure the distances of points.
struct DistanceRequest {
    std::string brep;                  ///< `Model::brep`
    std::vector<std::uint32_t> solids; ///< `Model::brepSolids`
    std::vector<glm::dvec3> points;    ///< mm
};

/// Request to follow the edges.
struct EdgeRequest {
    std::string brep;                  ///< `Model::brep`
    std::vector<std::uint32_t> solids; ///< `Model::brepSolids`
    double chord = 0.005;              ///< mm
};

/// Request to find the face at a point.
struct FaceRequest {
    std::string brep;                  ///< `Model::brep`
    std::vector<std::uint32_t> solids; ///< `Model::brepSolids`
    glm::dvec3 place{0.0};             ///< mm
};

/// Request to measure the faces at one or two points.
struct MeasureRequest {
    std::string brep;                  ///< `Model::brep`
    std::vector<std::uint32_t> solids; ///< `Model::brepSolids`
    std::vector<glm::dvec3> places;    ///< mm
};

/// A request to mesh each face separately and to measure it.
struct PatchRequest {
    std::string brep;                  ///< `Model::brep`
    std::vector<std::uint32_t> solids; ///< `Model::brepSolids`
    double chord = 0.005;              ///< mm
    bool careful = false;              ///< as in ReadRequest::careful
};

using WorkerRequest =
    std::variant<ReadRequest, DistanceRequest, EdgeRequest, FaceRequest, MeasureRequest, PatchRequest>;

/// The result that ends the program's work.
using WorkerAnswer = std::variant<Error, Model, std::vector<double>, std::vector<PartEdge>, PartFace, PartMeasure,
                                  std::vector<PartFacePatch>>;

/// The progress of the program.
struct WorkerProgress {
    double fraction = 0.0; ///< of its work, 0 … 1
    ImportStage stage = ImportStage::none;
    double done = 0.0, total = 0.0; ///< amounts of the stage
};

using WorkerFrame = std::variant<WorkerProgress, WorkerAnswer, ModelPreview>;

/// Written into every request and frame; those of another version are not read.
inline constexpr std::uint32_t workerMessageVersion = 9;

std::string encodeRequest(const WorkerRequest& request);
/// Empty if the bytes are not a request of this version.
std::optional<WorkerRequest> decodeRequest(std::string_view bytes);

/// Bytes of one frame, with version, length and checksum.
std::string encodeFrame(const WorkerFrame& frame);

/// Splits a stream of bytes into frames. Tolerates any content of the stream.
class FrameReader {
public:
    void append(std::string_view bytes) { waiting_.append(bytes); }
    /// Returns the next complete frame; empty while more bytes are needed, or if the stream is damaged.
    std::optional<WorkerFrame> next();
    bool damaged() const noexcept { return damaged_; }
    std::size_t waitingBytes() const noexcept { return waiting_.size(); }

private:
    std::string waiting_;
    bool damaged_ = false;
};

} // namespace burin

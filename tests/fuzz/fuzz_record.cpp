// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"
#include "core/document/mesh_blob.h"
#include "core/document/sample_chunk.h"
#include "core/document/setup_record.h"
#include "core/document/surroundings_record.h"
#include "core/job/kept_program.h"
#include "core/verify/report_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

using namespace burin;

namespace {

/// The text of a record extends to a zero byte and is followed by the bytes that belong to it.
void readWithBytes(std::string_view input) {
    const std::size_t end = std::min(input.find('\0'), input.size());
    const std::string_view json = input.substr(0, end);
    const std::string_view blob = input.substr(std::min(end + 1, input.size()));
    if (const auto obstacle = obstacleFrom(json, blob)) {
        const RecordWithBlob written = recordOf(*obstacle);
        if (!obstacleFrom(written.json, written.blob)) std::abort();
    }
    std::optional<GuideCurve> curve;
    static_cast<void>(guideFrom(json, blob, curve));
}

void readText(std::string_view text) {
    if (const auto setup = setupFromJson(text)) {
        const Result<std::string> written = toJson(*setup);
        if (!written || !setupFromJson(*written)) std::abort();
    }
    static_cast<void>(axisModeFromJson(text));
    static_cast<void>(travelPlacementFromJson(text));
    static_cast<void>(programTargetFromJson(text));
    static_cast<void>(programDraftFromJson(text));
    static_cast<void>(keptProgramFromJson(text));
    static_cast<void>(reportFromJson(text));
}

/// The number of samples of a chunk is stored only in its row: here the first two bytes are that number.
void readChunk(std::string_view input) {
    if (input.size() < 2) return;
    const std::size_t rows =
        static_cast<unsigned char>(input[0]) + (std::size_t{static_cast<unsigned char>(input[1])} << 8U);
    const auto samples = decodeSamples(input.substr(2), rows);
    if (samples && samples->size() != rows) std::abort();
}

// Changes of a frame's bytes are detected by its checksum, so here the input is the content of the frame.

/// As many rows of 36 columns as there are bytes for.
void readPlainChunk(std::string_view input) {
    constexpr std::size_t columns = 36, wordBytes = 8;
    if (input.size() < columns) return;
    const std::size_t rows = (input.size() / columns - 1) / wordBytes;
    const std::string chunk = '\1' + compress(input.substr(0, columns * (1 + wordBytes * rows)));
    const auto samples = decodeSamples(chunk, rows);
    if (!samples) return;
    const std::string written = encodeSamples(*samples);
    const auto again = decodeSamples(written, rows);
    if (!again || encodeSamples(*again) != written) std::abort();
}

std::string wordBytesOf(std::uint64_t word) {
    std::string bytes;
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<char>((word >> (8 * i)) & 0xff));
    return bytes;
}

/// Numbers of vertices and triangles, then their columns; missing bytes are zeros.
void readPlainMesh(std::string_view input) {
    if (input.size() < 2) return;
    const std::size_t vertices = static_cast<unsigned char>(input[0]), triangles = static_cast<unsigned char>(input[1]);
    const std::size_t vertexBytes = 3 * (1 + 8 * vertices), triangleBytes = 3 * (1 + 8 * triangles);
    std::string plain(input.substr(2));
    plain.resize(vertexBytes + triangleBytes);
    const std::string packed = compress(plain.substr(0, vertexBytes));
    const auto mesh = decodeMesh('\1' + wordBytesOf(vertices) + wordBytesOf(triangles) + wordBytesOf(packed.size()) +
                                 packed + compress(plain.substr(vertexBytes)));
    if (!mesh) return;
    const std::string written = encodeMesh(*mesh);
    const auto again = decodeMesh(written);
    if (!again || encodeMesh(*again) != written) std::abort();
}

/// Points and tangents of a guide; accepted input is a curve with unit tangents.
void readPlainCurve(std::string_view input) {
    constexpr std::size_t columns = 6, wordBytes = 8;
    if (input.size() < columns) return;
    const std::size_t rows = (input.size() / columns - 1) / wordBytes;
    const std::string json =
        R"({"curve_points":)" + std::to_string(rows) +
        R"(,"direction":[0,0,1],"distance_mm":1,"kind":"curve","lead_rad":0,"on":true,"on_surface":false,)"
        R"("point_mm":[0,0,0],"tilt_rad":0})";
    std::optional<GuideCurve> curve;
    if (!guideFrom(json, compress(input.substr(0, columns * (1 + wordBytes * rows))), curve)) return;
    if (!curve) std::abort();
    for (const glm::dvec3& tangent : curve->tangents())
        if (!(std::abs(glm::length(tangent) - 1.0) < 1e-3)) std::abort();
}

} // namespace

/// Each reader of the rows of a project; what was read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    if (count == 0) return 0;
    const std::string_view input(reinterpret_cast<const char*>(bytes) + 1, count - 1);
    switch (bytes[0] % 7U) {
    case 0:
        readText(input);
        break;
    case 1:
        readWithBytes(input);
        break;
    case 2:
        readChunk(input);
        break;
    case 3:
        static_cast<void>(decodeMesh(input));
        static_cast<void>(decodeBox(input));
        break;
    case 4:
        readPlainChunk(input);
        break;
    case 5:
        readPlainMesh(input);
        break;
    default:
        readPlainCurve(input);
    }
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/kept_program.h"
#include "core/project/mesh_blob.h"
#include "core/project/sample_chunk.h"
#include "core/project/setup_record.h"
#include "core/project/surroundings_record.h"
#include "core/verify/report_json.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

using namespace burin;

namespace {

/// Up to a zero stands the text of a record, behind it the bytes that belong to it.
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
    if (const auto setup = setupFromJson(text))
        if (!setupFromJson(toJson(*setup))) std::abort();
    static_cast<void>(axisModeFromJson(text));
    static_cast<void>(travelPlacementFromJson(text));
    static_cast<void>(programTargetFromJson(text));
    static_cast<void>(programDraftFromJson(text));
    static_cast<void>(keptProgramFromJson(text));
    static_cast<void>(reportFromJson(text));
}

/// A chunk says itself how many samples it should have only in its row: two bytes stand for that.
void readChunk(std::string_view input) {
    if (input.size() < 2) return;
    const std::size_t rows =
        static_cast<unsigned char>(input[0]) + (std::size_t{static_cast<unsigned char>(input[1])} << 8U);
    const auto samples = decodeSamples(input.substr(2), rows);
    if (samples && samples->size() != rows) std::abort();
}

} // namespace

/// What the rows of a project hold, each reader of them; what was read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    if (count == 0) return 0;
    const std::string_view input(reinterpret_cast<const char*>(bytes) + 1, count - 1);
    switch (bytes[0] % 4U) {
    case 0:
        readText(input);
        break;
    case 1:
        readWithBytes(input);
        break;
    case 2:
        readChunk(input);
        break;
    default:
        static_cast<void>(decodeMesh(input));
        static_cast<void>(decodeBox(input));
    }
    return 0;
}

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace burin;

bool isSound(const TriangleMesh& mesh) {
    for (const glm::dvec3& vertex : mesh.vertices)
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z)) return false;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= mesh.vertices.size()) return false;
    return true;
}

} // namespace

/// Any input that is accepted as an STL file: its triangles refer to existing, finite vertices, and there are no more
/// of them than the file has room for (a text facet takes more than the 50 bytes of a binary one).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view content(reinterpret_cast<const char*>(bytes), count);
    const auto format = detectFormat(content);
    if (!format || format->name != StlFormat::name) return 0;
    std::string file(content);
    const ReadRequest request;
    const ReaderReports report;
    ModelSource source{request, report, file};
    const auto model = format->read(source);
    if (!model) return 0;
    std::size_t triangles = 0;
    for (const Body& body : model->bodies) {
        if (body.mesh.empty() || !isSound(body.mesh)) std::abort();
        triangles += body.mesh.triangles.size();
    }
    if (triangles == 0 || triangles * 50 > count) std::abort();
    return 0;
}

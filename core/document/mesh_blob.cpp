// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/mesh_blob.h"

#include "core/base/compression.h"
#include "core/document/column_codec.h"

#include <limits>

namespace burin {

namespace {

constexpr char meshFormVersion = 1;
constexpr std::size_t wordBytes = 8;
constexpr std::size_t headerSize = 1 + 3 * wordBytes; // form, vertices, triangles, bytes of the packed vertices
constexpr std::uint64_t largestCount = std::numeric_limits<std::uint32_t>::max();

void appendWord(std::string& bytes, std::uint64_t word) {
    for (std::size_t i = 0; i < wordBytes; ++i) bytes.push_back(static_cast<char>((word >> (8 * i)) & 0xff));
}

std::uint64_t wordAt(std::string_view bytes, std::size_t position) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < wordBytes; ++i)
        word |= std::uint64_t{static_cast<unsigned char>(bytes[position + i])} << (8 * i);
    return word;
}

std::string packedVertices(const TriangleMesh& mesh) {
    std::vector<Column> columns(3, Column(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            columns[static_cast<std::size_t>(axis)][i] = wordOf(mesh.vertices[i][axis]);
    return encodeColumns(columns);
}

std::string packedTriangles(const TriangleMesh& mesh) {
    std::vector<Column> columns(3, Column(mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) columns[corner][i] = mesh.triangles[i][corner];
    return encodeColumns(columns, 1);
}

} // namespace

std::string encodeMesh(const TriangleMesh& mesh) {
    const std::string vertices = packedVertices(mesh);
    std::string blob(1, meshFormVersion);
    appendWord(blob, mesh.vertices.size());
    appendWord(blob, mesh.triangles.size());
    appendWord(blob, vertices.size());
    return blob + vertices + packedTriangles(mesh);
}

std::optional<TriangleMesh> decodeMesh(std::string_view blob) {
    if (blob.size() < headerSize || blob.front() != meshFormVersion) return std::nullopt;
    const std::uint64_t vertexCount = wordAt(blob, 1), triangleCount = wordAt(blob, 1 + wordBytes);
    const std::uint64_t vertexBytes = wordAt(blob, 1 + 2 * wordBytes);
    if (vertexCount > largestCount || triangleCount > largestCount || vertexBytes > blob.size() - headerSize)
        return std::nullopt;
    const auto vertices = decodeColumns(blob.substr(headerSize, vertexBytes), 3, vertexCount);
    const auto triangles = decodeColumns(blob.substr(headerSize + vertexBytes), 3, triangleCount);
    if (!vertices || !triangles) return std::nullopt;

    TriangleMesh mesh;
    mesh.vertices.reserve(vertexCount);
    for (std::size_t i = 0; i < vertexCount; ++i)
        mesh.vertices.emplace_back(doubleOf((*vertices)[0][i]), doubleOf((*vertices)[1][i]),
                                   doubleOf((*vertices)[2][i]));
    mesh.triangles.resize(triangleCount);
    for (std::size_t i = 0; i < triangleCount; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t index = (*triangles)[corner][i];
            if (index >= vertexCount) return std::nullopt;
            mesh.triangles[i][corner] = static_cast<std::uint32_t>(index);
        }
    return mesh;
}

std::string encodeFaceColours(const FaceColours& colours) {
    if (colours.empty()) return {};
    std::vector<Column> columns(3);
    for (const ColouredTriangles& part : colours) {
        columns[0].push_back(part.first);
        columns[1].push_back(part.count);
        columns[2].push_back(std::uint64_t{part.colour[0]} << 16 | std::uint64_t{part.colour[1]} << 8 | part.colour[2]);
    }
    std::string bytes;
    appendWord(bytes, colours.size());
    return attached(bytes + encodeColumns(columns));
}

std::optional<FaceColours> decodeFaceColours(std::string_view blob, std::size_t triangles) {
    if (blob.size() < headerSize) return std::nullopt;
    const std::uint64_t vertexBytes = wordAt(blob, 1 + 2 * wordBytes);
    if (vertexBytes > blob.size() - headerSize) return std::nullopt;
    const std::string_view bytes = attachmentOf(blob.substr(headerSize + vertexBytes));
    FaceColours colours;
    if (bytes.empty()) return colours;
    if (bytes.size() < wordBytes) return std::nullopt;
    const std::uint64_t count = wordAt(bytes, 0);
    if (count > largestCount) return std::nullopt;
    const auto columns = decodeColumns(bytes.substr(wordBytes), 3, count);
    if (!columns) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t first = (*columns)[0][i], size = (*columns)[1][i], colour = (*columns)[2][i];
        if (first > largestCount || size > largestCount) return std::nullopt;
        const auto channel = [colour](unsigned shift) { return static_cast<std::uint8_t>(colour >> shift & 0xff); };
        colours.push_back({static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>(size),
                           {channel(16), channel(8), channel(0)}});
    }
    if (!areSound(colours, triangles)) return std::nullopt;
    return colours;
}

bool MeshesTogether::add(const TriangleMesh& mesh, std::size_t packed) noexcept {
    taken_ += mesh.vertices.size() * sizeof(mesh.vertices[0]) + mesh.triangles.size() * sizeof(mesh.triangles[0]);
    packed_ += packed;
    return taken_ <= mostUnpackedTogether(packed_);
}

std::string encodeBox(const Box& box) {
    std::string blob;
    for (const glm::dvec3& corner : {box.low, box.high})
        for (int axis = 0; axis < 3; ++axis) appendWord(blob, wordOf(corner[axis]));
    return blob;
}

std::optional<Box> decodeBox(std::string_view blob) {
    if (blob.size() != 6 * wordBytes) return std::nullopt;
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis) * wordBytes;
        box.low[axis] = doubleOf(wordAt(blob, place));
        box.high[axis] = doubleOf(wordAt(blob, 3 * wordBytes + place));
    }
    return box;
}

} // namespace burin

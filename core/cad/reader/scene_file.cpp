// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/scene_file.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <zip.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <utility>

namespace burin {

namespace {

glm::dmat4 matrixOf(const aiMatrix4x4& m) {
    return glm::transpose(
        glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

std::optional<std::array<std::uint8_t, 3>> colourOf(const aiScene& scene, const aiMesh& mesh) {
    aiColor4D colour;
    if (mesh.mMaterialIndex >= scene.mNumMaterials) return std::nullopt;
    const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
    aiString name;
    // assimp gives what has none a grey of its own.
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS && std::string_view(name.C_Str()) == "DefaultMaterial")
        return std::nullopt;
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return std::nullopt;
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
    };
    return std::array{byte(colour.r), byte(colour.g), byte(colour.b)};
}

void append(TriangleMesh& to, const aiMesh& mesh, const glm::dmat4& placement) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& v = mesh.mVertices[i];
        to.vertices.emplace_back(placement * glm::dvec4(v.x, v.y, v.z, 1.0));
    }
    // A placement that mirrors turns triangles inside out.
    const bool turned = glm::determinant(glm::dmat3(placement)) < 0.0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3) continue; // points and lines
        std::array<std::uint32_t, 3> corners{first + face.mIndices[0], first + face.mIndices[1],
                                             first + face.mIndices[2]};
        if (turned) std::swap(corners[1], corners[2]);
        to.triangles.push_back(corners);
    }
}

/// Names that assimp makes up, or that are those of its file in memory.
std::string nameOf(const aiNode& node, const aiMesh& mesh) {
    for (const aiString* name : {&node.mName, &mesh.mName}) {
        const std::string_view text = name->C_Str();
        const bool madeUp = text.empty() || text.starts_with("$$$___magic___$$$") || text == "defaultobject" ||
                            text == "3MF" || text == "<OFFRoot>" || text == "<PLYRoot>";
        if (!madeUp) return std::string(text);
    }
    return {};
}

class Gatherer {
public:
    explicit Gatherer(const aiScene& scene) : scene_(scene) {}

    /// Hostile files may nest without end; assimp's tree is as deep as the file says.
    void gather(const aiNode& root) {
        struct Open {
            const aiNode* node;
            glm::dmat4 placement;
        };
        std::vector<Open> open{{&root, matrixOf(root.mTransformation)}};
        while (!open.empty()) {
            const Open next = open.back();
            open.pop_back();
            take(*next.node, next.placement);
            for (unsigned i = next.node->mNumChildren; i-- > 0;) {
                const aiNode* child = next.node->mChildren[i];
                open.push_back({child, next.placement * matrixOf(child->mTransformation)});
            }
        }
    }

    std::vector<MeshSolid> solids;

private:
    /// A node's meshes are its materials: one body.
    void take(const aiNode& node, const glm::dmat4& placement) {
        MeshSolid solid;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
            append(solid.mesh, mesh, placement);
            if (solid.name.empty()) solid.name = nameOf(node, mesh);
            if (i == 0) solid.colour = colourOf(scene_, mesh);
        }
        if (solid.mesh.empty()) return;
        solid.mesh = weldIdenticalVertices(solid.mesh);
        solids.push_back(std::move(solid));
    }

    const aiScene& scene_;
};

bool isFinite(const TriangleMesh& mesh) {
    return std::ranges::all_of(mesh.vertices, [](const glm::dvec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

/// A ZIP archive in memory, read only.
class ZipArchive {
public:
    explicit ZipArchive(std::string_view content) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* source = zip_source_buffer_create(content.data(), content.size(), 0, &error);
        if (source != nullptr) archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
        if (archive_ == nullptr && source != nullptr) zip_source_free(source);
        zip_error_fini(&error);
    }
    ~ZipArchive() {
        if (archive_ != nullptr) zip_discard(archive_);
    }
    ZipArchive(const ZipArchive&) = delete;
    ZipArchive& operator=(const ZipArchive&) = delete;

    bool isOpen() const noexcept { return archive_ != nullptr; }

    std::optional<zip_uint64_t> find(std::string_view ending) const {
        const zip_int64_t count = archive_ != nullptr ? zip_get_num_entries(archive_, 0) : 0;
        for (zip_int64_t i = 0; i < count; ++i) {
            const char* name = zip_get_name(archive_, static_cast<zip_uint64_t>(i), 0);
            if (name != nullptr && lowered(name).ends_with(ending)) return static_cast<zip_uint64_t>(i);
        }
        return std::nullopt;
    }

    /// As far as it can be unpacked; a bomb ends at the import program's limit of memory.
    std::optional<std::string> read(zip_uint64_t entry) const {
        zip_file_t* file = zip_fopen_index(archive_, entry, 0);
        if (file == nullptr) return std::nullopt;
        std::string content;
        std::array<char, 65536> part;
        zip_int64_t count = 0;
        while ((count = zip_fread(file, part.data(), part.size())) > 0)
            content.append(part.data(), static_cast<std::size_t>(count));
        zip_fclose(file);
        return count < 0 ? std::nullopt : std::optional(std::move(content));
    }

private:
    zip_t* archive_ = nullptr;
};

} // namespace

Result<std::vector<MeshSolid>> readScene(std::string_view content, const char* format) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(),
                                                       aiProcess_Triangulate | aiProcess_SortByPType, format);
    if (scene == nullptr || scene->mRootNode == nullptr)
        return Error{ErrorCode::fileDamaged, {}, {}, importer.GetErrorString()};
    Gatherer gatherer(*scene);
    gatherer.gather(*scene->mRootNode);
    for (const MeshSolid& solid : gatherer.solids)
        if (!isFinite(solid.mesh)) return Error{ErrorCode::fileDamaged, {}, {}, "a coordinate that is no number"};
    return std::move(gatherer.solids);
}

std::optional<std::string> unzippedFile(std::string_view archive, std::string_view ending) {
    const ZipArchive zip(archive);
    const std::optional<zip_uint64_t> entry = zip.find(ending);
    return entry ? zip.read(*entry) : std::nullopt;
}

bool isArchiveWith(std::string_view content, std::string_view ending) {
    if (!content.starts_with("PK\x03\x04")) return false;
    const ZipArchive zip(content);
    if (zip.isOpen()) return zip.find(ending).has_value();
    return lowered(content.substr(0, 65536)).find(ending) != std::string::npos; // its end is missing
}

} // namespace burin

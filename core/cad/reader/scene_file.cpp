// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/scene_file.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace burin {

namespace {

glm::dmat4 matrixOf(const aiMatrix4x4& m) {
    return glm::transpose(
        glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

BodyColour colourOf(const aiScene& scene, const aiMesh& mesh) {
    aiColor4D colour;
    if (mesh.mMaterialIndex >= scene.mNumMaterials) return std::nullopt;
    const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
    aiString name;
    // assimp gives meshes without material a grey of its own.
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
    // A mirrored placement turns triangles inside out.
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

/// Returns the name, without those that assimp invents or takes from its in-memory file.
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

    /// Iterative, because malicious files may be nested arbitrarily deep; assimp's tree has the depth of the file.
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
    /// The meshes of a node differ in material only, so they make one body.
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

} // namespace burin

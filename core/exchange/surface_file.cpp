// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/surface_file.h"

#include "core/base/file.h"

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <memory>
#include <new>
#include <system_error>

namespace burin {

namespace {

namespace fs = std::filesystem;

struct SurfaceFormat {
    std::string_view suffix;
    const char* id;     ///< of assimp
    bool severalMeshes; ///< keeps materials separate
};
constexpr std::array surfaceFormats{SurfaceFormat{".stl", "stlb", false}, SurfaceFormat{".ply", "plyb", false},
                                    SurfaceFormat{".3mf", "3mf", true}};

const SurfaceFormat* formatOf(const fs::path& file) {
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto* found = std::ranges::find(surfaceFormats, suffix, &SurfaceFormat::suffix);
    return found == surfaceFormats.end() ? nullptr : found;
}

/// One mesh of the given triangles.
aiMesh* meshOf(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles, unsigned material) {
    auto made = std::make_unique<aiMesh>();
    std::map<std::uint32_t, unsigned> place;
    std::vector<std::uint32_t> vertices;
    made->mNumFaces = static_cast<unsigned>(triangles.size());
    made->mFaces = new aiFace[triangles.size()]; // NOLINT: the scene deletes it
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        aiFace& face = made->mFaces[i];
        face.mNumIndices = 3;
        face.mIndices = new unsigned[3]; // NOLINT: the face deletes it
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[triangles[i]][corner];
            const auto [entry, isNew] = place.try_emplace(vertex, static_cast<unsigned>(vertices.size()));
            if (isNew) vertices.push_back(vertex);
            face.mIndices[corner] = entry->second;
        }
    }
    made->mNumVertices = static_cast<unsigned>(vertices.size());
    made->mVertices = new aiVector3D[vertices.size()]; // NOLINT: the mesh deletes it
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3 at(mesh.vertices[vertices[i]]);
        made->mVertices[i] = {at.x, at.y, at.z};
    }
    made->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    made->mMaterialIndex = material;
    return made.release();
}

aiMaterial* materialOf(const Property& property) {
    auto made = std::make_unique<aiMaterial>();
    const aiString name(property.name);
    made->AddProperty(&name, AI_MATKEY_NAME);
    const auto channel = [&](std::size_t i) { return static_cast<float>(property.colour[i]) / 255.0F; };
    const aiColor4D colour(channel(0), channel(1), channel(2), 1.0F);
    made->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
    return made.release();
}

std::unique_ptr<aiScene> sceneOf(const VolumeSurface& surface, const PropertyList& materials, bool severalMeshes) {
    std::map<PropertyIndex, std::vector<std::size_t>> parts;
    for (std::size_t i = 0; i < surface.mesh.triangles.size(); ++i)
        parts[severalMeshes ? surface.materials[i] : PropertyIndex{1}].push_back(i);
    auto scene = std::make_unique<aiScene>();
    const auto count = static_cast<unsigned>(parts.size());
    scene->mMeshes = new aiMesh* [count] {}; // NOLINT: the scene deletes all of it
    scene->mMaterials = new aiMaterial* [count] {};
    scene->mRootNode = new aiNode("workpiece");
    auto* node = new aiNode("surface"); // the 3MF writer ignores meshes of the root itself
    scene->mRootNode->addChildren(1, &node);
    node->mMeshes = new unsigned[count];
    for (const auto& [property, triangles] : parts) {
        const unsigned place = scene->mNumMeshes++;
        scene->mMeshes[place] = meshOf(surface.mesh, triangles, place);
        scene->mMaterials[place] = materialOf(materials[property]);
        ++scene->mNumMaterials;
        node->mMeshes[node->mNumMeshes++] = place;
    }
    return scene;
}

/// The 3MF writer compresses a file by itself and does not report a full disk: its output is read back.
bool holds(const fs::path& file, std::size_t triangles) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr) return false;
    std::size_t found = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) found += scene->mMeshes[i]->mNumFaces;
    return found == triangles;
}

Result<void> writePacked(const aiScene& scene, const char* format, std::size_t triangles, const fs::path& file) {
    fs::path beside = temporaryBeside(file);
    beside += ".3mf"; // the reader depends on the suffix
    Assimp::Exporter exporter;
    const bool written = exporter.Export(&scene, format, beside.string()) == aiReturn_SUCCESS;
    if (written && holds(beside, triangles)) return replaceFile(beside, file);
    std::error_code ignored;
    fs::remove(beside, ignored);
    return Error{
        ErrorCode::fileNotWritable, file.string(), {}, written ? "the disk may be full" : exporter.GetErrorString()};
}

} // namespace

bool isSurfaceFile(const fs::path& file) {
    return formatOf(file) != nullptr;
}

Result<void> writeSurfaceFile(const fs::path& file, const VolumeSurface& surface, const PropertyList& materials) try {
    const SurfaceFormat* format = formatOf(file);
    if (format == nullptr)
        return Error{ErrorCode::notSupported, "a surface as " + file.extension().string(), ".stl, .ply or .3mf", {}};
    if (surface.mesh.triangles.empty()) return Error{ErrorCode::modelHasNoSolid, file.string(), "air alone", {}};
    const std::unique_ptr<aiScene> scene = sceneOf(surface, materials, format->severalMeshes);
    if (format->severalMeshes) return writePacked(*scene, format->id, surface.mesh.triangles.size(), file);
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format->id);
    if (blob == nullptr) return Error{ErrorCode::outOfMemory, file.string(), {}, exporter.GetErrorString()};
    return writeFileAtomically(file, {static_cast<const char*>(blob->data), blob->size});
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, file.string(), {}, {}};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/stl_model.h"

#include "core/cad/import_notes.h"
#include "core/cad/reader/mesh_model.h"
#include "core/cad/reader/stl_file.h"

#include <utility>

namespace burin {

Result<Model> readStlModel(std::string_view content, bool binary, double unit) {
    bool ended = true;
    Result<std::vector<StlSolid>> solids = binary ? readBinaryStl(content) : readTextStl(content, ended);
    if (!solids) return std::move(solids).error();
    Model model;
    model.format = binary ? "STL binary" : "STL ASCII";
    takeUnit(model, unit);
    if (binary && !hasLengthOfBinaryStl(content))
        addNote(model, ImportNote::Kind::warning, import_notes::restLeftOut.text);
    if (!ended) addNote(model, ImportNote::Kind::warning, import_notes::endMissing.text);
    std::vector<MeshSolid> meshes;
    for (StlSolid& solid : *solids) meshes.push_back({std::move(solid.name), std::move(solid.mesh)});
    return withBodies(std::move(model), std::move(meshes));
}

} // namespace burin

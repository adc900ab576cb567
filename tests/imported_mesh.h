// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "tests/places.h"

namespace burin::tests {

/// All bodies of one of the fixtures' models in a single mesh, read by the real import; empty if that fails. The test's
/// target has to depend on burin-import.
inline TriangleMesh importedMesh(const char* file) {
    ImportOptions options;
    options.worker = std::filesystem::path(BURIN_BUILD_DIRECTORY) / "burin-import";
    Progress progress;
    const Result<Model> model = importModel(std::filesystem::path(BURIN_FIXTURES) / "models" / file, options, progress);
    TriangleMesh mesh;
    if (model)
        for (const Body& body : model->bodies) append(mesh, body.mesh);
    return mesh;
}

} // namespace burin::tests

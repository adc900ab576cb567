// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "tests/places.h"

#include <QString>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

inline std::filesystem::path worker() {
    return std::filesystem::path(BURIN_BUILD_DIRECTORY) / "burin-import";
}

inline std::filesystem::path modelFile(const std::string& name) {
    return std::filesystem::path(BURIN_FIXTURES) / "models" / name;
}

inline std::filesystem::path sampleFile() {
    return std::filesystem::path(BURIN_SOURCE_DIRECTORY) / "resources/samples/mouse.step";
}

inline ImportOptions options() {
    ImportOptions options;
    options.worker = worker();
    return options;
}

inline Result<Model> import(const std::filesystem::path& file) {
    Progress progress;
    return importModel(file, options(), progress);
}

/// Text for the message of a failing check.
inline std::string describe(const Error& error) {
    return "error " + std::to_string(static_cast<int>(error.code)) + ": " + error.subject + " | " + error.place +
           " | " + error.detail;
}

inline bool hasNote(const Model& model, ImportNote::Kind kind) {
    for (const ImportNote& note : model.notes)
        if (note.kind == kind) return true;
    return false;
}

/// A model that consists of a B-rep only.
inline Model withBrep(std::string brep) {
    Model model;
    model.brep = std::move(brep);
    return model;
}

/// Exact signed distances from a model, mm; empty if that failed.
inline std::vector<double> distances(const Model& model, const std::vector<glm::dvec3>& points) {
    Progress progress;
    Result<std::vector<double>> result = exactSignedDistances(model, points, options(), progress);
    return result ? std::move(*result) : std::vector<double>{};
}

} // namespace burin::test

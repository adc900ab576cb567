// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"
#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// One solid of a model, in mm and in the model's frame (placements of an assembly applied).
struct Body {
    std::string name;                                  ///< as in the file; "Body 1" … where it has none
    std::optional<std::array<std::uint8_t, 3>> colour; ///< sRGB, where the file has one
    double volume = 0.0; ///< mm³: of the B-rep, tolerance 1e-6; of the mesh where there is no B-rep
    double area = 0.0;   ///< mm²
    Box box;             ///< tight
    TriangleMesh mesh;   ///< chord `Model::meshChord`, closed unless `openEdges` > 0
    std::size_t openEdges = 0;
    std::size_t faceCount = 0; ///< B-rep faces; 0 for a mesh file
};

/// What importing found, healed or could not heal; in the order of its steps.
struct ImportNote {
    enum class Kind { unit, healing, warning } kind = Kind::warning;
    std::string text; ///< English, for report and log
};

/// A CAD model: as its file has it, or as it lies in a setup.
struct Model {
    std::string sourceFile; ///< absolute path
    std::string format;     ///< "STEP AP214", "IGES", "BREP", "STL binary", "STL ASCII"
    std::string lengthUnit; ///< of the file: "mm", "inch", "m", …; "none" for STL
    double unitScale = 1.0; ///< mm per unit of the file
    double meshChord = 0.0; ///< mm, chord of the bodies' meshes; 0 for a mesh file
    std::vector<Body> bodies;
    std::vector<ImportNote> notes;
    std::string brep; ///< healed B-rep, OpenCASCADE binary form; empty for a mesh file
    /// Which of the B-rep's solids the bodies are, in order, where the model is a part of an imported one; empty: all.
    std::vector<std::uint32_t> brepSolids;
    Placement brepPlacement; ///< from the B-rep's frame to the model's

    Box box() const;       ///< of all bodies, mm, frame of the model; empty without any
    double volume() const; ///< of all bodies, mm³
};

/// A model as it lies in another frame: meshes and boxes there, the B-rep with another `brepPlacement`. A mirrored one
/// is another part than the file has. Neither turned nor moved, it is the same one, shared.
std::shared_ptr<const Model> placed(std::shared_ptr<const Model> model, const Placement& placement);

} // namespace burin

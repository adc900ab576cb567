// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/face_colours.h"
#include "core/geometry/placement.h"
#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// sRGB; empty: none of its own.
using BodyColour = std::optional<std::array<std::uint8_t, 3>>;

/// One solid of a model, in mm and in the model's frame (placements of an assembly applied).
struct Body {
    std::string name;    ///< as in the file, with the path of its assemblies (body_path.h); "Body 1" … if it has none
    BodyColour colour;   ///< that of the file, or chosen by the user
    double volume = 0.0; ///< mm³: of the B-rep, tolerance 1e-6; of the mesh where there is no B-rep
    double area = 0.0;   ///< mm²
    Box box;             ///< tight
    TriangleMesh mesh;   ///< chord `Model::meshChord`, closed unless `openEdges` > 0
    std::size_t openEdges = 0;
    std::size_t faceCount = 0; ///< B-rep faces; 0 for a mesh file
    FaceColours faceColours;   ///< of the triangles of `mesh` whose faces have a colour of their own
};

/// What the import found, healed or could not heal, in the order of its steps.
struct ImportNote {
    enum class Kind { unit, healing, warning, leftOut } kind = Kind::warning;
    std::string text; ///< English, for report and log
};

/// A CAD model, either as in its file or placed in a setup.
struct Model {
    std::string sourceFile;  ///< absolute path
    std::string format;      ///< "STEP AP214", "IGES", "BREP", "STL binary", "STL ASCII"
    std::string lengthUnit;  ///< that the file states: "mm", "inch", "m", …; "none" for STL
    double unitScale = 1.0;  ///< mm per unit of the file, as used
    double statedUnit = 0.0; ///< mm per unit that the file states, or that its format means; 0: none
    double meshChord = 0.0;  ///< mm, chord of the bodies' meshes; 0 for a mesh file
    std::vector<Body> bodies;
    std::vector<ImportNote> notes;
    std::string brep; ///< healed B-rep, OpenCASCADE binary form; empty for a mesh file
    /// Numbers of the B-rep's solids that are the bodies, in order, if the model is a part of an imported one; empty:
    /// all.
    std::vector<std::uint32_t> brepSolids;
    Placement brepPlacement; ///< from the B-rep's frame to the model's

    Box box() const;       ///< of all bodies, mm, frame of the model; empty if there are none
    double volume() const; ///< of all bodies, mm³
};

/// Returns the model placed in another frame: meshes and boxes are transformed, the B-rep gets another `brepPlacement`.
/// A mirrored model is a different part from that in the file. If the placement neither rotates nor moves it, the same
/// model is returned, shared.
std::shared_ptr<const Model> placed(std::shared_ptr<const Model> model, const Placement& placement);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <TopoDS_Solid.hxx>

#include <functional>
#include <span>

namespace burin {

/// A closed solid, material inside.
struct NamedSolid {
    TopoDS_Solid solid;
    std::string name;
    BodyColour colour;      ///< sRGB
    std::string assembly{}; ///< as NamedShape::assembly
    PlacedPart from{};
    std::vector<BodyColour> faceColours{}; ///< as NamedShape::faceColours
};

/// Returns the names of the solids' bodies, each of them unique: the path of the assembly, and the name in the file, or
/// one with its number (from 1) if the file has none.
std::vector<std::string> bodyNames(std::span<const NamedSolid> solids);

/// Called with the number of shapes that are done, and of all.
using ReportShapes = std::function<void(std::size_t done, std::size_t total)>;

/// Returns the solids of a file: unchanged if they are valid, healed if not, sewn from loose faces if there is no
/// solid. Changes are added to `file.notes`. Error, with an empty subject: modelHasNoSolid (detail:
/// `file.missingFiles`).
Result<std::vector<NamedSolid>> makeSolids(CadFile& file, const ReportShapes& report = {});

/// OpenCASCADE's general repair of a shape (ShapeFix).
TopoDS_Shape healed(const TopoDS_Shape& shape);

} // namespace burin

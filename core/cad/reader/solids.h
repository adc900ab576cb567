// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <TopoDS_Solid.hxx>

namespace burin {

/// A closed solid, material inside.
struct NamedSolid {
    TopoDS_Solid solid;
    std::string name;
    std::optional<std::array<std::uint8_t, 3>> colour; ///< sRGB
};

/// As the solid's body is called: as in the file, where that says nothing by its number (from 1).
std::string bodyName(const NamedSolid& solid, std::size_t number);

/// The solids of a file: as they are where they are valid, healed where not, sewn from loose faces where there is no
/// solid. What was done is added to `file.notes`. Error, with an empty subject: modelHasNoSolid (detail:
/// `file.missingFiles`).
Result<std::vector<NamedSolid>> makeSolids(CadFile& file);

/// OpenCASCADE's general repair of a shape (ShapeFix).
TopoDS_Shape healed(const TopoDS_Shape& shape);

} // namespace burin

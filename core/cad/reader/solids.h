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

/// Returns the name of the solid's body: that in the file, or one with its number (from 1) if the file has none.
std::string bodyName(const NamedSolid& solid, std::size_t number);

/// Returns the solids of a file: unchanged if they are valid, healed if not, sewn from loose faces if there is no
/// solid. Changes are added to `file.notes`. Error, with an empty subject: modelHasNoSolid (detail:
/// `file.missingFiles`).
Result<std::vector<NamedSolid>> makeSolids(CadFile& file);

/// OpenCASCADE's general repair of a shape (ShapeFix).
TopoDS_Shape healed(const TopoDS_Shape& shape);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <TDocStd_Document.hxx>

namespace burin {

/// Returns the shapes of an OpenCASCADE document with names and colours: assemblies resolved, placements applied.
std::vector<NamedShape> documentShapes(const Handle(TDocStd_Document) & document);

/// Returns one entry for each solid of a shape and one for everything that belongs to no solid; the placement is
/// applied to the geometry.
std::vector<NamedShape> explodedShapes(const TopoDS_Shape& shape, const std::string& name,
                                       const std::optional<std::array<std::uint8_t, 3>>& colour);

} // namespace burin

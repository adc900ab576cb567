// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <TDocStd_Document.hxx>

namespace burin {

/// The shapes of an OpenCASCADE document: assemblies resolved, placements applied, with names and colours.
std::vector<NamedShape> documentShapes(const Handle(TDocStd_Document) & document);

/// One entry for each solid of a shape and one for what belongs to none; the placement is worked into the geometry.
std::vector<NamedShape> explodedShapes(const TopoDS_Shape& shape, const std::string& name,
                                       const std::optional<std::array<std::uint8_t, 3>>& colour);

} // namespace burin

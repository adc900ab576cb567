// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"

#include <TDocStd_Document.hxx>

namespace burin {

/// Returns the shapes of an OpenCASCADE document with their assemblies, names and colours; placements are applied.
std::vector<NamedShape> documentShapes(const Handle(TDocStd_Document) & document);

/// Returns one entry for each solid of a shape and one for everything that belongs to no solid; the placement is
/// applied to the geometry.
std::vector<NamedShape> explodedShapes(const TopoDS_Shape& shape, const std::string& name, const BodyColour& colour);

} // namespace burin

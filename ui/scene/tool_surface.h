// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

namespace burin {

/// The surface of one piece of a tool, mm, tip at the origin, axis +Z, with normals.
vtkSmartPointer<vtkPolyData> pieceSurface(const RevolvedPiece& piece);

/// The surfaces of several pieces, as one.
vtkSmartPointer<vtkPolyData> piecesSurface(std::span<const RevolvedPiece> pieces);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/face_colours.h"
#include "core/cad/reader/solids.h"

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>

#include <span>
#include <vector>

namespace burin {

/// Colours of faces; a face is the same in either orientation.
using ColoursByFace = NCollection_DataMap<TopoDS_Shape, std::array<std::uint8_t, 3>, TopTools_ShapeMapHasher>;

/// Returns the colours of a shape's faces as in NamedShape::faceColours.
std::vector<BodyColour> coloursIn(const TopoDS_Shape& shape, const ColoursByFace& colours);
/// The inverse of coloursIn.
ColoursByFace coloursByFace(const TopoDS_Shape& shape, const std::vector<BodyColour>& faceColours);

/// The colours in which a solid is drawn.
struct SolidColours {
    BodyColour body;
    std::vector<BodyColour> faces; ///< of `meshedFaces`, in order, where they differ from `body`; empty: none does
};
/// If every face has a colour of its own, that of most faces becomes the colour of the body, whose own colour would
/// otherwise be seen nowhere.
SolidColours coloursOf(const NamedSolid& solid);

/// @param faceOf number of the face of each triangle of a mesh, in `meshedFaces`
FaceColours faceColoursOf(const SolidColours& colours, std::span<const std::uint32_t> faceOf);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solid_colours.h"

#include "core/cad/reader/shape_mesh.h"

#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <map>

namespace burin {

namespace {

BodyColour colourIn(const TopoDS_Shape& face, const ColoursByFace& colours) {
    const auto* const colour = colours.Seek(face);
    return colour == nullptr ? BodyColour() : BodyColour(*colour);
}

/// Empty unless every face has a colour.
BodyColour mostFrequent(const std::vector<BodyColour>& faces) {
    std::map<std::array<std::uint8_t, 3>, std::size_t> counts;
    for (const BodyColour& face : faces) {
        if (!face) return std::nullopt;
        ++counts[*face];
    }
    const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    return most == counts.end() ? BodyColour() : BodyColour(most->first);
}

} // namespace

std::vector<BodyColour> coloursIn(const TopoDS_Shape& shape, const ColoursByFace& colours) {
    std::vector<BodyColour> inOrder;
    if (colours.IsEmpty()) return inOrder;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        inOrder.push_back(colourIn(faces.Current(), colours));
    if (std::ranges::none_of(inOrder, &BodyColour::has_value)) inOrder.clear();
    return inOrder;
}

ColoursByFace coloursByFace(const TopoDS_Shape& shape, const std::vector<BodyColour>& faceColours) {
    ColoursByFace colours;
    auto colour = faceColours.begin();
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More() && colour != faceColours.end(); faces.Next(), ++colour)
        if (*colour) colours.Bind(faces.Current(), **colour);
    return colours;
}

SolidColours coloursOf(const NamedSolid& solid) {
    SolidColours colours{solid.colour, {}};
    if (solid.faceColours.empty()) return colours;
    const ColoursByFace byFace = coloursByFace(solid.solid, solid.faceColours);
    for (const TopoDS_Face& face : meshedFaces(solid.solid)) colours.faces.push_back(colourIn(face, byFace));
    if (const BodyColour most = mostFrequent(colours.faces)) colours.body = most;
    for (BodyColour& face : colours.faces)
        if (face == colours.body) face.reset();
    if (std::ranges::none_of(colours.faces, &BodyColour::has_value)) colours.faces.clear();
    return colours;
}

FaceColours faceColoursOf(const SolidColours& colours, std::span<const std::uint32_t> faceOf) {
    FaceColours found;
    if (colours.faces.empty()) return found;
    for (std::uint32_t triangle = 0; triangle < faceOf.size(); ++triangle)
        if (faceOf[triangle] < colours.faces.size())
            if (const BodyColour& colour = colours.faces[faceOf[triangle]]) append(found, {triangle, 1, *colour});
    return found;
}

} // namespace burin

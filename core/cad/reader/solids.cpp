// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solids.h"

#include "core/cad/body_path.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/left_out.h"
#include "core/cad/reader/solid_colours.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <span>
#include <string_view>

namespace burin {

using import_notes::fill;

namespace {

constexpr double sewingTolerance = 1e-3; // mm; design value for IGES, whose faces are not connected

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    return parts.Extent();
}

std::string counted(int number, std::string_view singular) {
    return std::to_string(number) + " " + std::string(singular) + (number == 1 ? "" : "s");
}

std::string counted(int number, TextId one, TextId several) {
    return number == 1 ? one.text : fill(several, {std::to_string(number)});
}

std::string quoted(const NamedShape& entry, std::size_t number) {
    return entry.name.empty() ? fill(import_notes::unnamedSolid, {std::to_string(number)})
                              : "\"" + bodyPath(entry.assembly, entry.name) + "\"";
}

void note(CadFile& file, ImportNote::Kind kind, std::string text) {
    file.notes.push_back({kind, std::move(text)});
}

/// Returns the colours of loose faces after sewing: their own or, where the entries differ, that of their entry.
ColoursByFace sewnColours(std::span<const NamedShape> loose, const BRepBuilderAPI_Sewing& sewing) {
    const bool differ =
        std::ranges::any_of(loose, [&](const NamedShape& entry) { return entry.colour != loose.front().colour; });
    ColoursByFace colours;
    for (const NamedShape& entry : loose) {
        auto own = entry.faceColours.begin();
        for (TopExp_Explorer faces(entry.shape, TopAbs_FACE); faces.More(); faces.Next()) {
            BodyColour colour = own == entry.faceColours.end() ? BodyColour() : *own++;
            if (!colour && differ) colour = entry.colour;
            if (colour) colours.Bind(sewing.ModifiedSubShape(faces.Current()), *colour);
        }
    }
    return colours;
}

/// The closed shells among loose faces, as solids.
struct SewnSolids {
    std::vector<TopoDS_Solid> solids;
    ColoursByFace colours;
};

SewnSolids sewn(std::span<const NamedShape> loose, int& openEdges) {
    BRepBuilderAPI_Sewing sewing(sewingTolerance);
    for (const NamedShape& entry : loose) sewing.Add(entry.shape);
    sewing.Perform();
    openEdges += sewing.NbFreeEdges();
    SewnSolids found{{}, sewnColours(loose, sewing)};
    for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next()) {
        const TopoDS_Shell shell = TopoDS::Shell(shells.Current());
        if (!BRep_Tool::IsClosed(shell)) continue;
        BRepBuilderAPI_MakeSolid solid(shell);
        if (solid.IsDone()) found.solids.push_back(solid.Solid());
    }
    return found;
}

/// Repairs a shape. @param colours as NamedShape::faceColours; replaced by those of the repaired shape
/// @param lost receives the number of coloured faces that the result does not have
TopoDS_Shape repaired(const TopoDS_Shape& shape, std::vector<BodyColour>& colours, std::size_t& lost) {
    const Handle(ShapeFix_Shape) fix = new ShapeFix_Shape(shape);
    fix->Perform();
    TopoDS_Shape result = fix->Shape();
    if (colours.empty()) return result;
    TopTools_IndexedMapOfShape there;
    TopExp::MapShapes(result, TopAbs_FACE, there);
    const ColoursByFace before = coloursByFace(shape, colours);
    ColoursByFace after;
    for (ColoursByFace::Iterator face(before); face.More(); face.Next()) {
        bool found = false;
        for (TopExp_Explorer parts(fix->Context()->Apply(face.Key()), TopAbs_FACE); parts.More(); parts.Next()) {
            if (!there.Contains(parts.Current())) continue;
            after.Bind(parts.Current(), face.Value());
            found = true;
        }
        lost += found ? 0 : 1;
    }
    colours = coloursIn(result, after);
    return result;
}

/// Repairs one solid if needed, and orients it so that its material is inside.
void addHealed(CadFile& file, const NamedShape& from, std::vector<NamedSolid>& solids) {
    const std::string title = quoted(from, solids.size() + 1);
    TopoDS_Shape shape = from.shape;
    std::vector<BodyColour> colours = from.faceColours;
    if (!BRepCheck_Analyzer(shape).IsValid()) {
        std::size_t lost = 0;
        shape = repaired(shape, colours, lost);
        noteLostFaceColours(file, lost);
        if (BRepCheck_Analyzer(shape).IsValid())
            note(file, ImportNote::Kind::healing, fill(import_notes::repaired, {title}));
        else
            note(file, ImportNote::Kind::warning, fill(import_notes::notRepaired, {title}));
    }
    const PlacedPart part = count(shape, TopAbs_SOLID) == 1 ? from.from : PlacedPart();
    const ColoursByFace byFace = coloursByFace(shape, colours);
    for (TopExp_Explorer parts(shape, TopAbs_SOLID); parts.More(); parts.Next()) {
        TopoDS_Solid solid = TopoDS::Solid(parts.Current());
        if (count(solid, TopAbs_FACE) == 0) {
            note(file, ImportNote::Kind::warning, fill(import_notes::solidEmpty, {title}));
            continue;
        }
        const TopAbs_Orientation before = solid.Orientation();
        if (!BRepLib::OrientClosedSolid(solid))
            note(file, ImportNote::Kind::warning, fill(import_notes::solidOpen, {title}));
        else if (solid.Orientation() != before)
            note(file, ImportNote::Kind::healing, fill(import_notes::insideOut, {title}));
        solids.push_back({solid, from.name, from.colour, from.assembly, part, coloursIn(solid, byFace)});
    }
}

int countFaces(std::span<const NamedShape> entries) {
    int faces = 0;
    for (const NamedShape& entry : entries) faces += count(entry.shape, TopAbs_FACE);
    return faces;
}

/// Adds the solids that several entries of loose faces form together; returns false if there are none. Names,
/// assemblies or colours of the entries are used for the solid only if all are the same; different colours become those
/// of its faces.
bool addSewn(CadFile& file, std::span<const NamedShape> loose, std::vector<NamedSolid>& solids, int& openEdges) {
    const SewnSolids closed = sewn(loose, openEdges);
    NamedShape entry = loose.front();
    for (const NamedShape& other : loose) {
        if (other.name != entry.name) entry.name.clear();
        if (other.colour != entry.colour) entry.colour.reset();
        if (other.assembly != entry.assembly) entry.assembly.clear();
    }
    int left = countFaces(loose);
    for (const TopoDS_Solid& solid : closed.solids) {
        const int faces = count(solid, TopAbs_FACE);
        left -= faces;
        note(file, ImportNote::Kind::healing, counted(faces, import_notes::faceSewn, import_notes::facesSewn));
        entry.shape = solid;
        entry.faceColours = coloursIn(solid, closed.colours);
        addHealed(file, entry, solids);
    }
    if (!closed.solids.empty() && left > 0)
        note(file, ImportNote::Kind::warning, counted(left, import_notes::faceLeftOut, import_notes::facesLeftOut));
    return !closed.solids.empty();
}

/// Describes the content of a file without a solid.
std::string contents(const CadFile& file, int openEdges) {
    int faces = 0, edges = 0;
    for (const NamedShape& entry : file.shapes) {
        faces += count(entry.shape, TopAbs_FACE);
        edges += count(entry.shape, TopAbs_EDGE);
    }
    if (faces > 0) return counted(faces, "face") + " with " + counted(openEdges, "open edge");
    return edges > 0 ? counted(edges, "edge") : std::string("no shape");
}

} // namespace

std::vector<std::string> bodyNames(std::span<const NamedSolid> solids) {
    std::vector<std::string> names;
    for (const NamedSolid& solid : solids)
        names.push_back(bodyPath(
            solid.assembly,
            solid.name.empty() ? fill(import_notes::unnamedBody, {std::to_string(names.size() + 1)}) : solid.name));
    numberInstances(names);
    return names;
}

TopoDS_Shape healed(const TopoDS_Shape& shape) {
    std::vector<BodyColour> colours;
    std::size_t lost = 0;
    return repaired(shape, colours, lost);
}

Result<std::vector<NamedSolid>> makeSolids(CadFile& file, const ReportShapes& report) {
    std::vector<NamedSolid> solids;
    std::vector<NamedShape> loose; // entries that form no solid by themselves
    int looseEdges = 0, openEdges = 0;
    std::size_t done = 0;
    for (const NamedShape& entry : file.shapes) {
        if (report) report(done++, file.shapes.size());
        if (count(entry.shape, TopAbs_SOLID) > 0)
            addHealed(file, entry, solids);
        else if (count(entry.shape, TopAbs_FACE) == 0)
            ++looseEdges;
        else if (!addSewn(file, {&entry, 1}, solids, openEdges))
            loose.push_back(entry);
    }
    // Many IGES files have a separate entry for each face.
    if (loose.size() > 1) {
        openEdges = 0;
        if (addSewn(file, loose, solids, openEdges)) loose.clear();
    }
    if (solids.empty()) return Error{ErrorCode::modelHasNoSolid, {}, contents(file, openEdges), file.missingFiles};
    if (!file.missingFiles.empty())
        note(file, ImportNote::Kind::warning, fill(import_notes::partsMissing, {file.missingFiles}));
    if (const int faces = countFaces(loose); faces > 0)
        note(file, ImportNote::Kind::warning, counted(faces, import_notes::faceLeftOut, import_notes::facesLeftOut));
    if (looseEdges > 0) note(file, ImportNote::Kind::warning, import_notes::curvesLeftOut.text);
    return solids;
}

} // namespace burin

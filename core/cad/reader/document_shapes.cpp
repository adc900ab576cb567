// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/document_shapes.h"

#include "core/cad/body_path.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/solid_colours.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// The data that a label passes on to the labels below it.
struct Inherited {
    TopLoc_Location place;
    std::string assembly; ///< path of the assemblies around it
    std::string name;     ///< its own; may be empty
    std::string instance; ///< its own with its number among instances of that name
    BodyColour colour;
};

std::uint8_t channel(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

BodyColour toColour(const Quantity_Color& colour) {
    double red = 0.0, green = 0.0, blue = 0.0;
    colour.Values(red, green, blue, Quantity_TOC_sRGB);
    return std::array<std::uint8_t, 3>{channel(red), channel(green), channel(blue)};
}

/// The name of a label, as an element of a path.
std::string nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()), '\0');
    Standard_PCharacter start = text.data();
    name->Get().ToUTF8CString(start);
    return pathElement(text);
}

/// Applies the placement to the geometry, so that meshing and measuring use only one frame.
TopoDS_Shape placed(const TopoDS_Shape& shape) {
    if (shape.Location().IsIdentity()) return shape;
    const gp_Trsf move = shape.Location().Transformation();
    return BRepBuilderAPI_Transform(shape.Located(TopLoc_Location()), move, Standard_True).Shape();
}

/// Returns the faces and edges outside of every solid in one compound; null if there are none.
TopoDS_Shape outsideSolids(const TopoDS_Shape& shape) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    bool any = false;
    const auto collect = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum avoid) {
        for (TopExp_Explorer parts(shape, kind, avoid); parts.More(); parts.Next(), any = true)
            builder.Add(compound, parts.Current());
    };
    collect(TopAbs_FACE, TopAbs_SOLID);
    collect(TopAbs_EDGE, TopAbs_FACE);
    return any ? TopoDS_Shape(compound) : TopoDS_Shape();
}

bool hasSolid(const TopoDS_Shape& shape) {
    return TopExp_Explorer(shape, TopAbs_SOLID).More();
}

class DocumentReader {
public:
    explicit DocumentReader(const Handle(TDocStd_Document) & document)
        : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main()))
        , colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

    std::vector<NamedShape> read() {
        TDF_LabelSequence labels;
        shapes_->GetFreeShapes(labels);
        std::vector<Entry> roots;
        for (const TDF_Label& label : labels) roots.push_back({label, {{}, {}, nameOf(label), {}, colourOf(label)}});
        numberEntries(roots);
        for (const Entry& root : roots) visit(root, true);
        return std::move(found_);
    }

private:
    struct Entry {
        TDF_Label label;
        Inherited data;
    };

    BodyColour colourOf(const TDF_Label& label) const {
        Quantity_Color colour;
        if (colours_->GetColor(label, XCAFDoc_ColorSurf, colour) || colours_->GetColor(label, XCAFDoc_ColorGen, colour))
            return toColour(colour);
        return std::nullopt;
    }

    /// Only what has a solid is numbered: loose faces of one name may become one solid of that name.
    static void numberEntries(std::vector<Entry>& entries) {
        std::vector<std::string> names;
        for (const Entry& entry : entries)
            names.push_back(hasSolid(XCAFDoc_ShapeTool::GetShape(entry.label)) ? entry.data.name : std::string());
        numberInstances(names);
        for (std::size_t i = 0; i < entries.size(); ++i)
            entries[i].data.instance = names[i].empty() ? entries[i].data.name : names[i];
    }

    void visit(const Entry& entry, bool root) {
        if (XCAFDoc_ShapeTool::IsAssembly(entry.label))
            visitAssembly(entry, root);
        else
            visitPart(entry, root);
    }

    void visitAssembly(const Entry& entry, bool root) {
        const Inherited& from = entry.data;
        std::string path = from.assembly;
        if (!from.instance.empty())
            path = bodyPath(from.assembly, from.instance);
        else if (!root) // nothing stands beside most roots, so a name that the file doesn't have would tell nothing
            path = bodyPath(from.assembly,
                            import_notes::fill(import_notes::unnamedAssembly, {std::to_string(++unnamed_)}));
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(entry.label, components);
        std::vector<Entry> below;
        for (const TDF_Label& component : components) {
            TDF_Label part;
            if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
            const std::string name = nameOf(part).empty() ? nameOf(component) : nameOf(part);
            Inherited data{from.place * XCAFDoc_ShapeTool::GetLocation(component), path, name, {}, from.colour};
            // The colour of the outermost coloured placement overrides those below it, like STEP's overriding styles.
            if (const BodyColour colour = colourOf(component); colour && !from.colour) data.colour = colour;
            below.push_back({part, std::move(data)});
        }
        numberEntries(below);
        for (const Entry& next : below) visit(next, false);
    }

    /// A part of several solids is to its bodies what an assembly is, unless it is all of the file.
    void visitPart(const Entry& entry, bool root) {
        const Inherited& from = entry.data;
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(entry.label);
        const ColoursByFace faces = coloursOfFaces(entry.label);
        std::size_t count = 0;
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) ++count;
        const bool several = count > 1 && !root && !from.instance.empty();
        std::size_t number = 0;
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
            const std::string own = nameOfSolid(entry.label, solids.Current());
            const TopoDS_Shape moved = solids.Current().Moved(from.place);
            NamedShape solid{placed(moved), own, {}, from.assembly};
            solid.from = {moved.Located(TopLoc_Location()), moved.Location().Transformation()};
            ++number;
            if (several) solid.assembly = bodyPath(from.assembly, from.instance);
            if (count == 1 && !from.instance.empty() && (own.empty() || !root)) solid.name = from.instance;
            if (count > 1 && own.empty() && !from.name.empty()) solid.name = from.name + " " + std::to_string(number);
            solid.colour = colourOfSolid(entry, solids.Current());
            solid.faceColours = coloursIn(solids.Current(), faces);
            found_.push_back(std::move(solid));
        }
        const TopoDS_Shape loose = outsideSolids(shape);
        if (!loose.IsNull())
            found_.push_back({placed(loose.Moved(from.place)),
                              from.name,
                              colourOfSolid(entry, loose),
                              from.assembly,
                              {},
                              coloursIn(loose, faces)});
    }

    std::string nameOfSolid(const TDF_Label& part, const TopoDS_Shape& solid) const {
        TDF_Label label;
        return shapes_->FindSubShape(part, solid, label) ? nameOf(label) : std::string();
    }

    ColoursByFace coloursOfFaces(const TDF_Label& part) const {
        TDF_LabelSequence labels;
        XCAFDoc_ShapeTool::GetSubShapes(part, labels);
        ColoursByFace faces;
        for (const TDF_Label& label : labels) {
            const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
            if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE) continue;
            if (const BodyColour colour = colourOf(label)) faces.Bind(shape, *colour);
        }
        return faces;
    }

    /// The colour that a solid inherits, its own, or that of its part, in this order. Colours of its faces are drawn
    /// over it, as in OpenCASCADE's own viewer.
    BodyColour colourOfSolid(const Entry& entry, const TopoDS_Shape& solid) const {
        if (entry.data.colour) return entry.data.colour;
        TDF_Label label;
        const BodyColour own = shapes_->FindSubShape(entry.label, solid, label) ? colourOf(label) : std::nullopt;
        return own ? own : colourOf(entry.label);
    }

    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    std::vector<NamedShape> found_;
    std::size_t unnamed_ = 0; ///< assemblies without a name so far
};

} // namespace

std::vector<NamedShape> documentShapes(const Handle(TDocStd_Document) & document) {
    return DocumentReader(document).read();
}

std::vector<NamedShape> explodedShapes(const TopoDS_Shape& shape, const std::string& name, const BodyColour& colour) {
    std::vector<NamedShape> shapes;
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
        shapes.push_back({placed(solids.Current()), name, colour});
    const TopoDS_Shape loose = outsideSolids(shape);
    if (!loose.IsNull()) shapes.push_back({placed(loose), name, colour});
    return shapes;
}

} // namespace burin

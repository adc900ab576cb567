// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/document_shapes.h"

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
#include <map>

namespace burin {

namespace {

using Colour = std::optional<std::array<std::uint8_t, 3>>;

/// The data that a label passes on to the labels below it.
struct Inherited {
    TopLoc_Location place;
    std::string name;
    Colour colour;
};

std::uint8_t channel(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

Colour toColour(const Quantity_Color& colour) {
    double red = 0.0, green = 0.0, blue = 0.0;
    colour.Values(red, green, blue, Quantity_TOC_sRGB);
    return std::array<std::uint8_t, 3>{channel(red), channel(green), channel(blue)};
}

std::string nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()), '\0');
    Standard_PCharacter start = text.data();
    name->Get().ToUTF8CString(start);
    return text;
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

class DocumentReader {
public:
    explicit DocumentReader(const Handle(TDocStd_Document) & document)
        : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main()))
        , colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

    std::vector<NamedShape> read() {
        TDF_LabelSequence roots;
        shapes_->GetFreeShapes(roots);
        for (const TDF_Label& root : roots) visit(root, {{}, nameOf(root), colourOf(root)});
        return std::move(found_);
    }

private:
    Colour colourOf(const TDF_Label& label) const {
        Quantity_Color colour;
        if (colours_->GetColor(label, XCAFDoc_ColorSurf, colour) || colours_->GetColor(label, XCAFDoc_ColorGen, colour))
            return toColour(colour);
        return std::nullopt;
    }

    /// Returns the most frequent colour of a solid's faces.
    Colour colourOfFaces(const TDF_Label& part, const TopoDS_Shape& solid) const {
        std::map<std::array<std::uint8_t, 3>, int> counts;
        for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
            TDF_Label label;
            if (!shapes_->FindSubShape(part, faces.Current(), label)) continue;
            if (const Colour colour = colourOf(label)) ++counts[*colour];
        }
        const auto most = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        return most == counts.end() ? Colour() : Colour(most->first);
    }

    void visit(const TDF_Label& label, const Inherited& from) {
        if (!XCAFDoc_ShapeTool::IsAssembly(label)) return visitPart(label, from);
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(label, components);
        for (const TDF_Label& component : components) {
            TDF_Label part;
            if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
            Inherited below = from;
            below.place = from.place * XCAFDoc_ShapeTool::GetLocation(component);
            below.name = nameOf(part).empty() ? nameOf(component) : nameOf(part);
            // The colour of the outermost coloured placement overrides those below it, like STEP's overriding styles.
            if (const Colour colour = colourOf(component); colour && !from.colour) below.colour = colour;
            visit(part, below);
        }
    }

    void visitPart(const TDF_Label& part, const Inherited& from) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
        std::size_t count = 0;
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) ++count;
        std::size_t number = 0;
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
            NamedShape entry = describe(part, solids.Current(), from);
            if (entry.name.empty() && !from.name.empty())
                entry.name = count > 1 ? from.name + " " + std::to_string(++number) : from.name;
            entry.shape = placed(solids.Current().Moved(from.place));
            found_.push_back(std::move(entry));
        }
        const TopoDS_Shape loose = outsideSolids(shape);
        if (!loose.IsNull())
            found_.push_back({placed(loose.Moved(from.place)), from.name, describe(part, loose, from).colour});
    }

    /// Own name and colour of a solid of a part.
    NamedShape describe(const TDF_Label& part, const TopoDS_Shape& solid, const Inherited& from) const {
        NamedShape entry;
        entry.colour = from.colour;
        TDF_Label label;
        if (shapes_->FindSubShape(part, solid, label)) {
            entry.name = nameOf(label);
            if (!entry.colour) entry.colour = colourOf(label);
        }
        if (!entry.colour) entry.colour = colourOf(part);
        if (!entry.colour) entry.colour = colourOfFaces(part, solid);
        return entry;
    }

    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    std::vector<NamedShape> found_;
};

} // namespace

std::vector<NamedShape> documentShapes(const Handle(TDocStd_Document) & document) {
    return DocumentReader(document).read();
}

std::vector<NamedShape> explodedShapes(const TopoDS_Shape& shape, const std::string& name,
                                       const std::optional<std::array<std::uint8_t, 3>>& colour) {
    std::vector<NamedShape> shapes;
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
        shapes.push_back({placed(solids.Current()), name, colour});
    const TopoDS_Shape loose = outsideSolids(shape);
    if (!loose.IsNull()) shapes.push_back({placed(loose), name, colour});
    return shapes;
}

} // namespace burin

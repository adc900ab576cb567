// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/cad/rounded_block.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Trsf.hxx>

#include <string>

namespace burin::test {

/// A STEP file in the making: parts and assemblies with names, placements and colours.
class AssemblyFile {
public:
    AssemblyFile() : document_(new TDocStd_Document("BinXCAF")) {
        XCAFDoc_DocumentTool::Set(document_->Main(), Standard_False);
        shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
        colours_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
    }

    TDF_Label part(const TopoDS_Shape& shape, const char* name) {
        return named(shapes_->AddShape(shape, Standard_False), name);
    }
    TDF_Label assembly(const char* name) { return named(shapes_->NewShape(), name); }
    /// Puts an instance of a part or an assembly into an assembly. @param x mm
    void add(const TDF_Label& to, const TDF_Label& what, double x) {
        gp_Trsf move;
        move.SetTranslation(gp_Vec(x, 0.0, 0.0));
        shapes_->AddComponent(to, what, TopLoc_Location(move));
    }
    void colour(const TDF_Label& label, Quantity_NameOfColor colour) {
        colours_->SetColor(label, Quantity_Color(colour), XCAFDoc_ColorSurf);
    }
    void colourFace(const TDF_Label& part, const TopoDS_Shape& face, Quantity_NameOfColor colour) {
        this->colour(shapes_->AddSubShape(part, face), colour);
    }
    void layer(const TDF_Label& label, const char* name) {
        XCAFDoc_DocumentTool::LayerTool(document_->Main())->SetLayer(label, TCollection_ExtendedString(name));
    }
    /// @param unit "MM", "INCH", … of the file; the shapes are in mm
    bool write(const std::string& file, const char* unit = "MM") {
        shapes_->UpdateAssemblies();
        STEPCAFControl_Controller::Init();
        Interface_Static::SetCVal("write.step.unit", unit);
        STEPCAFControl_Writer writer;
        writer.SetLayerMode(Standard_True);
        const bool made =
            writer.Transfer(document_, STEPControl_AsIs) && writer.Write(file.c_str()) == IFSelect_RetDone;
        Interface_Static::SetCVal("write.step.unit", "MM");
        return made;
    }

private:
    static TDF_Label named(const TDF_Label& label, const char* name) {
        TDataStd_Name::Set(label, TCollection_ExtendedString(name, Standard_True));
        return label;
    }

    Handle(TDocStd_Document) document_;
    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
};

/// A vice: a plate of 40 × 30 × 5 mm with one face of another colour, two pairs of jaws 100 mm apart with two red bolts
/// each (⌀ 4 × 10 mm, 20 mm apart), a part of two cubes of 3 and 4 mm, and a bolt at 200 mm.
inline bool writeVice(const std::string& file) {
    AssemblyFile vice;
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(40.0, 30.0, 5.0).Shape();
    TopoDS_Compound cubes;
    BRep_Builder builder;
    builder.MakeCompound(cubes);
    builder.Add(cubes, BRepPrimAPI_MakeBox(3.0, 3.0, 3.0).Shape());
    builder.Add(cubes, BRepPrimAPI_MakeBox(gp_Pnt(10.0, 0.0, 0.0), 4.0, 4.0, 4.0).Shape());
    const TDF_Label base = vice.part(plate, "Plate/Base");
    const TDF_Label bolt = vice.part(BRepPrimAPI_MakeCylinder(2.0, 10.0).Shape(), "Bolt");
    const TDF_Label stops = vice.part(cubes, "Stops");
    vice.colour(bolt, Quantity_NOC_RED);
    vice.colour(base, Quantity_NOC_GREEN);
    vice.colourFace(base, TopExp_Explorer(plate, TopAbs_FACE).Current(), Quantity_NOC_BLUE1);
    vice.layer(base, "ground");
    const TDF_Label jaws = vice.assembly("Jaws"), whole = vice.assembly("Vice");
    vice.add(jaws, bolt, 0.0);
    vice.add(jaws, bolt, 20.0);
    vice.add(whole, base, 0.0);
    vice.add(whole, jaws, 0.0);
    vice.add(whole, jaws, 100.0);
    vice.add(whole, stops, 0.0);
    vice.add(whole, bolt, 200.0);
    return vice.write(file);
}

/// An assembly of rounded blocks, each with surfaces of its own: about 70 kB a block.
inline bool writeBlocks(const std::string& file, int count) {
    AssemblyFile blocks;
    const TDF_Label whole = blocks.assembly("Blocks");
    const TopoDS_Shape block = roundedBlock();
    for (int i = 0; i < count; ++i)
        blocks.add(whole, blocks.part(BRepBuilderAPI_Copy(block).Shape(), "Block"), 50.0 * i);
    return blocks.write(file);
}

} // namespace burin::test

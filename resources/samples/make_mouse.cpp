// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Makes resources/samples/mouse.step: a computer mouse, made for milling from above with three axes. Every vertical
// line meets it in one piece that starts at z = 0: the walls lean outward towards the bottom, the top is a height over
// x and y. Its edges are rounded with 5 mm and nothing concave is tighter than that, so that a ball of 6 mm reaches
// everything.
//
//     burin-make-mouse-sample FILE
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double halfLength = 55.0, halfWidth = 30.0; // mm, of the outline at the bottom
constexpr double wallTop = 45.0;                      // mm, where the walls end before the top is cut
constexpr double wallLean = 4.0;                      // mm that the walls lean inward up to there
constexpr double edgeRadius = 5.0;                    // mm

/// Height of the top, mm: a dome on a skirt, highest behind the middle and a little higher on the thumb's side.
double topHeight(double x, double y) {
    const double along = x / halfLength, across = y / halfWidth;
    const double dome = 1.0 - std::pow(std::abs(along), 2.4) - std::pow(std::abs(across), 2.4);
    return 11.0 - 1.5 * along + dome * (23.2 - 5.0 * along + 0.9 * across);
}

/// The outline at a distance inside that of the bottom: an oval, fuller at the palm, with a slight waist for the thumb.
gp_Pnt outlinePoint(double angle, double inside, double z) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double waist = 1.6 * std::exp(-std::pow((angle - pi / 2.0) / 0.45, 2.0));
    const double fullness = 2.5; // exponent of the superellipse
    const double radius = std::pow(std::pow(std::abs(cosine) / (halfLength - inside), fullness) +
                                       std::pow(std::abs(sine) / (halfWidth - waist - inside), fullness),
                                   -1.0 / fullness);
    return {radius * cosine, radius * sine * (1.0 - 0.05 * cosine), z};
}

TopoDS_Wire outline(double inside, double z) {
    constexpr int count = 48;
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    for (int i = 1; i <= count; ++i) points->SetValue(i, outlinePoint(2.0 * pi * (i - 1) / count, inside, z));
    GeomAPI_Interpolate curve(points, Standard_True, 1e-6);
    curve.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge()).Wire();
}

/// Everything between the leaning walls.
TopoDS_Shape walls() {
    BRepOffsetAPI_ThruSections sections(Standard_True, Standard_True);
    sections.AddWire(outline(0.0, 0.0));
    sections.AddWire(outline(wallLean, wallTop));
    sections.CheckCompatibility(Standard_False);
    sections.Build();
    return sections.Shape();
}

/// Everything below the top.
TopoDS_Shape belowTop() {
    constexpr int columns = 29, rows = 19;
    constexpr double reachX = 66.0, reachY = 38.0;
    TColgp_Array2OfPnt points(1, columns, 1, rows);
    for (int i = 1; i <= columns; ++i)
        for (int j = 1; j <= rows; ++j) {
            const double x = reachX * (2.0 * (i - 1) / (columns - 1) - 1.0);
            const double y = reachY * (2.0 * (j - 1) / (rows - 1) - 1.0);
            points.SetValue(i, j, gp_Pnt(x, y, topHeight(x, y)));
        }
    const GeomAPI_PointsToBSplineSurface surface(points, 3, 5, GeomAbs_C2, 0.01);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface.Surface(), 1e-6).Face();
    return BRepPrimAPI_MakePrism(face, gp_Vec(0.0, 0.0, -80.0)).Shape();
}

/// The edges between the top and the walls: all that do not lie in the bottom nor run up the walls.
void addTopEdges(BRepFilletAPI_MakeFillet& fillet, const TopoDS_Shape& solid) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        const gp_Pnt first = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), last = BRep_Tool::Pnt(TopExp::LastVertex(edge));
        if (std::min(first.Z(), last.Z()) > 1.0) fillet.Add(edgeRadius, edge);
    }
}

TopoDS_Solid makeMouse() {
    const TopoDS_Shape sharp = BRepAlgoAPI_Common(walls(), belowTop()).Shape();
    TopExp_Explorer body(sharp, TopAbs_SOLID);
    if (!body.More()) throw std::runtime_error("walls and top do not meet");
    BRepFilletAPI_MakeFillet fillet(body.Current());
    addTopEdges(fillet, body.Current());
    fillet.Build();
    if (!fillet.IsDone()) throw std::runtime_error("the edge can't be rounded");
    TopExp_Explorer rounded(fillet.Shape(), TopAbs_SOLID);
    if (!rounded.More() || !BRepCheck_Analyzer(rounded.Current()).IsValid())
        throw std::runtime_error("the rounded solid is not valid");
    return TopoDS::Solid(rounded.Current());
}

void writeStep(const TopoDS_Solid& solid, const char* file) {
    STEPCAFControl_Controller::Init();
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.product.name", "mouse");
    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    const TDF_Label label = XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(solid, Standard_False);
    TDataStd_Name::Set(label, "mouse");
    const Quantity_Color colour(0.25, 0.45, 0.65, Quantity_TOC_sRGB);
    XCAFDoc_DocumentTool::ColorTool(document->Main())->SetColor(label, colour, XCAFDoc_ColorSurf);
    STEPCAFControl_Writer writer;
    if (!writer.Transfer(document, STEPControl_AsIs) || writer.Write(file) != IFSelect_RetDone)
        throw std::runtime_error("the file can't be written");
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "burin-make-mouse-sample FILE\n";
        return EXIT_FAILURE;
    }
    try {
        writeStep(makeMouse(), arguments[1]);
    } catch (const Standard_Failure& failure) {
        std::cerr << failure.GetMessageString() << '\n';
        return EXIT_FAILURE;
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return EXIT_FAILURE;
    }
}

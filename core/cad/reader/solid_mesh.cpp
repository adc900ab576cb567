// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/solid_mesh.h"

#include "core/cad/reader/shape_mesh.h"
#include "core/cad/reader/solids.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <array>
#include <vector>

namespace burin {

namespace {

/// Whether an edge of a face is degenerated to a point, as where three rounded edges of a block meet.
bool hasPole(const TopoDS_Shape& solid) {
    for (TopExp_Explorer edges(solid, TopAbs_EDGE); edges.More(); edges.Next())
        if (BRep_Tool::Degenerated(TopoDS::Edge(edges.Current()))) return true;
    return false;
}

void runMesher(const TopoDS_Shape& solid, double chord, double angle, IMeshTools_MeshAlgoType algorithm,
               const ReportFraction& report) {
    BRepTools::Clean(solid);
    IMeshTools_Parameters parameters;
    parameters.MeshAlgo = algorithm;
    parameters.Deflection = chord;
    parameters.Angle = angle;
    parameters.Relative = Standard_False;
    parameters.InParallel = Standard_False; // one process with one thread, for which the time limit is exact
    parameters.MinSize = 0.1 * chord;
    // OpenCASCADE's own refinement of faces to the chord doesn't terminate at the pole of a rounded corner, and isn't
    // relied on: ShapeMesh::refine does it for every face. Elsewhere it needs fewer triangles.
    parameters.ControlSurfaceDeflection = !hasPole(solid);
    parameters.InternalVerticesMode = Standard_True;
    const Handle(ReaderProgress) progress = new ReaderProgress(report, 0.0, 1.0);
    BRepMesh_IncrementalMesh mesher(solid, parameters, progress->Start());
}

/// Returns the same surface with its closed faces divided in two halves each.
TopoDS_Shape withoutSeams(const TopoDS_Solid& solid) {
    ShapeUpgrade_ShapeDivideClosed division(healed(solid));
    division.Perform();
    return division.Result();
}

/// Null if there are no faces.
TopoDS_Compound compoundOf(const ShapeMesh& shape, const std::vector<std::size_t>& faces) {
    TopoDS_Compound compound;
    if (faces.empty()) return compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const std::size_t face : faces) builder.Add(compound, shape.face(face));
    return compound;
}

SolidMesh collect(const TopoDS_Shape& solid, double chord) {
    ShapeMesh shape(solid, chord);
    SolidMesh result;
    for (const std::size_t face : shape.emptyFaces())
        if (shape.fillPlaneFace(face))
            ++result.facesFilled;
        else
            ++result.facesWithoutTriangles;
    const std::vector<std::size_t> open = shape.facesAtOpenEdges();
    if (result.facesWithoutTriangles == 0)
        // A face that has triangles but is incomplete: filling it from its boundary closes it.
        for (const std::size_t face : open)
            if (shape.fillPlaneFace(face)) ++result.facesFilled;
    result.torn = compoundOf(shape, shape.tornFaces());
    if (result.facesWithoutTriangles == 0) {
        shape.refine();
        shape.partSharedChords();
    }
    result.mesh = shape.mesh(&result.faceOf);
    result.openEdges = countOpenEdges(result.mesh);
    return result;
}

std::size_t countOf(const TopoDS_Compound& faces) {
    return faces.IsNull() ? 0 : static_cast<std::size_t>(faces.NbChildren());
}

bool isBetter(const SolidMesh& a, const SolidMesh& b) {
    if (a.facesWithoutTriangles != b.facesWithoutTriangles) return a.facesWithoutTriangles < b.facesWithoutTriangles;
    if (countOf(a.torn) != countOf(b.torn)) return countOf(a.torn) < countOf(b.torn);
    return a.openEdges < b.openEdges;
}

struct Attempt {
    double part, angle; // of the chord; rad
    IMeshTools_MeshAlgoType algorithm = IMeshTools_MeshAlgoType_Watson;
    bool divides = false; // divides closed faces along their seams, if noise there makes the mesher fail
};

/// Whether an attempt meshes more of the incomplete faces. They are tried separately, as a large solid takes many
/// seconds.
bool promises(const Attempt& attempt, const TopoDS_Compound& torn, double chord) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(torn, Standard_False).Shape();
    const ReportFraction silent = [](double) {};
    runMesher(copy, attempt.part * chord, attempt.angle, attempt.algorithm, silent);
    return ShapeMesh(copy, chord).tornFaces().size() < countOf(torn);
}

} // namespace

SolidMesh meshSolid(const TopoDS_Solid& solid, double chord, const ReportFraction& report, bool careful) {
    constexpr auto delabella = IMeshTools_MeshAlgoType_Delabella;
    constexpr std::size_t usual = 5; // the others are for faces that otherwise get no mesh at all
    // The first is the fastest: its algorithm takes a third of the time, and with less than the chord along edges
    // hardly any triangle within a face needs splitting.
    constexpr std::array<Attempt, 7> attempts{{{0.8, 0.5, delabella},
                                               {1.0, 0.5},
                                               {0.7, 0.35},
                                               {0.9, 0.2},
                                               {0.4, 0.5},
                                               {1.0, 0.5, IMeshTools_MeshAlgoType_Watson, true},
                                               {0.9, 0.2, delabella, true}}};
    SolidMesh best;
    std::size_t made = 0;
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        if (i >= usual && best.facesWithoutTriangles == 0) break;
        if (careful && attempts[i].algorithm == delabella) continue;
        if (made > 0 && i < usual && !promises(attempts[i], best.torn, chord)) continue;
        const TopoDS_Shape shape = attempts[i].divides ? withoutSeams(solid) : TopoDS_Shape(solid);
        runMesher(shape, attempts[i].part * chord, attempts[i].angle, attempts[i].algorithm, report);
        SolidMesh result = collect(shape, chord);
        result.divided = attempts[i].divides;
        ++made;
        if (made == 1 || isBetter(result, best)) best = std::move(result);
        if (best.torn.IsNull()) break;
    }
    best.attempts = made;
    return best;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/preview.h"

#include "core/cad/reader/shape_mesh.h"
#include "core/cad/reader/solid_colours.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace burin {

namespace {

constexpr double relativeChord = 0.002; // of the model's diagonal: half a pixel to a pixel of a window
constexpr double angle = 0.4;           // rad between neighbours: less than the angle that is drawn as a crease
constexpr double leastGain = 4.0;       // smallest factor by which it must be coarser than the mesh

double processorSeconds() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// Stops the mesher between two faces when the time is up.
class TimeLimit final : public Message_ProgressIndicator {
public:
    Standard_Boolean UserBreak() override { return over(); }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}
    bool over() const { return processorSeconds() > end_; }

private:
    double end_ = processorSeconds() + previewSeconds;
};

bool hasCurvedFace(const TopoDS_Shape& solid) {
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
        if (BRepAdaptor_Surface(TopoDS::Face(faces.Current()), Standard_False).GetType() != GeomAbs_Plane) return true;
    return false;
}

/// Returns the diagonal of all solids, mm; 0 if they have no extent.
double diagonalOf(std::span<const NamedSolid> solids) {
    Bnd_Box box;
    for (const NamedSolid& solid : solids) BRepBndLib::Add(solid.solid, box, Standard_False);
    return box.IsVoid() || box.IsOpen() ? 0.0 : std::sqrt(box.SquareExtent());
}

/// @param faceOf receives the number of the face of each triangle, in `meshedFaces`
PreviewMesh meshCoarsely(const TopoDS_Solid& solid, double chord, const Handle(TimeLimit) & limit,
                         std::vector<std::uint32_t>& faceOf) {
    IMeshTools_Parameters parameters;
    parameters.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
    parameters.Deflection = chord;
    parameters.Angle = angle;
    parameters.Relative = Standard_False;
    parameters.InParallel = Standard_False;
    parameters.MinSize = 0.5 * chord;
    parameters.ControlSurfaceDeflection = Standard_False;
    parameters.InternalVerticesMode = Standard_True; // a face bulges between its edges
    BRepTools::Clean(solid);                         // the triangulation stored in the file
    const BRepMesh_IncrementalMesh mesher(solid, parameters, limit->Start());
    const TriangleMesh mesh = ShapeMesh(solid, chord).mesh(&faceOf);
    BRepTools::Clean(solid);
    PreviewMesh preview;
    preview.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
    preview.triangles = mesh.triangles;
    return preview;
}

} // namespace

std::optional<ModelPreview> previewOf(std::span<const NamedSolid> solids, double chord) try {
    const double coarse = relativeChord * diagonalOf(solids);
    if (!(coarse >= leastGain * chord)) return std::nullopt;
    if (std::ranges::none_of(solids, [](const NamedSolid& solid) { return hasCurvedFace(solid.solid); }))
        return std::nullopt;
    const Handle(TimeLimit) limit = new TimeLimit;
    ModelPreview preview;
    const std::vector<std::string> names = bodyNames(solids);
    for (const NamedSolid& solid : solids) {
        std::vector<std::uint32_t> faceOf;
        PreviewMesh mesh = meshCoarsely(solid.solid, coarse, limit, faceOf);
        if (limit->over()) return std::nullopt;
        const SolidColours colours = coloursOf(solid);
        preview.bodies.push_back(
            {names[preview.bodies.size()], colours.body, std::move(mesh), faceColoursOf(colours, faceOf)});
    }
    return preview;
} catch (const Standard_Failure&) {
    for (const NamedSolid& solid : solids) BRepTools::Clean(solid.solid);
    return std::nullopt;
}

} // namespace burin

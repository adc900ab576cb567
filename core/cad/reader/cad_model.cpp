// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_model.h"

#include "core/base/numbers.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/measure.h"
#include "core/cad/reader/preview.h"
#include "core/cad/reader/solid_mesh.h"
#include "core/cad/reader/solids.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <TopoDS_Compound.hxx>

#include <cmath>
#include <sstream>
#include <utility>

namespace burin {

using import_notes::fill;

namespace {

std::string encodeShape(const TopoDS_Shape& shape) {
    std::ostringstream stream;
    BinTools::Write(shape, stream, Standard_False, Standard_False, BinTools_FormatVersion_CURRENT);
    return std::move(stream).str();
}

void noteMesh(Model& model, const Body& body, const SolidMesh& mesh) {
    const std::string title = "\"" + body.name + "\"";
    const auto note = [&](ImportNote::Kind kind, std::string text) { model.notes.push_back({kind, std::move(text)}); };
    if (mesh.facesFilled > 0)
        note(ImportNote::Kind::healing, fill(import_notes::facesFilled, {title, std::to_string(mesh.facesFilled)}));
    if (mesh.openEdges > 0)
        note(ImportNote::Kind::warning, fill(import_notes::meshOpen, {title, std::to_string(mesh.openEdges)}));
    // A mesh within its chord encloses a volume that differs by less than the chord times the area.
    if (const double meshed = signedVolume(body.mesh); std::abs(meshed - body.volume) > model.meshChord * body.area)
        note(ImportNote::Kind::warning,
             fill(import_notes::meshVolumeDiffers, {title, formatFixed(meshed, 2), formatFixed(body.volume, 2)}));
}

Result<Body> makeBody(Model& model, const NamedSolid& solid, double chord, bool careful, const ReportFraction& report) {
    Body body;
    body.name = bodyName(solid, model.bodies.size() + 1);
    body.colour = solid.colour;
    body.box = exactBox(solid.solid); // before meshing, so that triangles have no influence
    body.volume = exactVolume(solid.solid);
    body.area = exactArea(solid.solid);
    body.faceCount = countFaces(solid.solid);
    SolidMesh mesh = meshSolid(solid.solid, chord, report, careful);
    if (mesh.facesWithoutTriangles > 0)
        return Error{ErrorCode::meshIncomplete,
                     {},
                     std::to_string(mesh.facesWithoutTriangles) + " of " + std::to_string(body.faceCount) +
                         " faces of \"" + body.name + "\"",
                     {}};
    body.mesh = std::move(mesh.mesh);
    body.openEdges = mesh.openEdges;
    noteMesh(model, body, mesh);
    // The gaps between the faces in the file itself: no mesh can be nearer to both sides.
    if (const double gap = BRep_Tool::MaxTolerance(solid.solid, TopAbs_EDGE); gap > chord)
        model.notes.push_back({ImportNote::Kind::warning,
                               fill(import_notes::facesApart, {"\"" + body.name + "\"", formatFixed(gap, 4)})});
    return body;
}

Result<Model> makeModel(CadFile file, const ReadRequest& request, const ReaderReports& report) {
    const double chord = request.meshChord;
    Result<std::vector<NamedSolid>> solids = makeSolids(file);
    if (!solids) return std::move(solids).error();
    // A file that crashed the mesher is not meshed more often than necessary.
    if (request.preview && !request.careful)
        if (const std::optional<ModelPreview> preview = previewOf(*solids, chord)) report.preview(*preview);
    Model model;
    model.format = file.format;
    model.lengthUnit = file.lengthUnit;
    model.unitScale = file.unitScale;
    model.meshChord = chord;
    model.notes = std::move(file.notes);
    TopoDS_Compound whole;
    BRep_Builder builder;
    builder.MakeCompound(whole);
    for (const NamedSolid& solid : *solids) builder.Add(whole, solid.solid);
    model.brep = encodeShape(whole);
    const auto count = static_cast<double>(solids->size());
    for (std::size_t i = 0; i < solids->size(); ++i) {
        const auto part = [&](double fraction) {
            report.fraction(0.5 + 0.5 * (static_cast<double>(i) + fraction) / count);
        };
        Result<Body> body = makeBody(model, (*solids)[i], chord, request.careful, part);
        if (!body) return std::move(body).error();
        model.bodies.push_back(std::move(*body));
    }
    return model;
}

} // namespace

Result<Model> modelOf(Result<CadFile> file, ModelSource& source) {
    if (!file) return std::move(file).error();
    source.content = std::string(); // frees its memory, which is needed
    return makeModel(std::move(*file), source.request, source.report);
}

} // namespace burin

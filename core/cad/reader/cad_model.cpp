// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_model.h"

#include "core/base/numbers.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/face_patches.h"
#include "core/cad/reader/measure.h"
#include "core/cad/reader/occt_vectors.h"
#include "core/cad/reader/preview.h"
#include "core/cad/reader/solid_colours.h"
#include "core/cad/reader/solid_mesh.h"
#include "core/cad/reader/solids.h"
#include "core/cad/reader/unit_note.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_TShape.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
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

/// Makes the bodies of a model. Instances of one part share its measures and its mesh.
class BodyMaker {
public:
    BodyMaker(Model& model, const ReadRequest& request) : model_(model), request_(request) {}

    Result<void> add(std::string name, const NamedSolid& solid, const ReportFraction& report) {
        Body body;
        body.name = std::move(name);
        const SolidColours colours = coloursOf(solid);
        body.colour = colours.body;
        body.box = exactBox(solid.solid); // before meshing, so that triangles have no influence
        SolidMesh mesh;
        if (const Made* same = sameAs(solid.from))
            copy(*same, solid.from, body, mesh);
        else if (Result<void> meshed = measure(solid, report, body, mesh); !meshed)
            return meshed;
        body.faceColours = faceColoursOf(colours, mesh.faceOf);
        noteMesh(model_, body, mesh);
        // The gaps between the faces in the file itself: no mesh can be nearer to both sides.
        if (const double gap = BRep_Tool::MaxTolerance(solid.solid, TopAbs_EDGE); gap > request_.meshChord)
            model_.notes.push_back({ImportNote::Kind::warning,
                                    fill(import_notes::facesApart, {"\"" + body.name + "\"", formatFixed(gap, 4)})});
        model_.bodies.push_back(std::move(body));
        return {};
    }

private:
    /// The first body of a part.
    struct Made {
        PlacedPart from;
        std::size_t body;
        std::size_t openEdges, facesFilled;
        std::vector<std::uint32_t> faceOf; ///< as SolidMesh::faceOf, of the solid; empty if no face has a colour
    };

    const Made* sameAs(const PlacedPart& from) const {
        const auto made = from.part.IsNull() ? made_.end() : made_.find(from.part.TShape().get());
        const bool same = made != made_.end() && made->second.from.part.IsEqual(from.part);
        return same && !from.place.IsNegative() && !made->second.from.place.IsNegative() ? &made->second : nullptr;
    }

    void copy(const Made& made, const PlacedPart& from, Body& body, SolidMesh& mesh) const {
        const Body& first = model_.bodies[made.body];
        body.volume = first.volume;
        body.area = first.area;
        body.faceCount = first.faceCount;
        body.openEdges = mesh.openEdges = made.openEdges;
        mesh.facesFilled = made.facesFilled;
        mesh.faceOf = made.faceOf;
        body.mesh = first.mesh;
        const gp_Trsf move = from.place * made.from.place.Inverted();
        for (glm::dvec3& vertex : body.mesh.vertices) vertex = toVector(toPoint(vertex).Transformed(move).XYZ());
    }

    Result<void> measure(const NamedSolid& solid, const ReportFraction& report, Body& body, SolidMesh& mesh) {
        body.volume = exactVolume(solid.solid);
        body.area = exactArea(solid.solid);
        body.faceCount = countFaces(solid.solid);
        mesh = meshSolid(solid.solid, request_.meshChord, report, request_.careful);
        if (mesh.facesWithoutTriangles > 0)
            return Error{ErrorCode::meshIncomplete,
                         {},
                         std::to_string(mesh.facesWithoutTriangles) + " of " + std::to_string(body.faceCount) +
                             " faces of \"" + body.name + "\"",
                         {}};
        numberFaces(solid, mesh);
        body.mesh = std::move(mesh.mesh);
        body.openEdges = mesh.openEdges;
        if (!solid.from.part.IsNull())
            made_.try_emplace(solid.from.part.TShape().get(),
                              Made{solid.from, model_.bodies.size(), mesh.openEdges, mesh.facesFilled, mesh.faceOf});
        return {};
    }

    /// Makes `faceOf` name the faces of the solid itself; drops it if none of them has a colour.
    static void numberFaces(const NamedSolid& solid, SolidMesh& mesh) {
        if (solid.faceColours.empty()) {
            mesh.faceOf = {};
        } else if (mesh.divided) {
            const std::vector<std::uint32_t> owners = ownersOf(solid.solid, mesh);
            for (std::uint32_t& face : mesh.faceOf) face = owners[face];
        }
    }

    Model& model_;
    const ReadRequest& request_;
    std::map<const TopoDS_TShape*, Made> made_;
};

/// The share of each solid in the work of meshing: by its faces; instances of a part that was meshed take no time.
std::vector<double> meshingShares(const std::vector<NamedSolid>& solids) {
    std::vector<double> shares;
    std::set<const TopoDS_TShape*> parts;
    double sum = 0.0;
    for (const NamedSolid& solid : solids) {
        const bool first = solid.from.part.IsNull() || parts.insert(solid.from.part.TShape().get()).second;
        shares.push_back(first ? static_cast<double>(countFaces(solid.solid)) : 0.0);
        sum += shares.back();
    }
    for (double& share : shares) share /= std::max(sum, 1.0);
    return shares;
}

Result<Model> makeModel(CadFile file, const ReadRequest& request, const ReaderReports& report) {
    const double chord = request.meshChord;
    Result<std::vector<NamedSolid>> solids = makeSolids(file, [&](std::size_t done, std::size_t total) {
        report.tell(ImportStage::checking, static_cast<double>(done), static_cast<double>(total));
        report.fraction(
            std::lerp(shapesConverted, solidsChecked, static_cast<double>(done) / static_cast<double>(total)));
    });
    if (!solids) return std::move(solids).error();
    // A file that crashed the mesher is not meshed more often than necessary.
    if (request.preview && !request.careful)
        if (const std::optional<ModelPreview> preview = previewOf(*solids, chord)) report.preview(*preview);
    Model model;
    model.format = file.format;
    model.lengthUnit = file.lengthUnit;
    model.meshChord = chord;
    setUnit(model, file.unitScale, file.statesUnit, request.unitInstead);
    model.notes.insert(model.notes.end(), file.notes.begin(), file.notes.end());
    TopoDS_Compound whole;
    BRep_Builder builder;
    builder.MakeCompound(whole);
    for (const NamedSolid& solid : *solids) builder.Add(whole, solid.solid);
    model.brep = encodeShape(whole);
    const std::vector<std::string> names = bodyNames(*solids);
    BodyMaker maker(model, request);
    const auto count = static_cast<double>(solids->size());
    const std::vector<double> shares = meshingShares(*solids);
    double meshed = 0.0;
    for (std::size_t i = 0; i < solids->size(); meshed += shares[i++]) {
        report.tell(ImportStage::meshing, static_cast<double>(i + 1), count);
        const auto part = [&](double fraction) {
            report.fraction(std::lerp(solidsChecked, 1.0, meshed + shares[i] * fraction));
        };
        if (Result<void> added = maker.add(names[i], (*solids)[i], part); !added) return std::move(added).error();
    }
    return model;
}

} // namespace

Result<Model> modelOf(Result<CadFile> file, ModelSource& source) {
    if (!file) return std::move(file).error();
    if (source.request.unitInstead > 0.0) replaceUnit(*file, source.request.unitInstead);
    source.content = std::string(); // frees its memory, which is needed
    return makeModel(std::move(*file), source.request, source.report);
}

} // namespace burin

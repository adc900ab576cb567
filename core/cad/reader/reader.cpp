// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/reader.h"

#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/cad_file.h"
#include "core/cad/reader/edge_curve.h"
#include "core/cad/reader/exact_distance.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/measure.h"
#include "core/cad/reader/model_size.h"
#include "core/cad/reader/preview.h"
#include "core/cad/reader/solid_mesh.h"
#include "core/cad/reader/solids.h"
#include "core/cad/reader/stl_model.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>

#include <cmath>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <sys/resource.h>
#include <utility>

namespace burin {

using import_notes::fill;

namespace {

std::string encodeShape(const TopoDS_Shape& shape) {
    std::ostringstream stream;
    BinTools::Write(shape, stream, Standard_False, Standard_False, BinTools_FormatVersion_CURRENT);
    return std::move(stream).str();
}

std::size_t countFaces(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return static_cast<std::size_t>(faces.Extent());
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
    body.box = exactBox(solid.solid); // before meshing, so that no triangle has a say
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
    // The file's own gaps between its faces: no mesh can be nearer to both sides.
    if (const double gap = BRep_Tool::MaxTolerance(solid.solid, TopAbs_EDGE); gap > chord)
        model.notes.push_back({ImportNote::Kind::warning,
                               fill(import_notes::facesApart, {"\"" + body.name + "\"", formatFixed(gap, 4)})});
    return body;
}

Result<Model> makeModel(CadFile file, const ReadRequest& request, const ReaderReports& report) {
    const double chord = request.meshChord;
    Result<std::vector<NamedSolid>> solids = makeSolids(file);
    if (!solids) return std::move(solids).error();
    // A file at which the mesher crashed isn't given to it more often than it has to be.
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

Result<CadFile> readCadFile(const std::string& file, FileFormat format, const std::string& content,
                            const ReportFraction& report) {
    switch (format) {
    case FileFormat::step:
        return readStepFile(file, content, report);
    case FileFormat::iges:
        return readIgesFile(file, report);
    default:
        return readBrepFile(content, format == FileFormat::brepBinary);
    }
}

Result<Model> readAnyModel(const ReadRequest& request, const ReaderReports& report) {
    Result<std::string> content = readFile(request.file);
    if (!content) return std::move(content).error();
    Result<FileFormat> format = detectFormat(*content);
    if (!format) return std::move(format).error();
    if (*format == FileFormat::stlText || *format == FileFormat::stlBinary)
        return readStlModel(*content, *format == FileFormat::stlBinary, request.stlUnit);
    Result<CadFile> file = readCadFile(request.file, *format, *content, report.fraction);
    if (!file) return std::move(file).error();
    *content = std::string();
    return makeModel(std::move(*file), request, report);
}

/// Whether this process came near its limit of memory. OpenCASCADE's mesher swallows a refused allocation and leaves
/// faces empty: the fault is then not the model's.
bool memoryWasShort() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
    std::ifstream status("/proc/self/status");
    std::string key;
    for (double kibibytes = 0.0; status >> key; status.ignore(1000, '\n'))
        if (key == "VmPeak:" && status >> kibibytes)
            return kibibytes * 1024.0 > 0.9 * static_cast<double>(limit.rlim_cur);
    return false;
}

/// Runs work of OpenCASCADE and turns what it throws into an Error.
template <class T, class Work>
Result<T> guarded(Work work) {
    try {
        Result<T> result = work();
        if (!result && result.error().code == ErrorCode::meshIncomplete && memoryWasShort())
            return Error{ErrorCode::importOutOfMemory, {}, {}, {}};
        return result;
    } catch (const Standard_OutOfMemory&) {
        return Error{ErrorCode::importOutOfMemory, {}, {}, {}};
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::importOutOfMemory, {}, {}, {}};
    } catch (const Standard_Failure& failure) {
        return Error{ErrorCode::fileDamaged,
                     {},
                     {},
                     std::string(failure.DynamicType()->Name()) + ": " + failure.GetMessageString()};
    } catch (const std::exception& failure) {
        return Error{ErrorCode::fileDamaged, {}, {}, failure.what()};
    }
}

Result<TopoDS_Shape> shapeOf(const std::string& brep) {
    TopoDS_Shape shape;
    std::istringstream stream(brep);
    BinTools::Read(shape, stream);
    if (shape.IsNull() || countFaces(shape) == 0) return Error{ErrorCode::fileDamaged, {}, {}, "no faces"};
    return shape;
}

} // namespace

Result<Model> readModel(const ReadRequest& request, const ReaderReports& report) {
    return guarded<Model>([&]() -> Result<Model> {
        Result<Model> model = readAnyModel(request, report);
        if (!model) return model;
        if (Result<void> usable = judgeSize(*model); !usable) return std::move(usable).error();
        return model;
    });
}

Result<std::vector<double>> measureDistances(const DistanceRequest& request,
                                             const std::function<void(double)>& report) {
    return guarded<std::vector<double>>([&]() -> Result<std::vector<double>> {
        const Result<TopoDS_Shape> shape = shapeOf(request.brep);
        if (!shape) return shape.error();
        ExactDistance measure(*shape);
        std::vector<double> distances;
        for (const glm::dvec3& point : request.points) {
            distances.push_back(measure.signedDistance(point));
            report(static_cast<double>(distances.size()) / static_cast<double>(request.points.size()));
        }
        return distances;
    });
}

Result<std::vector<PartEdge>> followEdges(const EdgeRequest& request) {
    return guarded<std::vector<PartEdge>>([&]() -> Result<std::vector<PartEdge>> {
        const Result<TopoDS_Shape> shape = shapeOf(request.brep);
        if (!shape) return shape.error();
        return edgeCurves(*shape, request.chord);
    });
}

} // namespace burin

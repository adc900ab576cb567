// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/reader.h"

#include "core/base/file.h"
#include "core/cad/reader/edge_curve.h"
#include "core/cad/reader/exact_distance.h"
#include "core/cad/reader/face_at.h"
#include "core/cad/reader/face_measure.h"
#include "core/cad/reader/face_patches.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/measure.h"
#include "core/cad/reader/model_size.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <sys/resource.h>
#include <utility>

namespace burin {

namespace {

Result<Model> readAnyModel(const ReadRequest& request, const ReaderReports& report) {
    Result<std::string> content = readFile(request.file);
    if (!content) return std::move(content).error();
    const Result<ReaderFormat> format = detectFormat(*content);
    if (!format) return format.error();
    ModelSource source{request, report, *content};
    return format->read(source);
}

/// Whether this process came near its memory limit. OpenCASCADE's mesher ignores a refused allocation and leaves faces
/// empty: this is then not a fault of the model.
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

/// Runs a function that uses OpenCASCADE and converts exceptions to an Error.
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

/// Returns the children of a compound that have the given numbers.
TopoDS_Shape chosenOf(const TopoDS_Shape& whole, const std::vector<std::uint32_t>& solids) {
    TopoDS_Compound chosen;
    BRep_Builder builder;
    builder.MakeCompound(chosen);
    std::uint32_t number = 0;
    for (TopoDS_Iterator child(whole); child.More(); child.Next())
        if (std::ranges::find(solids, number++) != solids.end()) builder.Add(chosen, child.Value());
    return chosen;
}

Result<TopoDS_Shape> shapeOf(const std::string& brep, const std::vector<std::uint32_t>& solids) {
    TopoDS_Shape shape;
    std::istringstream stream(brep);
    BinTools::Read(shape, stream);
    if (!shape.IsNull() && !solids.empty()) shape = chosenOf(shape, solids);
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
        const Result<TopoDS_Shape> shape = shapeOf(request.brep, request.solids);
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
        const Result<TopoDS_Shape> shape = shapeOf(request.brep, request.solids);
        if (!shape) return shape.error();
        return edgeCurves(*shape, request.chord);
    });
}

Result<PartFace> findFace(const FaceRequest& request) {
    return guarded<PartFace>([&]() -> Result<PartFace> {
        const Result<TopoDS_Shape> shape = shapeOf(request.brep, request.solids);
        if (!shape) return shape.error();
        return faceAt(*shape, request.place);
    });
}

Result<PartMeasure> measureFaces(const MeasureRequest& request) {
    return guarded<PartMeasure>([&]() -> Result<PartMeasure> {
        const Result<TopoDS_Shape> shape = shapeOf(request.brep, request.solids);
        if (!shape) return shape.error();
        return faceMeasure(*shape, request.places);
    });
}

Result<std::vector<PartFacePatch>> meshFaces(const PatchRequest& request, const std::function<void(double)>& report) {
    return guarded<std::vector<PartFacePatch>>([&]() -> Result<std::vector<PartFacePatch>> {
        const Result<TopoDS_Shape> shape = shapeOf(request.brep, request.solids);
        if (!shape) return shape.error();
        return facePatches(*shape, request.chord, request.careful, report);
    });
}

} // namespace burin

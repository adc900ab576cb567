// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_file.h"

#include "core/cad/file_unit.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/document_shapes.h"
#include "core/cad/reader/external_files.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/left_out.h"
#include "core/cad/reader/measured_text.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Vec.hxx>

#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace burin {

namespace {

constexpr int millimetreFlag = 2; // IGES 5.3, 2.2.4.3.14

Error damaged(std::string place) {
    return {ErrorCode::fileDamaged, {}, std::move(place), {}};
}

/// OpenCASCADE's settings are process-wide; every relevant one is set explicitly, whatever its default.
void stateSettings() {
    STEPCAFControl_Controller::Init();
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    Interface_Static::SetIVal("read.precision.mode", 0);         // the file's own precision
    Interface_Static::SetIVal("read.step.product.mode", 1);      // structure from the products
    Interface_Static::SetIVal("read.step.assembly.level", 1);    // all levels
    Interface_Static::SetIVal("read.step.shape.repr", 1);        // all representations
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1); // solids of one part have their own names
    Interface_Static::SetIVal("read.iges.bspline.continuity", 1);
    Interface_Static::SetIVal("read.surfacecurve.mode", 0);
}

Handle(TDocStd_Document) newDocument() {
    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    XCAFDoc_ShapeTool::SetAutoNaming(Standard_False); // an automatic name such as "COMPOUND" was not given by a user
    XCAFDoc_DocumentTool::Set(document->Main(), Standard_False);
    return document;
}

Handle(StepRepr_GlobalUnitAssignedContext) unitsOf(const Handle(Standard_Transient) & entity) {
    const auto with = Handle(StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(entity);
    if (!with.IsNull()) return with->GlobalUnitAssignedContext();
    const auto without = Handle(StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext)::DownCast(entity);
    return without.IsNull() ? Handle(StepRepr_GlobalUnitAssignedContext)() : without->GlobalUnitAssignedContext();
}

bool isUnit(double millimetres) noexcept {
    return std::isfinite(millimetres) && millimetres > 0.0;
}

/// Returns all length units of the file's representations, mm.
std::set<double> stepUnits(const Handle(StepData_StepModel) & model) {
    std::set<double> units;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepRepr_GlobalUnitAssignedContext) context = unitsOf(model->Value(i));
        if (context.IsNull()) continue;
        STEPConstruct_UnitContext factors;
        factors.ComputeFactors(context);
        if (factors.LengthDone() && isUnit(factors.LengthFactor())) units.insert(factors.LengthFactor());
    }
    return units;
}

void stateUnit(CadFile& file, double scale, const std::string& name) {
    file.unitScale = scale;
    file.lengthUnit = unitName(scale, name);
}

void stateStepUnit(CadFile& file, STEPControl_Reader& reader) {
    const std::set<double> units = stepUnits(reader.StepModel());
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    const std::string name = lengths.IsEmpty() ? "mm" : lengths.First().ToCString();
    stateUnit(file, units.empty() ? 1.0 : *units.rbegin(), name);
    if (units.size() > 1)
        file.notes.push_back(
            {ImportNote::Kind::unit, import_notes::fill(import_notes::unitsMixed, {std::to_string(units.size())})});
}

double megabytes(std::size_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}

/// Reads the text through a stream, as only then it is known how far the parser is.
bool parseStep(STEPControl_Reader& reader, const std::string& file, std::string_view content,
               const ReaderReports& report) {
    const double size = static_cast<double>(content.size());
    MeasuredText text(content, [&](std::size_t taken) {
        if (taken == content.size()) return report.tell(ImportStage::interpreting);
        report.tell(ImportStage::reading, megabytes(taken), megabytes(content.size()));
        report.fraction(textRead * static_cast<double>(taken) / size);
    });
    std::istream stream(&text);
    return reader.ReadStream(file.c_str(), stream) == IFSelect_RetDone;
}

} // namespace

void replaceUnit(CadFile& file, double scale) {
    if (isSameUnit(scale, file.unitScale)) return;
    const double ratio = scale / file.unitScale;
    gp_Trsf growth;
    growth.SetScaleFactor(ratio);
    for (NamedShape& entry : file.shapes) {
        entry.shape = BRepBuilderAPI_Transform(entry.shape, growth, Standard_True).Shape();
        entry.from.place.SetTranslationPart(gp_Vec(entry.from.place.TranslationPart() * ratio));
    }
}

Result<CadFile> readStepFile(const std::string& file, std::string_view content, const ReaderReports& report) {
    stateSettings();
    STEPCAFControl_Reader reader;
    reader.SetNameMode(Standard_True);
    reader.SetColorMode(Standard_True);
    if (!parseStep(reader.ChangeReader(), file, content, report)) return damaged("");
    CadFile read;
    read.format = stepProtocol(content);
    const ExternalFiles others = externalFilesOf(reader.Reader(), file);
    if (others.circular) return damaged("it refers to itself");
    if (!others.outside.empty())
        return Error{ErrorCode::modelHasNoSolid, {}, "parts in other folders", joined(others.outside)};
    read.missingFiles = joined(others.missing);
    stateStepUnit(read, reader.ChangeReader());
    Handle(TDocStd_Document) document = newDocument();
    report.tell(ImportStage::converting);
    const Handle(ReaderProgress) progress = new ReaderProgress(report.fraction, fileRead, shapesConverted);
    const bool tessellated = content.find("TESSELLATED_") != std::string_view::npos;
    const Error noSolid{
        ErrorCode::modelHasNoSolid, {}, tessellated ? "a tessellation alone" : "no shape", read.missingFiles};
    if (reader.NbRootsForTransfer() == 0) return noSolid;
    if (!reader.Transfer(document, progress->Start())) return tessellated ? noSolid : damaged("");
    read.shapes = documentShapes(document);
    noteLeftOut(read, *reader.Reader().StepModel());
    return read;
}

Result<CadFile> readIgesFile(const std::string& file, std::size_t bytes, const ReaderReports& report) {
    stateSettings();
    IGESCAFControl_Reader reader;
    reader.SetNameMode(Standard_True);
    reader.SetColorMode(Standard_True);
    report.tell(ImportStage::readingBlind, 0.0, megabytes(bytes));
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) return damaged("");
    CadFile read;
    read.format = "IGES";
    IGESData_GlobalSection& head = reader.IGESModel()->ChangeGlobalSection();
    if (!isUnit(head.UnitValue())) { // a flag that IGES doesn't know, or a name
        head.SetUnitFlag(millimetreFlag);
        head.SetUnitName(nullptr);
        read.statesUnit = false;
    }
    stateUnit(read, head.UnitValue(), head.UnitName().IsNull() ? "mm" : head.UnitName()->ToCString());
    Handle(TDocStd_Document) document = newDocument();
    report.tell(ImportStage::converting);
    const Handle(ReaderProgress) progress = new ReaderProgress(report.fraction, fileRead, shapesConverted);
    if (!reader.Transfer(document, progress->Start())) return damaged("");
    read.shapes = documentShapes(document);
    noteLeftOut(read, *reader.IGESModel());
    return read;
}

Result<CadFile> readBrepFile(const std::string& content, bool binary, const ReaderReports& report) {
    TopoDS_Shape shape;
    std::istringstream stream(content);
    report.tell(ImportStage::converting);
    const Handle(ReaderProgress) progress = new ReaderProgress(report.fraction, 0.0, shapesConverted);
    if (binary) {
        BinTools::Read(shape, stream, progress->Start());
    } else {
        BRep_Builder builder;
        BRepTools::Read(shape, stream, builder, progress->Start());
    }
    if (shape.IsNull() || stream.fail()) return damaged("");
    CadFile read{"BREP", "mm", 1.0, false, {}, {}, {}};
    read.shapes = explodedShapes(shape, {}, std::nullopt);
    return read;
}

} // namespace burin

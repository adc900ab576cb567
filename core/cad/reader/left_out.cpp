// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/left_out.h"

#include "core/cad/import_notes.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <StepData_StepModel.hxx>
#include <StepDimTol_Datum.hxx>
#include <StepDimTol_GeometricTolerance.hxx>
#include <StepShape_DimensionalLocation.hxx>
#include <StepShape_DimensionalSize.hxx>
#include <StepVisual_AnnotationOccurrence.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_SurfaceStyleTransparent.hxx>

#include <set>

namespace burin {

namespace {

/// IGES 5.3, section 4: the entity types of dimensions, notes and symbols.
constexpr int firstAnnotation = 202, lastAnnotation = 230;

void add(CadFile& file, std::string text) {
    file.notes.push_back({ImportNote::Kind::leftOut, std::move(text)});
}

void addCounted(CadFile& file, TextId note, std::size_t count) {
    if (count > 0) add(file, import_notes::fill(note, {std::to_string(count)}));
}

bool isAnnotation(const Standard_Transient& entity) {
    for (const Handle(Standard_Type) & type :
         {STANDARD_TYPE(StepDimTol_GeometricTolerance), STANDARD_TYPE(StepDimTol_Datum),
          STANDARD_TYPE(StepShape_DimensionalSize), STANDARD_TYPE(StepShape_DimensionalLocation),
          STANDARD_TYPE(StepVisual_AnnotationOccurrence)})
        if (entity.IsKind(type)) return true;
    return false;
}

} // namespace

void noteLostFaceColours(CadFile& file, std::size_t count) {
    if (count == 1)
        add(file, import_notes::repairedFaceColourLost.text);
    else
        addCounted(file, import_notes::repairedFaceColoursLost, count);
}

void noteLeftOut(CadFile& file, const StepData_StepModel& model) {
    std::size_t layers = 0, annotations = 0;
    bool transparent = false;
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const Handle(Standard_Transient)& entity = model.Value(i);
        if (entity->IsKind(STANDARD_TYPE(StepVisual_PresentationLayerAssignment))) ++layers;
        if (entity->IsKind(STANDARD_TYPE(StepVisual_SurfaceStyleTransparent))) transparent = true;
        if (isAnnotation(*entity)) ++annotations;
    }
    if (transparent) add(file, import_notes::transparencyLeftOut.text);
    addCounted(file, import_notes::layersLeftOut, layers);
    addCounted(file, import_notes::annotationsLeftOut, annotations);
}

void noteLeftOut(CadFile& file, const IGESData_IGESModel& model) {
    std::set<int> levels;
    std::size_t annotations = 0;
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const Handle(IGESData_IGESEntity) entity = model.Entity(i);
        if (entity.IsNull()) continue;
        if (entity->DefLevel() == IGESData_DefOne) levels.insert(entity->Level());
        if (entity->TypeNumber() >= firstAnnotation && entity->TypeNumber() <= lastAnnotation) ++annotations;
    }
    if (levels.size() > 1) addCounted(file, import_notes::layersLeftOut, levels.size());
    addCounted(file, import_notes::annotationsLeftOut, annotations);
}

} // namespace burin

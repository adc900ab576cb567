// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/deviation_map.h"

#include "core/base/file.h"
#include "core/verify/deviation_scale.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

namespace burin {

Result<void> writeDeviationMap(const std::vector<DeviationSample>& deviations, const DeviationTolerance& tolerance,
                               const std::filesystem::path& file) {
    const DeviationScale scale(tolerance);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkFloatArray> excess;
    excess->SetName("excess_mm");
    vtkNew<vtkUnsignedCharArray> reachable;
    reachable->SetName("reachable");
    vtkNew<vtkFloatArray> deviation;
    deviation->SetName("deviation_mm");
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(3);
    for (const DeviationSample& sample : deviations) {
        const vtkIdType place = points->InsertNextPoint(sample.place.x, sample.place.y, sample.place.z);
        vertices->InsertNextCell(1, &place);
        excess->InsertNextValue(static_cast<float>(sample.excess));
        reachable->InsertNextValue(sample.reachable ? 1 : 0);
        deviation->InsertNextValue(static_cast<float>(deviationOf(sample)));
        colours->InsertNextTypedTuple(colourOf(sample, scale, tolerance).data());
    }
    vtkNew<vtkPolyData> map;
    map->SetPoints(points);
    map->SetVerts(vertices);
    map->GetPointData()->SetScalars(excess);
    for (vtkDataArray* array : {static_cast<vtkDataArray*>(reachable), static_cast<vtkDataArray*>(deviation),
                                static_cast<vtkDataArray*>(colours)})
        map->GetPointData()->AddArray(array);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(map);
    writer->WriteToOutputStringOn();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOn();
    if (writer->Write() == 0) return Error{ErrorCode::fileNotWritable, file.string(), {}, "VTK could not encode it"};
    return writeFileAtomically(file, writer->GetOutputString());
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/coarse_mesh.h"

#include "ui/scene/shaded_polydata.h"

#include <vtkDecimatePro.h>
#include <vtkNew.h>

namespace burin {

namespace {

constexpr double mostLeftOut = 0.98; ///< maximum fraction of removed triangles

} // namespace

vtkSmartPointer<vtkPolyData> coarsened(const ShadedMesh& mesh, double tolerance) {
    vtkNew<vtkDecimatePro> decimation;
    decimation->SetInputData(polyDataOf(mesh).surface);
    decimation->SetTargetReduction(mostLeftOut);
    decimation->PreserveTopologyOn();
    decimation->SplittingOff();
    decimation->BoundaryVertexDeletionOff(); // a crease is a border of the faces on both its sides
    decimation->SetErrorIsAbsolute(1);
    decimation->SetAbsoluteError(tolerance);
    decimation->AccumulateErrorOn();
    decimation->Update();
    return decimation->GetOutput();
}

} // namespace burin

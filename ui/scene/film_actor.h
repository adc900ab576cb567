// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// A surface like a film of colour: blended over what is drawn already where that does not hide it, and hiding nothing
/// itself (it leaves depths alone). Not lit; where it lies on another surface it is the one that is seen.
vtkSmartPointer<vtkActor> filmActor(vtkPolyData* surface);

/// The same, lit and from its front alone, and no nearer than it lies: a solid body that is seen through.
vtkSmartPointer<vtkActor> glassActor(vtkPolyData* surface);

} // namespace burin

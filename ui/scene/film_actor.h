// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// An actor for a translucent, unlit surface: it is blended over what is already drawn where that does not hide it, and
/// hides nothing itself (it doesn't write depths). If it coincides with another surface, it is the visible one.
vtkSmartPointer<vtkActor> filmActor(vtkPolyData* surface);

/// As `filmActor`, but lit, with only front faces drawn and without a depth offset: a translucent solid.
vtkSmartPointer<vtkActor> glassActor(vtkPolyData* surface);

} // namespace burin

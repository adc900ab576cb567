// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"

#include <vtkCamera.h>

namespace burin {

/// Lets VTK's camera look as the view does. Clipping planes are the caller's.
/// @param reach mm from the focus, at least as far as anything that is drawn: a parallel camera stands beyond it
void aim(vtkCamera& camera, const CameraView& view, double reach);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"

#include <vtkCamera.h>

namespace burin {

/// Sets up VTK's camera for a view. The caller sets the clipping planes.
/// @param reach mm from the focus, at least as far as anything that is drawn: a parallel camera is placed beyond it
void aim(vtkCamera& camera, const CameraView& view, double reach);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/brick_field.h"

namespace burin {

/// What the resolution of a field follows from; README.md derives it.
struct FieldResolution {
    double spacing = 0.0;            ///< mm
    double interpolationBound = 0.0; ///< mm, how far interpolation may be too high over smooth faces
    double low = 0.0, high = 0.0;    ///< mm, the fine band of clearances
    double clear = 0.0;              ///< mm, no less is answered beyond the band: a tool goes free there
};

FieldResolution fieldResolution(const ToolFieldRequest& request) noexcept;

/// Samples a tool's clearance; the request is valid. Errors: cancelled, outOfMemory. Throws std::bad_alloc.
Result<BrickField> buildBrickField(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress);

} // namespace burin

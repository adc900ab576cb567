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
    double quantum = 0.0;            ///< mm, one unit of a fine sample

    /// As ClearanceField::errorBound.
    double errorBound() const noexcept { return 2.0 * interpolationBound + quantum; }
};

/// @param request valid, see checkFieldRequest
FieldResolution fieldResolution(const ToolFieldRequest& request) noexcept;

/// The bricks' corners alone, each brick a coarse one, however near the part it lies.
struct CoarseBricks {
    BrickField field;
    std::vector<std::uint8_t> band; ///< per brick: some tip in it may be in the fine band; 1 or 0
};
/// @param edge of a brick, mm. Errors and what is thrown: those of buildBrickField.
Result<CoarseBricks> buildCoarseBricks(const MeshDistance& part, const ToolFieldRequest& request, double edge,
                                       Progress& progress);

/// What makes no field. Errors: argumentInvalid, as ToolField::build has it.
Result<void> checkFieldRequest(const ToolFieldRequest& request);

/// Samples a tool's clearance; the request is valid. Errors: cancelled, outOfMemory. Throws std::bad_alloc.
Result<BrickField> buildBrickField(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/brick_field.h"

namespace burin {

/// The resolution of a field, computed from a request; README.md derives it.
struct FieldResolution {
    double spacing = 0.0;            ///< mm
    double interpolationBound = 0.0; ///< mm, how much too high interpolation may be over smooth faces
    double low = 0.0, high = 0.0;    ///< mm, the fine band of clearances
    double clear = 0.0;              ///< mm, lowest value returned beyond the band: the tool moves freely there
    double quantum = 0.0;            ///< mm, one unit of a fine sample

    /// As ClearanceField::errorBound.
    double errorBound() const noexcept { return 2.0 * interpolationBound + quantum; }
};

/// @param request valid, see checkFieldRequest
FieldResolution fieldResolution(const ToolFieldRequest& request) noexcept;

/// Only the corners of the bricks; every brick is coarse, however near the part it is.
struct CoarseBricks {
    BrickField field;
    std::vector<std::uint8_t> band; ///< per brick: 1 if some tip in it may be in the fine band, otherwise 0
};
/// @param edge  of a brick, mm. Errors and exceptions: those of buildBrickField.
Result<CoarseBricks> buildCoarseBricks(const MeshDistance& part, const ToolFieldRequest& request, double edge,
                                       Progress& progress);

/// Checks whether a field can be built for the request. Errors: argumentInvalid, as ToolField::build.
Result<void> checkFieldRequest(const ToolFieldRequest& request);

/// Samples a tool's clearance; the request must be valid. Errors: cancelled, outOfMemory. Throws std::bad_alloc.
Result<BrickField> buildBrickField(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress);

} // namespace burin

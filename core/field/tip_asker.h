// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/part_sample.h"
#include "core/field/tool_field.h"

namespace burin {

inline constexpr double farthestClearance = 1e6; ///< mm: what an empty part answers

/// Asks a part for the clearance of a tool, one tip after the other, each best near the last. One thread each.
class TipAsker {
public:
    TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance);

    /// Clearance, mm, and its gradient, which on a ridge of the tool is the one that the part's surface tells.
    PartSample ask(const glm::dvec3& tip);

private:
    glm::dvec3 gradientOf(const ToolClearance& found, const glm::dvec3& tip) const noexcept;

    const ToolFieldRequest& request_;
    ClearanceTolerance tolerance_;
    ClearanceAsker asker_;
};

} // namespace burin

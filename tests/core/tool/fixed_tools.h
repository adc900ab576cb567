// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/hollow_tip.h"
#include "core/tool/revolution_envelope.h"
#include "core/tool/tool_solid.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/tool/cutters.h"

#include <algorithm>
#include <memory>
#include <utility>

/// Tools that are cut as solids: they don't turn, or are hollow. Lengths in mm, angles in rad.
namespace burin::cutters {

/// @param flutes lowest vertex at 0 @param shank may be empty
inline Cutter fixed(TriangleMesh flutes, TriangleMesh shank, double angle) {
    const RevolutionEnvelope envelope = revolutionEnvelope(flutes, 0.005).value();
    Cutter cutter = make(CutterType::profile, 2.0 * envelope.widest, 0.0, envelope.profile.back().height);
    cutter.profile = envelope.profile;
    if (!shank.empty()) {
        cutter.stickOut = boundingBox(shank).high.z;
        for (const glm::dvec3& vertex : shank.vertices)
            cutter.shankDiameter = std::max(cutter.shankDiameter, 2.0 * std::hypot(vertex.x, vertex.y));
    }
    cutter.solid = std::make_shared<const ToolSolid>(ToolSolid{std::move(flutes), std::move(shank), angle});
    return cutter;
}

/// A core drill: a tube of 12 mm outside and 8 mm inside, hollow up to its shank.
inline Cutter annular(double length = 60.0) {
    const TriangleMesh tube = shapes::tube(6.0, 4.0, length, 720);
    const RevolutionEnvelope envelope = revolutionEnvelope(tube, 0.005).value();
    Cutter cutter = make(CutterType::profile, 2.0 * envelope.widest, 0.0, length);
    cutter.profile = envelope.profile;
    const Progress progress;
    cutter.solid = std::make_shared<const ToolSolid>(
        turningSolid(hollowSection(tube, cutter.profile, 0.005, progress).value().section, cutter.profile));
    return cutter;
}

/// A scraper of 8 × 2 × 60 mm. @param fluteLength of them; the rest is a shank of the same section
inline Cutter scraper(double angle = 0.0, double fluteLength = 60.0) {
    TriangleMesh shank;
    if (fluteLength < 60.0) shank = shapes::box({-4.0, -1.0, fluteLength}, {4.0, 1.0, 60.0});
    return fixed(shapes::box({-4.0, -1.0, 0.0}, {4.0, 1.0, fluteLength}), std::move(shank), angle);
}

} // namespace burin::cutters

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/volume/voxelisation.h"

namespace burin {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string place(const glm::dvec3& point) {
    return "(" + formatFixed(point.x, 3) + ", " + formatFixed(point.y, 3) + ", " + formatFixed(point.z, 3) + ")";
}

} // namespace

std::string VoxelisationReport::warning() const {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    const auto lines = [](std::size_t count) { return counted(count, "scanline", "scanlines"); };
    if (openEdges > 0) {
        const std::string hole = "the surface is open at " + counted(openEdges, "edge", "edges") + " (" +
                                 counted(holes, "rim", "rims") + ")";
        add(linesThroughHoles > 0 ? hole + ": what it encloses on " + lines(linesThroughHoles) + " is a guess"
                                  : hole + ", which no scanline meets");
    }
    if (linesWithTurnedFaces > 0)
        add("faces do not agree on what is outside on " + lines(linesWithTurnedFaces) +
            ": every second stretch of them was filled");
    if (linesInsideOut > 0) add("a shell is turned inside out on " + lines(linesInsideOut) + ": it was filled as well");
    if (linesWithOverlaps > 0)
        add("shells overlap on " + lines(linesWithOverlaps) + ": whatever any of them holds was filled");
    if (duplicateTriangles > 0)
        add(counted(duplicateTriangles, "triangle that is there twice was", "triangles that are there twice were") +
            " counted once");
    if (!text.empty() && !doubtful.empty())
        text += ", between " + place(doubtful.low) + " and " + place(doubtful.high) + " mm";
    return text;
}

} // namespace burin

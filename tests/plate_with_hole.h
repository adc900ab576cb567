// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace burin::test {

/// A plate about the origin, from z = 0 up, with a round hole through its middle, whose wall has 96 facets.
/// @param half half of its sides, mm
inline TriangleMesh plateWithHole(const glm::dvec2& half, double thickness, double radius) {
    constexpr int count = 96;
    TriangleMesh plate;
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<std::uint32_t>(plate.vertices.size());
        plate.vertices.insert(plate.vertices.end(), {a, b, c});
        plate.triangles.push_back({first, first + 1, first + 2});
    };
    const auto on = [&](int i, double z) {
        const double angle = 2.0 * pi * (i % count) / count;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    const auto border = [&](int i, double z) { // where a ray from the middle leaves the plate
        const glm::dvec3 out = on(i, 0.0);
        const double far = std::min(half.x / std::max(std::abs(out.x), 1e-9), half.y / std::max(std::abs(out.y), 1e-9));
        return glm::dvec3(far * out.x, far * out.y, z);
    };
    const double top = thickness;
    for (int i = 0; i < count; ++i) {
        add(on(i, top), border(i, top), border(i + 1, top));
        add(on(i, top), border(i + 1, top), on(i + 1, top));
        add(on(i, 0.0), border(i + 1, 0.0), border(i, 0.0));
        add(on(i, 0.0), on(i + 1, 0.0), border(i + 1, 0.0));
        add(border(i, 0.0), border(i + 1, 0.0), border(i + 1, top));
        add(border(i, 0.0), border(i + 1, top), border(i, top));
        add(on(i, 0.0), on(i, top), on(i + 1, top));
        add(on(i, 0.0), on(i + 1, top), on(i + 1, 0.0));
    }
    return plate;
}

/// A plate about the origin with its top at z = 0, with a round stud on its middle, whose wall has 96 facets.
/// @param half half of its sides, mm @param thickness below z = 0, mm
inline TriangleMesh plateWithStud(const glm::dvec2& half, double thickness, double radius, double height) {
    TriangleMesh part = plateWithHole(half, thickness, radius); // its facets serve as top and sides of the plate
    for (glm::dvec3& vertex : part.vertices) vertex.z -= thickness;
    constexpr int count = 96;
    const auto on = [&](int i, double z) {
        const double angle = 2.0 * pi * (i % count) / count;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    TriangleMesh plate;
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<std::uint32_t>(plate.vertices.size());
        plate.vertices.insert(plate.vertices.end(), {a, b, c});
        plate.triangles.push_back({first, first + 1, first + 2});
    };
    for (const auto& corners : part.triangles) { // without the wall of the hole
        const auto away = [&](std::size_t i) { return glm::length(glm::dvec2(part.vertices[corners[i]])); };
        if (std::max({away(0), away(1), away(2)}) < radius + 1e-9) continue;
        add(part.vertices[corners[0]], part.vertices[corners[1]], part.vertices[corners[2]]);
    }
    for (int i = 0; i < count; ++i) {
        add(on(i, 0.0), on(i + 1, 0.0), on(i + 1, height));
        add(on(i, 0.0), on(i + 1, height), on(i, height));
        add(on(i, height), on(i + 1, height), {0.0, 0.0, height});
        add(on(i + 1, -thickness), on(i, -thickness), {0.0, 0.0, -thickness});
    }
    return plate;
}

} // namespace burin::test

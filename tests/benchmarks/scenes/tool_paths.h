// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin::benchmarks {

/// @param radius mm
/// @param length  of the flutes, in radii
Cutter cutterOf(CutterType type, double radius, double length = 2.0);

/// A smooth random walk inside a scene, like a wandering hand, mostly in solid material, which is the worst case for a
/// tick.
/// @param side  of the scene, voxels of 1 mm
/// @param reach of the tool, mm: the distance that tips keep from the sides
/// @param step  mm per tick
/// @return ticks + 1 tips; the same for the same arguments on every machine
std::vector<glm::dvec3> walk(double side, double reach, double step, std::size_t ticks, unsigned seed = 1);

/// Length of flutes that reach out of the scene in a walk from above, in radii.
inline constexpr double fluteLengthFromAbove = 3.5;
/// Such a walk that rises and falls by at most nine tenths of a radius about tips 2.2 radii below the scene's top: a
/// tool that mills from above, as on any machine.
std::vector<glm::dvec3> walkFromAbove(double side, double radius, double step, std::size_t ticks);

/// Zig-zag in a plane at 20 degrees to the lines, with a step-over of half a radius, half immersed.
std::vector<glm::dvec3> raster(double side, double radius, double step, std::size_t ticks);

/// The same tips with an axis that oscillates about a direction tilted from +Z.
/// @param tilt  rad, towards +X; the axis oscillates by a twentieth of it, a quarter of a degree per tick at most
std::vector<ToolPose> tilted(const std::vector<glm::dvec3>& tips, double tilt);
std::vector<ToolPose> upright(const std::vector<glm::dvec3>& tips);

} // namespace burin::benchmarks

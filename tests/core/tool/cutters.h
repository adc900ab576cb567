// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/tool/tool.h"

#include <cmath>
#include <vector>

/// One cutter of every type, with the radius of its flutes as a function of the height, derived directly from its
/// drawing.
namespace burin::cutters {

inline Cutter make(CutterType type, double diameter, double corner, double fluteLength) {
    return {type, diameter, corner, fluteLength, 0.8 * diameter, fluteLength + 20.0, {{20.0, 24.0, 12.0}}};
}

inline Cutter ball() {
    return make(CutterType::ball, 6.0, 3.0, 12.0);
}
inline Cutter flat() {
    return make(CutterType::flat, 6.0, 0.0, 12.0);
}
inline Cutter bullNose() {
    return make(CutterType::bullNose, 6.0, 1.0, 12.0);
}
inline Cutter taper() { // rounded by 0.5, 10° per side, the cone ends at about 8.9
    Cutter cutter = make(CutterType::taper, 6.0, 0.5, 12.0);
    cutter.tipDiameter = 3.0;
    cutter.taperAngle = 10.0 * pi / 180.0;
    return cutter;
}
inline Cutter taperBall() {
    Cutter cutter = make(CutterType::taperBall, 4.0, 1.0, 8.0);
    cutter.taperAngle = 10.0 * pi / 180.0;
    return cutter;
}
inline Cutter drill() {
    Cutter cutter = make(CutterType::drill, 5.0, 0.0, 12.0);
    cutter.taperAngle = 59.0 * pi / 180.0;
    return cutter;
}
inline Cutter chamfer() {
    Cutter cutter = make(CutterType::chamfer, 6.0, 0.0, 5.0);
    cutter.tipDiameter = 1.0;
    cutter.taperAngle = 45.0 * pi / 180.0;
    return cutter;
}
inline Cutter lollipop() {
    return make(CutterType::lollipop, 6.0, 3.0, 5.4);
}
/// A cutter for a rail: a flat, a convex and a concave arc, a shoulder, a cylinder.
inline Cutter profile() {
    Cutter cutter = make(CutterType::profile, 10.0, 0.0, 9.0);
    cutter.profile = {{1.0, 0.0},            // flat tip
                      {2.0, 1.0, 1.0},       // convex: quarter of a circle about (1, 1)
                      {4.0, 3.0, 2.0, true}, // concave: quarter of a circle about (4, 1)
                      {5.0, 3.0},
                      {5.0, 9.0}}; // shoulder and cylinder
    return cutter;
}

struct Named {
    const char* name;
    Cutter cutter;
};
inline std::vector<Named> all() {
    return {{"ball", ball()},
            {"flat", flat()},
            {"bull nose", bullNose()},
            {"taper", taper()},
            {"taper ball", taperBall()},
            {"drill", drill()},
            {"chamfer", chamfer()},
            {"lollipop", lollipop()},
            {"profile", profile()}};
}

/// Radius of the flutes at a height, from the drawing. At a shoulder the larger radius.
inline double drawnRadius(const Cutter& cutter, double height) {
    const double widest = 0.5 * cutter.diameter, corner = cutter.cornerRadius;
    const auto circle = [](double radius, double up) { return std::sqrt(std::max(0.0, radius * radius - up * up)); };
    const double slope = std::tan(cutter.taperAngle);
    switch (cutter.type) {
    case CutterType::ball:
    case CutterType::flat:
    case CutterType::bullNose:
        return height >= corner ? widest : widest - corner + circle(corner, height - corner);
    case CutterType::taper: {
        // The rounding is where a disc of its radius touches both the level line and the cone.
        const double ring = 0.5 * cutter.tipDiameter - corner * std::tan(0.5 * (0.5 * pi - cutter.taperAngle));
        const double touch = corner - corner * std::sin(cutter.taperAngle);
        if (height < touch) return ring + circle(corner, height - corner);
        return std::min(widest, 0.5 * cutter.tipDiameter + height * slope);
    }
    case CutterType::taperBall: {
        const double touch = corner - corner * std::sin(cutter.taperAngle);
        if (height < touch) return circle(corner, height - corner);
        // The cone's point lies corner / sine of the angle below the ball's centre.
        return std::min(widest, (height - corner + corner / std::sin(cutter.taperAngle)) * slope);
    }
    case CutterType::drill:
    case CutterType::chamfer:
        return std::min(widest, 0.5 * cutter.tipDiameter + height * slope);
    case CutterType::lollipop:
        return circle(widest, height - widest);
    case CutterType::profile: // as in profile() above
        if (height < 1.0) return 1.0 + circle(1.0, height - 1.0);
        if (height < 3.0) return 4.0 - circle(2.0, height - 1.0);
        return 5.0;
    }
    return 0.0;
}

} // namespace burin::cutters

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path_fixture.h"

#include <rapidcheck.h>

#include <cmath>

namespace burin::test {

/// A stroke with some corners about the origin, up to 18 mm to the side and 12 mm up. For use within a property of
/// RapidCheck.
inline Take randomTake() {
    std::vector<glm::dvec3> corners;
    const int count = *rc::gen::inRange(2, 6);
    for (int i = 0; i < count; ++i)
        corners.push_back(
            {0.1 * *rc::gen::inRange(-180, 180), 0.1 * *rc::gen::inRange(-180, 180), 0.1 * *rc::gen::inRange(0, 120)});
    return takeOf(along(corners, 400.0));
}

/// Some edits with random parameters that suit the same stroke. @param surface include edits of the surface step, which
/// follows the recording's
inline std::vector<Edit> randomEdits(bool surface) {
    std::vector<Edit> edits;
    const int count = *rc::gen::inRange(0, surface ? 2 : 4);
    const auto length = [] { return 0.1 * *rc::gen::inRange(-60, 60); };
    for (int i = 0; i < count; ++i) {
        const SourceInterval interval{1, *rc::gen::inRange(0, 60), *rc::gen::inRange(60, 200)};
        const glm::dvec3 by(length(), length(), length());
        LiftArea lift;
        lift.outline = {{-9, -9, 0}, {by.x + 9, -9, 0}, {0, by.y + 9, 0}};
        RemoveArea remove;
        remove.outline = {{0, -9, 0}, {9, by.x, 0}, {0, 9, 0}};
        const std::vector<Edit> recording{{CutOut{interval}},
                                          {Trim{interval, std::abs(by.x), 1.0}},
                                          {Extend{interval, std::abs(by.y), std::abs(by.z)}},
                                          {KeepTabs{{by, -by}, 1.0 + std::abs(by.x), 1.5}},
                                          {Split{{1, interval.last}}},
                                          {Join{{}, 100.0}},
                                          {Reverse{interval}},
                                          {Mirror{interval, Mirror::Across::y, by.x, true}},
                                          {Rotate{interval, by, by.z}},
                                          {burin::Array{interval, by, {}, by.x, 2.0}},
                                          {MovePoints{interval, by, 3.0, MovePoints::Along::free}},
                                          {MovePoints{interval, by, 3.0, MovePoints::Along::surface}},
                                          {InsertPoint{{1, interval.last}, std::abs(by.x), by, 3.0}},
                                          {ReplaceInterval{{}, {by, -by, {by.y, by.x, 0}}}},
                                          {lift},
                                          {remove},
                                          {SmoothShape{3.0, std::abs(by.x)}},
                                          {Smooth{5.0, std::abs(by.x)}},
                                          {SmoothSpline{5.0, std::abs(by.x)}}};
        const std::vector<Edit> onSurface{{Offset{interval, by.x}}, {Simplify{0.5}}, {LayOnPart{0.2}}};
        edits.push_back(*rc::gen::elementOf(surface ? onSurface : recording));
    }
    return edits;
}

} // namespace burin::test

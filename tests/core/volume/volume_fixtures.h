// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <new>
#include <string>
#include <vector>

/// The volumes of tests/fixtures/volumes: small, made by rule, the same in every run. A rule never changes once its
/// file is written, otherwise the file would prove nothing any more.
namespace burin::fixture {

struct VolumeFixture {
    const char* name; ///< of the file, without its ending
    Grid grid;
    PropertyList properties;
    std::vector<Segment> (*line)(LineIndex line);
};

/// Runs along y, of 6 voxels. 17 × 2 bricks of 8 × 8 scanlines in two groups; those at the end of v are cut off, and so
/// is the last of u. Ends to 1/256 voxel. The contents of a brick depend on its position along u.
inline std::vector<Segment> lineOfSeveralBricks(LineIndex line) {
    enum : PropertyIndex { air, wax, aluminium, part, softWax };
    constexpr RunPosition end = 6 * unitsPerVoxel;
    const int u = line.u % 8, v = line.v % 8;
    const auto at = [](int unit) { return static_cast<RunPosition>(unit); };
    switch (line.u / 8 % 6) {
    case 1: // inclined planes
        return {{at(301 + 5 * u + 11 * v), wax}, {at(1100 - 7 * u + v), aluminium}, {end, air}};
    case 2: // a bowl
        return {{at(700 + 3 * (u - 4) * (u - 4) + 2 * (v - 3) * (v - 3) + u * v), part}, {end, air}};
    case 3: // solid
        return {{end, wax}};
    case 4: { // irregular
        std::vector<Segment> segments;
        int which = u + v;
        for (RunPosition place = 1 + at(31 * u + 17 * v) % 97; place < end; place += 1 + place * 7919 % 211)
            segments.emplace_back(place, static_cast<PropertyIndex>(which++ % 5));
        segments.emplace_back(end, static_cast<PropertyIndex>(which % 5));
        return segments;
    }
    case 5: // three kinds of lines
        if (u % 3 == 0) return {{end, air}};
        if (u % 3 == 1) return {{at(90), air}, {at(512 + v), softWax}, {at(700), wax}, {end, air}};
        return {{at(1000 + u * v), part}, {end, softWax}};
    default:
        return {{end, air}};
    }
}

inline VolumeFixture severalBricks() {
    PropertyList list;
    Property wax;
    wax.id = "wax";
    wax.name = "Wachs, grün";
    wax.colour = {200, 180, 3};
    wax.values["density"] = {0.9375, "g/cm^3", "a table", false};
    wax.values["hardness of the day"] = {0.1, "HB", "measured", true};
    Property aluminium;
    aluminium.id = aluminium.name = "aluminium";
    Property part;
    part.id = part.name = "part";
    part.machinability = Machinability::isProtected;
    Property softWax = wax;
    softWax.id = "wax-soft";
    softWax.base = "wax";
    softWax.values.clear();
    for (const Property& property : {wax, aluminium, part, softWax}) (void)list.add(property);
    return {"several-bricks", *Grid::make({-3.5, 1.25, 10.0}, 0.25, {10, 6, 132}, RunAxis::y), list,
            lineOfSeveralBricks};
}

/// 2 × 2 bricks, runs along z, and 40 properties: with more than 32 a brick stores its properties differently.
inline std::vector<Segment> lineOfManyProperties(LineIndex line) {
    std::vector<Segment> segments;
    const RunPosition step = 61 + static_cast<RunPosition>(line.u);
    auto property = static_cast<PropertyIndex>((7 * line.u + 3 * line.v) % 41);
    for (RunPosition place = step; place < 4 * unitsPerVoxel; place += step) {
        segments.emplace_back(place, property);
        property = static_cast<PropertyIndex>((property + 5) % 41);
    }
    segments.emplace_back(4 * unitsPerVoxel, property);
    return segments;
}

inline VolumeFixture manyProperties() {
    PropertyList list;
    for (int i = 1; i <= 40; ++i) {
        Property property;
        property.id = property.name = "material-" + std::to_string(i);
        property.machinability = Machinability::isProtected;
        (void)list.add(property);
    }
    return {"many-properties", *Grid::make({0.0, 0.0, 0.0}, 1.0, {9, 10, 4}, RunAxis::z), list, lineOfManyProperties};
}

/// Lines that contain only air are not touched, so that bricks of air share their memory.
inline RunVolume volumeOf(const VolumeFixture& fixture) {
    constexpr std::size_t reserve = std::size_t{1} << 20;
    RunVolume volume = RunVolume::make(fixture.grid, fixture.properties, reserve).value();
    for (LineIndex line; line.v < fixture.grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < fixture.grid.lineCountU(); ++line.u) {
            const std::vector<Segment> segments = fixture.line(line);
            const bool air = segments.size() == 1 && segments[0].property() == airProperty;
            if (!air && !volume.setLine(line, segments)) throw std::bad_alloc();
        }
    return volume;
}

} // namespace burin::fixture

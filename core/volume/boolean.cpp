// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/boolean.h"

#include "core/volume/assembly.h"
#include "core/volume/stretches.h"

#include <array>
#include <utility>

namespace burin {

namespace {

/// Where each property of `other` stands in `list`, which gains those that it has not.
Result<std::array<PropertyIndex, 256>> unite(PropertyList& list, const PropertyList& other) {
    std::array<PropertyIndex, 256> places{};
    for (int i = 1; i < other.size(); ++i) {
        const Property& property = other[static_cast<PropertyIndex>(i)];
        PropertyIndex& place = places[static_cast<std::size_t>(i)];
        for (int k = 1; k < list.size(); ++k)
            if (list[static_cast<PropertyIndex>(k)].id == property.id) place = static_cast<PropertyIndex>(k);
        if (place != airProperty) continue;
        const Result<PropertyIndex> added = list.add(property);
        if (!added) return added.error();
        place = *added;
    }
    return places;
}

/// @param choose the property of a place from those of both operands there
template <class Choose>
Result<RunVolume> combine(const VolumeSnapshot& a, const VolumeSnapshot& b, PropertyList properties, Choose choose) {
    if (!sameGrid(a.grid(), b.grid()))
        return Error{ErrorCode::argumentInvalid, "grid of the second volume", {}, "the grid of the first"};
    return assemble(a.grid(), std::move(properties), [&](LineIndex line, std::vector<Segment>& segments) {
        const std::span<const Segment> lineA = a.line(line), lineB = b.line(line);
        const std::size_t begin = segments.size();
        for (std::size_t i = 0, k = 0; i < lineA.size() && k < lineB.size();) {
            const RunPosition end = std::min(lineA[i].end(), lineB[k].end());
            const PropertyIndex property = choose(lineA[i].property(), lineB[k].property());
            if (segments.size() > begin && segments.back().property() == property) segments.pop_back();
            segments.emplace_back(end, property);
            if (lineA[i].end() == end) ++i;
            if (lineB[k].end() == end) ++k;
        }
    });
}

} // namespace

Result<RunVolume> unionOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    PropertyList properties = a.properties();
    const auto places = unite(properties, b.properties());
    if (!places) return places.error();
    return combine(a, b, std::move(properties),
                   [&](PropertyIndex inA, PropertyIndex inB) { return inA != airProperty ? inA : (*places)[inB]; });
}

Result<RunVolume> intersectionOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combine(a, b, a.properties(),
                   [](PropertyIndex inA, PropertyIndex inB) { return inB != airProperty ? inA : airProperty; });
}

Result<RunVolume> differenceOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combine(a, b, a.properties(),
                   [](PropertyIndex inA, PropertyIndex inB) { return inB == airProperty ? inA : airProperty; });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/drawn_edit.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr std::string_view planeKey = "at_mm";

void setPlane(Mirror& mirror, const std::vector<glm::dvec3>& places) {
    constexpr double shortest = 1.0; // mm
    if (places.size() < 2) return;
    const glm::dvec3 way = places.back() - places.front(), middle = 0.5 * (places.back() + places.front());
    if (std::hypot(way.x, way.y) < shortest) return;
    mirror.across = std::abs(way.y) >= std::abs(way.x) ? Mirror::Across::x : Mirror::Across::y;
    mirror.at = mirror.across == Mirror::Across::x ? middle.x : middle.y;
}

} // namespace

bool isDrawn(const EditParameters& parameters, std::string_view key) {
    if (std::holds_alternative<Mirror>(parameters)) return key == planeKey;
    const std::vector<EditField> fields = fieldsOf(parameters);
    const auto field = std::ranges::find(fields, key, &EditField::key);
    return field != fields.end() && std::holds_alternative<std::vector<glm::dvec3>>(field->value);
}

void setDrawn(EditParameters& parameters, std::string_view key, const std::vector<glm::dvec3>& places) {
    if (auto* mirror = std::get_if<Mirror>(&parameters))
        setPlane(*mirror, places);
    else
        setField(parameters, key, places);
}

std::optional<DrawnField> lastDrawn(const std::vector<Edit>& edits) {
    for (std::size_t i = edits.size(); i-- > 0;)
        for (const EditField& field : fieldsOf(edits[i].parameters))
            if (edits[i].enabled && isDrawn(edits[i].parameters, field.key))
                return DrawnField{i, std::string(field.key)};
    return std::nullopt;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/json_vector.h"
#include "core/setup/cylinder_shape.h"

namespace burin {

/// Stores every bit of the values.
inline nlohmann::json jsonOf(const CylinderShape& cylinder) {
    return {{"base_mm", jsonOf(cylinder.base)},
            {"axis", jsonOf(cylinder.axis)},
            {"radius_mm", cylinder.radius},
            {"height_mm", cylinder.height}};
}

/// Throws nlohmann's exceptions if `record` is not a cylinder.
inline CylinderShape cylinderOf(const nlohmann::json& record) {
    return {vectorOf(record.at("base_mm")), vectorOf(record.at("axis")), record.at("radius_mm").get<double>(),
            record.at("height_mm").get<double>()};
}

} // namespace burin

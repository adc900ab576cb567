// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gp_Pnt.hxx>
#include <gp_XYZ.hxx>

#include <glm/glm.hpp>

namespace burin {

inline gp_Pnt toPoint(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
inline glm::dvec3 toVector(const gp_XYZ& v) {
    return {v.X(), v.Y(), v.Z()};
}

} // namespace burin

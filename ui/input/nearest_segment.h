// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QPointF>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace burin {

/// How near the pointer has to be to something that it means, device-independent pixels.
inline constexpr double pointerReach = 8.0;

/// Where a place in the setup frame appears, device-independent pixels.
using Appearance = std::function<QPointF(const glm::dvec3&)>;

/// Where along a straight piece it appears nearest to the pointer: 0 at its beginning, 1 at its end.
double shareNearest(const QPointF& pointer, const glm::dvec3& from, const glm::dvec3& to, const Appearance& appearance);

/// The straight piece that appears nearest to the pointer, within its reach. Nothing: none is.
/// @param ends of piece i, mm, setup frame
std::optional<std::size_t> nearestSegment(const QPointF& pointer, std::size_t count,
                                          const std::function<std::pair<glm::dvec3, glm::dvec3>(std::size_t)>& ends,
                                          const Appearance& appearance);

} // namespace burin

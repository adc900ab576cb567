// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_solver.h"

#include <algorithm>
#include <cmath>

namespace burin {

bool GuideSolver::add(std::size_t guide, const GuideRows& rows) noexcept {
    for (const GuideRows::Row& row : rows) {
        Direction rest{row.normal, row.offset, guide};
        for (const Direction& held : *this) {
            const double share = glm::dot(held.normal, row.normal);
            rest.normal -= share * held.normal;
            rest.offset -= share * held.offset;
        }
        const double sine = glm::length(rest.normal);
        if (size_ == capacity || sine < smallestSine) return false;
        rest.normal /= sine;
        rest.offset /= sine;
        directions_[static_cast<std::size_t>(size_++)] = rest;
    }
    return true;
}

double GuideSolver::independence(const GuideRows& rows) const noexcept {
    double least = 1.0;
    for (const GuideRows::Row& row : rows) {
        glm::dvec3 rest = row.normal;
        for (const Direction& held : *this) rest -= glm::dot(held.normal, row.normal) * held.normal;
        least = std::min(least, glm::length(rest));
    }
    // Two planes may each be independent of the directions held, and yet share the only direction that is free.
    return size_ + rows.count > capacity ? 0.0 : least;
}

bool GuideSolver::concerns(std::size_t guide, const GuideRows& rows) const noexcept {
    constexpr double noticeable = 0.05;
    return std::any_of(begin(), end(), [&](const Direction& held) {
        return held.guide == guide && std::any_of(rows.begin(), rows.end(), [&](const GuideRows::Row& row) {
                   return std::abs(glm::dot(held.normal, row.normal)) > noticeable;
               });
    });
}

glm::dvec3 GuideSolver::nearest(const glm::dvec3& hand) const noexcept {
    glm::dvec3 point = hand;
    for (const Direction& held : *this) point += held.normal * (held.offset - glm::dot(held.normal, hand));
    return point;
}

} // namespace burin

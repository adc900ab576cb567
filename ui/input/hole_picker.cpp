// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/hole_picker.h"

#include "ui/input/body_picker.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double onWall = 0.05; // mm: facets of a hole lie so near to its circle

bool isOnWall(const glm::dvec3& place, const UprightHole& hole) noexcept {
    return std::abs(glm::distance(glm::dvec2(place), hole.centre) - hole.radius) <= onWall &&
           place.z >= hole.bottom - onWall && place.z <= hole.top + onWall;
}

/// Whether a line passes through a mouth of the hole before a distance.
bool passesMouth(const Ray& ray, double before, const UprightHole& hole) noexcept {
    const double height = ray.direction.z < 0.0 ? hole.top : hole.bottom;
    const double distance = (height - ray.origin.z) / ray.direction.z; // not finite along the plane of the mouth
    return distance > 0.0 && distance < before + onWall &&
           glm::distance(glm::dvec2(ray.origin + distance * ray.direction), hole.centre) < hole.radius;
}

} // namespace

std::optional<std::size_t> holeOn(const Ray& ray, std::optional<double> hit, const std::vector<UprightHole>& holes) {
    constexpr double far = 1e9; // mm
    std::optional<std::size_t> found;
    bool byWall = false;
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const bool wall = hit && isOnWall(ray.origin + *hit * ray.direction, holes[i]);
        if (!wall && (byWall || !passesMouth(ray, hit.value_or(far), holes[i]))) continue;
        if (wall == byWall && found && holes[i].radius >= holes[*found].radius) continue;
        found = i;
        byWall = wall;
    }
    return found;
}

void HolePicker::setPart(std::shared_ptr<const Model> part, std::vector<UprightHole> holes) {
    part_ = std::move(part);
    holes_ = std::move(holes);
}

bool HolePicker::press(const ViewportEvent& event) {
    if (event.button != Qt::LeftButton || !part_) return false;
    const Sight sight = sightOf(event);
    const Ray ray{sight.seenOrigin(), sight.direction};
    const std::optional<SeenBody> seen = bodyOn(sight, *part_, {});
    const std::optional<std::size_t> hole =
        holeOn(ray, seen ? std::optional(glm::distance(seen->place, ray.origin)) : std::nullopt, holes_);
    taken_ = hole || seen;
    if (hole)
        emit chosen(*hole);
    else if (seen)
        emit missed();
    return taken_;
}

bool HolePicker::release(const ViewportEvent& event) {
    return event.button == Qt::LeftButton && std::exchange(taken_, false);
}

bool HolePicker::key(int key, Qt::KeyboardModifiers) {
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter) return false;
    emit finished();
    return true;
}

QString HolePicker::escapeMeaning() {
    return tr("Esc or Enter: back to the pass");
}

} // namespace burin

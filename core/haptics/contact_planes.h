// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace burin {

/// A boundary, linearised: points x with dot(normal, x - origin) >= -gap are allowed.
struct ContactPlane {
    glm::dvec3 normal{0.0}; ///< unit, out of the part
    double gap = 0.0;       ///< mm from the origin to the plane, >= 0: the origin is allowed
};

/// Up to three planes that hold a point back together, all relative to one origin. Three determine a corner; a
/// fourth could only repeat it.
class ContactPlanes {
public:
    static constexpr int capacity = 3;

    int size() const noexcept { return size_; }
    const ContactPlane& operator[](int index) const noexcept { return planes_[static_cast<std::size_t>(index)]; }

    /// Takes a plane in. One that points nearly the same way as a plane held already takes its place: it is the same
    /// face, read anew. A fourth one takes the place of the plane farthest away.
    void add(ContactPlane plane) noexcept;

    /// The allowed point nearest to `goal`; both relative to the origin, mm. The origin itself where rounding leaves
    /// nothing better.
    glm::dvec3 nearestTo(const glm::dvec3& goal) const noexcept;

    /// Moves the origin by `offset`, mm. Drops planes that claim less clearance than the field's `clearance` at the new
    /// origin: the surface has bent away from them.
    void moveOrigin(const glm::dvec3& offset, double clearance) noexcept;

private:
    bool allows(const glm::dvec3& point) const noexcept;
    std::array<ContactPlane, capacity> planes_{};
    int size_ = 0;
};

} // namespace burin

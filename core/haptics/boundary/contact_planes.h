// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_vector.h"

#include <array>

namespace burin {

/// A boundary, linearised: changes x of a pose with dot(normal, x) >= -gap are allowed.
struct ContactPlane {
    PoseVector normal; ///< of the clearance: `move` about unit length, out of what bounds
    double gap = 0.0;  ///< mm of clearance at the origin, >= 0: the origin is allowed
};

/// Up to eight planes that hold a tool back together, all relative to one origin. A pose has five freedoms, so five
/// determine where it comes to rest; the others are faces nearby.
class ContactPlanes {
public:
    static constexpr int capacity = 8;

    /// @param sameArm mm: contacts whose arms are no farther apart can be one face
    explicit ContactPlanes(double sameArm = 0.0) noexcept : sameArm_(sameArm) {}

    int size() const noexcept { return size_; }
    const ContactPlane& operator[](int index) const noexcept { return planes_[static_cast<std::size_t>(index)]; }
    void clear() noexcept { size_ = 0; }

    /// Takes a plane in. One that points nearly the same way as a plane held already, and is met at the same arm, takes
    /// its place: it is the same face, read anew. One too many takes the place of the plane farthest away.
    void add(ContactPlane plane) noexcept;

    /// The allowed change nearest to `goal`; both relative to the origin. The origin itself where rounding leaves
    /// nothing better. The active planes are found by the method of Lawson and Hanson (Solving Least Squares Problems,
    /// 1974, ch. 23) for the forces that hold the tool there: none of them pulls.
    PoseVector nearestTo(const PoseVector& goal) const noexcept;

    /// Moves the origin. Drops planes that claim less than the true `clearance` at the new origin: the surface has bent
    /// away from them.
    void moveOrigin(const PoseVector& offset, double clearance) noexcept;

private:
    bool allows(const PoseVector& change) const noexcept;
    std::array<ContactPlane, capacity> planes_{};
    int size_ = 0;
    double sameArm_;
};

} // namespace burin

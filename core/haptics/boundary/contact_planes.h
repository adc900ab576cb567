// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_vector.h"

#include <array>

namespace burin {

/// A linearised boundary: changes x of a pose with dot(normal, x) >= -gap are allowed.
struct ContactPlane {
    PoseVector normal; ///< gradient of the clearance: `move` about unit length, pointing away from the obstacle
    double gap = 0.0;  ///< clearance at the origin, mm, >= 0: the origin is allowed
};

/// Up to eight planes that together hold a tool back, all relative to one origin. A pose has five degrees of freedom,
/// so five planes determine where it comes to rest; the others are faces nearby.
class ContactPlanes {
public:
    static constexpr int capacity = 8;

    /// @param sameArm mm: contacts whose lever arms differ by no more than this can belong to one face
    explicit ContactPlanes(double sameArm = 0.0) noexcept : sameArm_(sameArm) {}

    int size() const noexcept { return size_; }
    const ContactPlane& operator[](int index) const noexcept { return planes_[static_cast<std::size_t>(index)]; }
    void clear() noexcept { size_ = 0; }

    /// Adds a plane. If it has nearly the same normal as an existing plane, and touches the tool at the same lever arm,
    /// it replaces that plane: it is the same face, sampled again. If all planes are in use, it replaces the plane
    /// farthest away.
    void add(ContactPlane plane) noexcept;

    /// The allowed change nearest to `goal`; both relative to the origin. The origin itself if rounding errors leave
    /// nothing better. The active planes are found by the method of Lawson and Hanson (Solving Least Squares Problems,
    /// 1974, ch. 23), which solves for the non-negative contact forces that hold the tool there.
    PoseVector nearestTo(const PoseVector& goal) const noexcept;

    /// Moves the origin. Drops planes that indicate less than the true `clearance` at the new origin, because the
    /// surface curves away from them.
    void moveOrigin(const PoseVector& offset, double clearance) noexcept;

private:
    bool allows(const PoseVector& change) const noexcept;
    std::array<ContactPlane, capacity> planes_{};
    int size_ = 0;
    double sameArm_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"

#include <array>
#include <optional>
#include <vector>

namespace burin::benchmarks {

/// A sphere as a god-object on a mesh. It moves towards its goal until it touches, adds the plane that it touched, and
/// continues to the point on all planes that is nearest to the goal; three times at most. Ruspini, Kolarov & Khatib
/// 1997, in the steps of CHAI3D's cAlgorithmFingerProxy (three collision tests a tick, a small distance kept from what
/// was touched). Single-threaded; allocates.
class FingerProxy {
public:
    /// @param part  must outlive the object. @param radius  mm
    FingerProxy(const MeshDistance& part, double radius) : part_(part), radius_(radius) {}
    void place(const glm::dvec3& centre) { centre_ = centre; }
    /// The centre after a tick. @param goal  mm, position commanded by the hand
    const glm::dvec3& advance(const glm::dvec3& goal);

private:
    struct Contact {
        double share = 1.0; ///< of the motion
        glm::dvec3 normal{0.0};
    };
    std::optional<Contact> firstContact(const glm::dvec3& way);
    void meet(const Triangle& triangle, const glm::dvec3& way, std::optional<Contact>& first) const;
    void meetFace(const Triangle& triangle, const glm::dvec3& way, std::optional<Contact>& first) const;
    void meetEdge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& way,
                  std::optional<Contact>& first) const;
    void meetCorner(const glm::dvec3& corner, const glm::dvec3& way, std::optional<Contact>& first) const;
    static void take(double share, const glm::dvec3& normal, const glm::dvec3& way, std::optional<Contact>& first);

    const MeshDistance& part_;
    double radius_;
    glm::dvec3 centre_{0.0};
    std::vector<std::uint32_t> near_;
};

} // namespace burin::benchmarks

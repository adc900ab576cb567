// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <algorithm>
#include <cmath>

namespace burin::test {

inline glm::dvec3 up(double z) {
    return {0.0, 0.0, z};
}

/// Clearance of a ball from a solid with a closed formula: for a ball of radius R with its tip at a point it is sdf(tip
/// + R z) - R. Beyond `band` the clearance is reported as coarse and too small, as a ToolField may.
template <class Solid>
class BallField final : public ClearanceField {
public:
    BallField(Solid solid, double radius, double spacing = 0.25, double band = 1e300)
        : solid_(solid), radius_(radius), spacing_(spacing), band_(band) {}

    double clearance(const glm::dvec3& tip) const noexcept {
        return solid_.distance(tip + glm::dvec3(0.0, 0.0, radius_)) - radius_;
    }
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        FieldSample sample;
        sample.clearance = clearance(tip);
        constexpr double h = 1e-6;
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 offset(0.0);
            offset[i] = h;
            sample.gradient[i] = (clearance(tip + offset) - clearance(tip - offset)) / (2.0 * h);
        }
        sample.fine = std::abs(sample.clearance) < band_;
        if (!sample.fine) sample.clearance = band_ + 0.6 * (sample.clearance - band_);
        return sample;
    }
    double errorBound() const noexcept override { return 0.0; }
    double spacing() const noexcept override { return spacing_; }
    const Solid& solid() const noexcept { return solid_; }
    double radius() const noexcept { return radius_; }

private:
    Solid solid_;
    double radius_, spacing_, band_;
};

/// Everything below a plane through the origin.
struct PlaneSolid {
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double distance(const glm::dvec3& p) const noexcept { return glm::dot(normal, p); }
};

struct SphereSolid {
    double radius = 10.0;
    double distance(const glm::dvec3& p) const noexcept { return glm::length(p) - radius; }
};

/// Around the z axis.
struct TorusSolid {
    double major = 12.0, minor = 3.0;
    double distance(const glm::dvec3& p) const noexcept {
        return std::hypot(std::hypot(p.x, p.y) - major, p.z) - minor;
    }
};

/// A box about the origin.
struct BoxSolid {
    glm::dvec3 half{5.0};
    double distance(const glm::dvec3& p) const noexcept {
        const glm::dvec3 q = glm::abs(p) - half;
        return glm::length(glm::max(q, glm::dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
    }
};

/// Everything below z = 0 except a pocket |x| < half.x, |y| < half.y, z > -depth.
struct PocketSolid {
    glm::dvec2 half{8.0, 6.0};
    double depth = 10.0;
    double distance(const glm::dvec3& p) const noexcept {
        const double toWall = std::min(half.x - std::abs(p.x), half.y - std::abs(p.y));
        const double toFloor = p.z + depth;
        if (toWall >= 0.0 && p.z >= 0.0) return std::min(std::hypot(toWall, p.z), toFloor);
        if (toWall >= 0.0 && toFloor >= 0.0) return std::min(toWall, toFloor);
        if (p.z >= 0.0) return p.z;
        const glm::dvec3 q(std::abs(p.x) - half.x, std::abs(p.y) - half.y, -toFloor);
        return -std::min(-p.z, glm::length(glm::max(q, glm::dvec3(0.0))));
    }
};

/// An infinite thin wall |x| < thickness / 2.
struct WallSolid {
    double thickness = 1.0;
    double distance(const glm::dvec3& p) const noexcept { return std::abs(p.x) - 0.5 * thickness; }
};

} // namespace burin::test

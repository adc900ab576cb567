// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/contact_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double sameFaceCosine = 0.98;
/// mm; below what a path can resolve, far above rounding errors at the size of a workpiece.
constexpr double rounding = 1e-9;
/// Share of a normal's length that must be independent of the span of the other normals.
constexpr double leastOwnShare = 1e-6;

template <class Value>
using Each = std::array<Value, ContactPlanes::capacity>;

/// The contact forces of planes that together hold a goal back: the sum of the normals times the forces takes the goal
/// to the nearest allowed position.
class PlaneForces {
public:
    PlaneForces(const ContactPlanes& planes, const PoseVector& goal) noexcept : count_(planes.size()) {
        for (int i = 0; i < count_; ++i) {
            missing_[at(i)] = -planes[i].gap - dot(planes[i].normal, goal);
            for (int j = 0; j <= i; ++j)
                products_[at(i)][at(j)] = products_[at(j)][at(i)] = dot(planes[i].normal, planes[j].normal);
        }
    }

    const Each<double>& solve() noexcept {
        for (int round = 0; round < 3 * ContactPlanes::capacity; ++round) {
            const int plane = mostViolated();
            if (plane < 0) break;
            active_[activeCount_++] = plane;
            if (!settle()) { // it is linearly dependent on the others
                --activeCount_;
                useless_[at(plane)] = true;
            }
        }
        return force_;
    }

private:
    static std::size_t at(int index) noexcept { return static_cast<std::size_t>(index); }

    int mostViolated() const noexcept {
        int most = -1;
        double worst = rounding;
        for (int i = 0; i < count_; ++i) {
            const auto end = active_.begin() + static_cast<std::ptrdiff_t>(activeCount_);
            if (useless_[at(i)] || std::find(active_.begin(), end, i) != end) continue;
            double violation = missing_[at(i)];
            for (int j = 0; j < count_; ++j) violation -= products_[at(i)][at(j)] * force_[at(j)];
            if (!(violation > worst)) continue;
            worst = violation;
            most = i;
        }
        return most;
    }

    /// Computes forces that fulfil the active planes exactly; planes that would pull are removed, one by one.
    bool settle() noexcept {
        for (bool first = true; activeCount_ > 0; first = false) {
            if (!factor()) {
                if (!first) return true;
                if (!exchange()) return false;
                continue;
            }
            Each<double> wanted{};
            for (std::size_t i = 0; i < activeCount_; ++i) wanted[i] = missing_[at(active_[i])];
            solve(activeCount_, wanted);
            double share = 1.0;
            std::size_t blocking = activeCount_;
            for (std::size_t i = 0; i < activeCount_; ++i) {
                if (wanted[i] > 0.0) continue;
                const double now = force_[at(active_[i])], reached = now / (now - wanted[i]);
                if (!(reached < share)) continue;
                share = reached;
                blocking = i;
            }
            for (std::size_t i = 0; i < activeCount_; ++i) {
                double& force = force_[at(active_[i])];
                force += share * (wanted[i] - force);
            }
            if (blocking == activeCount_) return true;
            force_[at(active_[blocking])] = 0.0; // sets the rounding error to zero
            dropIdle();
        }
        return true;
    }

    /// The last active plane is linearly dependent on the others: six of them hold a pose already. It takes over their
    /// forces until the force of one of them becomes zero, and that one is removed. (D. Goldfarb and A. Idnani, A
    /// numerically stable dual method for solving strictly convex quadratic programs, 1983: the step in the dual
    /// space.) Returns false if none would be removed.
    bool exchange() noexcept {
        const std::size_t others = activeCount_ - 1;
        const int last = active_[others];
        Each<double> share{};
        for (std::size_t i = 0; i < others; ++i) share[i] = products_[at(active_[i])][at(last)];
        solve(others, share);
        double step = std::numeric_limits<double>::infinity();
        std::size_t leaving = others;
        for (std::size_t i = 0; i < others; ++i) {
            if (!(share[i] > leastOwnShare)) continue;
            const double least = force_[at(active_[i])] / share[i];
            if (!(least < step)) continue;
            step = least;
            leaving = i;
        }
        if (leaving == others) return false;
        for (std::size_t i = 0; i < others; ++i) force_[at(active_[i])] -= step * share[i];
        force_[at(last)] += step;
        force_[at(active_[leaving])] = 0.0;
        dropIdle();
        return true;
    }

    /// Removes active planes with no force.
    void dropIdle() noexcept {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < activeCount_; ++i) {
            double& force = force_[at(active_[i])];
            if (force <= 0.0)
                force = 0.0;
            else
                active_[kept++] = active_[i];
        }
        activeCount_ = kept;
    }

    /// Cholesky decomposition of the active planes' products. Returns false if the planes are linearly dependent; all
    /// rows before the dependent one are valid then.
    bool factor() noexcept {
        for (std::size_t i = 0; i < activeCount_; ++i) {
            const Each<double>& products = products_[at(active_[i])];
            for (std::size_t j = 0; j <= i; ++j) {
                double rest = products[at(active_[j])];
                for (std::size_t k = 0; k < j; ++k) rest -= root_[i][k] * root_[j][k];
                if (j < i)
                    root_[i][j] = rest / root_[j][j];
                else if (rest > leastOwnShare * leastOwnShare * products[at(active_[i])])
                    root_[i][i] = std::sqrt(rest);
                else
                    return false;
            }
        }
        return true;
    }

    /// Solves for the first `count` active planes. @param values right-hand side, then the solution
    void solve(std::size_t count, Each<double>& values) const noexcept {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < i; ++k) values[i] -= root_[i][k] * values[k];
            values[i] /= root_[i][i];
        }
        for (std::size_t i = count; i-- > 0;) {
            for (std::size_t k = i + 1; k < count; ++k) values[i] -= root_[k][i] * values[k];
            values[i] /= root_[i][i];
        }
    }

    int count_;
    Each<double> missing_{}, force_{};
    Each<Each<double>> products_{}, root_{};
    Each<int> active_{};
    Each<bool> useless_{};
    std::size_t activeCount_ = 0;
};

} // namespace

void ContactPlanes::add(ContactPlane plane) noexcept {
    plane.gap = std::max(plane.gap, 0.0);
    const auto begin = planes_.begin(), end = planes_.begin() + size_;
    const auto same = std::find_if(begin, end, [&](const ContactPlane& held) {
        return glm::dot(held.normal.move, plane.normal.move) >
                   sameFaceCosine * glm::length(held.normal.move) * glm::length(plane.normal.move) &&
               glm::length(held.normal.turn - plane.normal.turn) <= sameArm_;
    });
    if (same != end) {
        *same = plane;
        return;
    }
    if (size_ < capacity) {
        planes_[static_cast<std::size_t>(size_++)] = plane;
        return;
    }
    *std::max_element(begin, end, [](const ContactPlane& a, const ContactPlane& b) { return a.gap < b.gap; }) = plane;
}

bool ContactPlanes::allows(const PoseVector& change) const noexcept {
    return std::all_of(planes_.begin(), planes_.begin() + size_, [&](const ContactPlane& plane) {
        return dot(plane.normal, change) >= -plane.gap - 2.0 * rounding;
    });
}

PoseVector ContactPlanes::nearestTo(const PoseVector& goal) const noexcept {
    if (allows(goal)) return goal;
    PlaneForces forces(*this, goal);
    const Each<double>& force = forces.solve();
    PoseVector nearest = goal;
    for (int i = 0; i < size_; ++i) nearest = nearest + (*this)[i].normal * force[static_cast<std::size_t>(i)];
    const PoseVector rest = nearest - goal;
    return allows(nearest) && dot(rest, rest) < dot(goal, goal) ? nearest : PoseVector{};
}

void ContactPlanes::moveOrigin(const PoseVector& offset, double clearance) noexcept {
    constexpr double bend = 1e-4; // mm, equal to the precision with which the proxy rests at the surface
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
        ContactPlane plane = (*this)[i];
        plane.gap += dot(plane.normal, offset);
        if (plane.gap < clearance - bend) continue;
        plane.gap = std::max(plane.gap, 0.0);
        planes_[static_cast<std::size_t>(kept++)] = plane;
    }
    size_ = kept;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Dry friction as a sampled loop bears it: a spring from the tool to an anchor that drags behind when the force
/// exceeds what it yields at (Hayward & Armstrong 2000). Its stiffness is bounded, it rests when the hand rests, and it
/// gives back no more than it took, but for k d² / 2 of a motion d in a tick, which any sampled spring gives.
///
/// A yield force that grows while the tool drags the anchor is followed at once, as when the tool comes into harder
/// material: the spring is stretched further than the tool has moved. The energy for that is taken from what dragging
/// has used up before, and never exceeds it; so the anchor can't drive a hand. Where that is not enough, the
/// force rises as the tool goes on.
/// Tick code.
class PlasticAnchor {
public:
    /// @param stiffness N/mm. @param mostForce N, that it is ever asked to yield at
    PlasticAnchor(double stiffness, double mostForce) noexcept;

    /// What an anchor yields at.
    struct Yield {
        double force = 0.0; ///< N, >= 0
        glm::dvec3 across{
            0.0};           ///< unit: a direction along which it yields at less, as a wall has no friction across it
        double along = 0.0; ///< N, >= 0: at which it yields along that
    };
    /// @param motion mm, of the tool in this tick
    /// @return N on the tool
    glm::dvec3 drag(const glm::dvec3& motion, const Yield& yield) noexcept;
    /// The same force from a spring of another stiffness, as when a millimetre of the tool becomes another one of the
    /// device. @param stiffness N/mm
    void setStiffness(double stiffness) noexcept;
    /// The anchor is where the tool is.
    void reset() noexcept;
    /// N·mm that it took and neither holds in its spring nor gave back, as far as it counts.
    double credit() const noexcept { return credit_; }

private:
    double stiffness_, mostCredit_;
    glm::dvec3 stretch_{0.0}; ///< mm, from the anchor to the tool
    double credit_ = 0.0;     ///< N·mm
    bool drags_ = false;      ///< the last tick ended at the yield force
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Dry friction for a sampled loop: a spring from the tool to an anchor that is dragged along when the force exceeds
/// the yield force (Hayward & Armstrong 2000). Its stiffness is bounded, it is at rest when the hand is, and it gives
/// back no more energy than it took, except for k d² / 2 of a motion d in a tick, which any sampled spring gives.
///
/// A yield force that grows while the tool drags the anchor is followed at once, as when the tool enters harder
/// material: the spring is stretched further than the tool has moved. The energy for this is taken from the energy
/// dissipated by dragging before, and never exceeds it, so that the anchor can't drive a hand. If that energy is not
/// enough, the force rises as the tool moves on.
/// Called in the haptic tick.
class PlasticAnchor {
public:
    /// @param stiffness N/mm. @param mostForce N, largest yield force that will be used
    PlasticAnchor(double stiffness, double mostForce) noexcept;

    /// The yield forces of an anchor.
    struct Yield {
        double force = 0.0; ///< N, >= 0
        glm::dvec3 across{
            0.0};           ///< unit: a direction with a lower yield force, as a wall has no friction along its normal
        double along = 0.0; ///< N, >= 0: yield force along that direction
    };
    /// @param motion mm, of the tool in this tick
    /// @return force on the tool, N
    glm::dvec3 drag(const glm::dvec3& motion, const Yield& yield) noexcept;
    /// Keeps the force while the spring gets another stiffness, as when a millimetre of the tool corresponds to another
    /// distance of the device. @param stiffness N/mm
    void setStiffness(double stiffness) noexcept;
    /// Moves the anchor to the tool.
    void reset() noexcept;
    /// Energy in N·mm that it took and neither stores in its spring nor gave back, up to a limit.
    double credit() const noexcept { return credit_; }

private:
    double stiffness_, mostCredit_;
    glm::dvec3 interval_{0.0}; ///< mm, from the anchor to the tool
    double credit_ = 0.0;      ///< N·mm
    bool drags_ = false;       ///< whether the last tick ended at the yield force
};

} // namespace burin

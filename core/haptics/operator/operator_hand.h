// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace burin {

/// A hand that holds a device's handle: a mass, and a damper and a spring to the position that the hand intends.
struct HandImpedance {
    double mass = 0.3;        ///< kg
    double damping = 10.0;    ///< N·s/m
    double stiffness = 600.0; ///< N/m
};

// Engineering estimates in the range of published arm and hand measurements (Fu & Cavusoglu 2012; Hasser & Cutkosky
// 2002 report mass, damping and stiffness that rise with the grip).
inline constexpr HandImpedance lightHand{0.05, 2.0, 100.0};
inline constexpr HandImpedance middleHand{0.15, 5.0, 300.0};
inline constexpr HandImpedance firmHand{0.3, 10.0, 600.0};

/// The moving part of the device that the hand carries along. Engineering estimate for a desktop stylus.
struct HandleInertia {
    double mass = 0.08;   ///< kg
    double damping = 0.5; ///< N·s/m
};

/// How a hand responds to a lasting force: it leans against it after a reaction time.
struct HandReaction {
    double share = 0.8;   ///< share of the force that is compensated, 0 … 1
    double seconds = 0.1; ///< time constant, s; our estimate between reflex (0.05 s) and reaction time (0.2 s)
};

/// Hand and handle as one mass, held by the hand's spring and damper, pushed by the device. The integrated quantity is
/// the deviation from the position that the hand intends: a practised hand moves the mass that it holds without
/// thinking (it applies mass · acceleration + handle damping · velocity by itself), so the intended motion drops out of
/// the equation
///     (m + M) e" + (b + B) e' + k e = F + leaning
/// and only the effect of the device's force on the hand remains.
class HandArm {
public:
    static constexpr double usualStep = 50e-6; ///< s: a thousandth of the fastest hand's period
    static constexpr double finestStep = 1e-6; ///< s

    /// @param step longest step of the integration, s; 10 to 20 µs where energies of µJ are measured. Not below
    /// finestStep.
    HandArm(const HandImpedance& hand, const HandleInertia& handle, const HandReaction& reaction,
            double step = usualStep) noexcept;

    /// Integrates with Runge-Kutta steps; the force is constant in between, as with a device's amplifier.
    /// @param force N. @param seconds > 0. No allocation.
    void advance(const glm::dvec3& force, double seconds) noexcept;
    /// A mechanical stop: sets the deviation and removes the velocity component along `outward` (unit length).
    void stopAt(const glm::dvec3& deviation, const glm::dvec3& outward) noexcept;
    /// Resets the hand: at rest at the intended position, without leaning.
    void reset() noexcept;

    glm::dvec3 deviation() const noexcept { return deviation_; } ///< mm
    glm::dvec3 velocity() const noexcept { return velocity_; }   ///< mm/s, of the deviation

private:
    glm::dvec3 accelerationAt(const glm::dvec3& deviation, const glm::dvec3& velocity,
                              const glm::dvec3& force) const noexcept;
    void step(const glm::dvec3& force, double seconds) noexcept;

    double mass_, damping_, stiffness_, longestStep_;
    HandReaction reaction_;
    glm::dvec3 deviation_{0.0};
    glm::dvec3 velocity_{0.0};
    glm::dvec3 leaning_{0.0}; ///< N
};

/// Physiological tremor: the hand's position varies by some hundredths of a millimetre at 8 to 12 Hz. A sum of sines
/// with frequencies and phases from a seeded generator with our own distribution: the same seed gives the same motion.
class Tremor {
public:
    /// @param rms mm along each axis; 0: none.
    Tremor(double rms, std::uint64_t seed) noexcept;
    glm::dvec3 at(double time) const noexcept; ///< mm

    static constexpr double lowestFrequency = 8.0;   ///< Hz
    static constexpr double highestFrequency = 12.0; ///< Hz

private:
    struct Wave {
        double angularFrequency = 0.0; ///< rad/s
        double phase = 0.0;            ///< rad
    };
    static constexpr int wavesPerAxis = 6;
    double amplitude_ = 0.0; ///< mm, of each wave
    std::array<std::array<Wave, wavesPerAxis>, 3> waves_{};
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/haptics/axis_turn.h"
#include "core/haptics/haptic_settings.h"

#include <optional>

namespace burin {

/// The meaning of the stylus' position.
enum class WorkspaceControl : std::uint8_t {
    position, ///< position of the tool
    rate,     ///< velocity of the tool, for styluses without motors that spring back to their centre
};

/// How movements of the hand are mapped to the tool. Plain data, passed to the loop at a tick's edge.
struct WorkspaceSettings {
    std::optional<double> scale; ///< mm of setup per mm of device, 0.001 … 1000; empty: unchanged
    /// device to setup, unit, according to the view direction of the camera; empty: unchanged
    std::optional<glm::dquat> rotation;
    bool clutched = false;          ///< the hand moves, the tool stays
    std::uint32_t clutchButton = 0; ///< bit mask of the stylus' buttons that act as the clutch while they are pressed
    std::uint32_t recentrings = 0;  ///< a counter; each increment starts a recentring
    WorkspaceControl control = WorkspaceControl::position;
    Box region; ///< mm, setup frame, to which rate control limits the tip; empty: no limit
};

/// Maps the device to the setup: scale, rotation, clutch, recentring. Whatever changes, the commanded tip keeps its
/// position, and moves only when the hand moves:
/// - a rotation waits until the hand feels nothing, as is the case while the clutch is engaged;
/// - the scale changes at once if the hand feels nothing, otherwise at most by a factor of e^(2 t) in t seconds;
/// - recentring makes the tool move by half more than the hand when the hand leaves the centre, and by half less when
///   it comes back (a drift proportional to the hand's speed: Conti & Khatib 2005, "Spanning large workspaces using
///   small haptic devices"); it ends within a tenth of the workspace;
/// - while the clutch is engaged, the commanded tip moves to the tool at `clutchSpeed`, so that the hand does not carry
///   a force along.
/// The axis is always that of the hand; after a use of the clutch or a rotation of the mapping it returns to it no
/// faster than a hand rotates.
/// Called in the haptic tick.
class Workspace {
public:
    static constexpr double clutchSpeed = 50.0;   ///< mm/s, device space
    static constexpr double scaleRate = 2.0;      ///< 1/s, rate of the scale's logarithm while a force is felt
    static constexpr double drift = 0.5;          ///< share of the hand's motion
    static constexpr double recentred = 0.1;      ///< share of the workspace's radius
    static constexpr double topSpeed = 100.0;     ///< mm/s, device space: speed of rate control at full deflection
    static constexpr double fullDeflection = 0.5; ///< share of the workspace's radius

    explicit Workspace(const HapticSettings& settings) noexcept;

    /// Called between two ticks. Values that are out of range, not finite or not applicable to this stylus are ignored.
    void set(const WorkspaceSettings& settings) noexcept;

    struct Place {
        ToolPose wanted;          ///< setup frame
        WorkspaceMapping mapping; ///< in force
        glm::dvec3 drive{0.0};    ///< mm/s of the commanded tip that are not due to the hand's motion; setup frame
        bool follows = true;      ///< whether the commanded tip follows the hand
    };
    /// @param tool position of the tool, mm; nullptr: none is loaded. @param quiet whether the hand feels no force.
    /// @param period s
    Place map(const Pose& device, std::uint32_t buttons, const glm::dvec3* tool, bool quiet, double period) noexcept;
    /// To be called when the motion of the hand is not known for some time.
    void forget() noexcept { known_ = false; }
    const WorkspaceMapping& mapping() const noexcept { return mapping_; }
    bool clutched() const noexcept { return clutched_; }
    bool recentring() const noexcept { return recentring_; }

private:
    glm::dvec3 rate(const glm::dvec3& place) const noexcept;
    glm::dvec3 drifted(const glm::dvec3& place) noexcept;
    bool change(bool quiet, double period) noexcept;

    WorkspaceMapping mapping_;
    WorkspaceSettings settings_;
    bool motors_;
    double radius_; ///< mm, of the stylus' workspace
    AxisFollower axis_;
    glm::dvec3 tip_{0.0};                   ///< mm, setup frame
    glm::dvec3 place_{0.0}, handAxis_{0.0}; ///< of the hand in the previous tick, device frame
    bool known_ = false, begun_ = false, clutched_ = false, recentring_ = false;
};

} // namespace burin

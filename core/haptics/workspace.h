// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/haptics/axis_turn.h"
#include "core/haptics/haptic_settings.h"

#include <optional>

namespace burin {

/// What the stylus' place means.
enum class WorkspaceControl : std::uint8_t {
    position, ///< where the tool shall be
    rate,     ///< how fast the tool shall go, for styluses without motors that go back to their middle
};

/// How the hand's movements become the tool's. Plain data, handed to the loop at a tick's edge.
struct WorkspaceSettings {
    std::optional<double> scale;        ///< mm of setup per mm of device, 0.001 … 1000; none: as it is
    std::optional<glm::dquat> rotation; ///< device to setup, unit, as the camera looks; none: as it is
    bool clutched = false;              ///< the hand moves, the tool stays
    std::uint32_t clutchButton = 0;     ///< bits of the stylus' buttons that do the same while they are down
    std::uint32_t recentrings = 0;      ///< counts; one more: recentre
    WorkspaceControl control = WorkspaceControl::position;
    Box region; ///< mm, setup frame, that rate control keeps the tip in; empty: no such limit
};

/// From the device to the setup: scale, turn, clutch, recentring. Whatever changes, the wanted tip stays where it is,
/// and moves on only as the hand moves:
/// - a turn waits until the hand feels nothing, as it does while the clutch is in;
/// - a scale changes at once where the hand feels nothing, and with a factor of e^(2 t) where it does;
/// - recentring lets the tool run ahead of the hand where that leaves the middle and lag where it comes back, by a half
///   (a drift that goes with the hand's speed: Conti & Khatib 2005, "Spanning large workspaces using small haptic
///   devices"); it ends within a tenth of the workspace;
/// - while the clutch is in, the wanted tip goes to the tool, at `clutchSpeed`: the hand carries no force about.
/// The axis is the hand's own always; after the clutch or a turn it goes there no faster than a hand turns.
/// Tick code.
class Workspace {
public:
    static constexpr double clutchSpeed = 50.0;   ///< mm/s, in the device
    static constexpr double scaleRate = 2.0;      ///< 1/s, of the scale's logarithm, under force
    static constexpr double drift = 0.5;          ///< of the hand's way
    static constexpr double recentred = 0.1;      ///< of the workspace's radius
    static constexpr double topSpeed = 100.0;     ///< mm/s in the device: rate control, at full deflection
    static constexpr double fullDeflection = 0.5; ///< of the workspace's radius

    explicit Workspace(const HapticSettings& settings) noexcept;

    /// Between two ticks. What is out of bounds, not finite or not for this stylus is left as it was.
    void set(const WorkspaceSettings& settings) noexcept;

    struct Place {
        ToolPose wanted;          ///< setup frame
        WorkspaceMapping mapping; ///< in force
        glm::dvec3 drive{0.0};    ///< mm/s of the wanted tip that are not the hand's own; setup frame
        bool follows = true;      ///< the wanted tip goes with the hand
    };
    /// @param tool where the tool is, mm; nullptr: none has been taken up. @param quiet the hand feels no force. @param
    /// period s
    Place map(const Pose& device, std::uint32_t buttons, const glm::dvec3* tool, bool quiet, double period) noexcept;
    /// Nobody knows where the hand has been meanwhile.
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
    glm::dvec3 place_{0.0}, handAxis_{0.0}; ///< of the hand in the tick before, device frame
    bool known_ = false, begun_ = false, clutched_ = false, recentring_ = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/guide_controller.h"

#include <vector>

namespace burin {

/// How the user wants a device's movements and buttons to work.
struct HandSettings {
    std::optional<double> scale;        ///< mm of setup per mm of device; empty: chosen to fit the stock
    std::optional<glm::dquat> rotation; ///< device to setup; empty: the device's orientation in front of the user
    WorkspaceControl control = WorkspaceControl::position;
    // Button numbers from 1; 0: no button.
    int clutchButton = 0; ///< the tool stays in place while it is held
    int levelButton = 0;  ///< goes to the next level below, or ends a pass
    int forceButton = 0;  ///< dead man's switch: forces only while it is held

    friend bool operator==(const HandSettings&, const HandSettings&) = default;
};

/// The device in the user's hand: how its movements are mapped to the tool, what its buttons do, and its condition.
/// Settings are entries of the undo stack; each device keeps its own as long as the window exists.
class HandController final : public Controller {
    Q_OBJECT
public:
    /// Share of the battery below which a warning is given once, and above which the next warning is possible. (Hot
    /// motors are reported by the session.)
    static constexpr double lowBattery = 0.15, fineBattery = 0.20;

    HandController(const Desk& desk, WorkpieceController& workpiece, MillController& mill, SessionRunner& session,
                   StylusController& styluses, GuideController& guides, QObject* parent);

    /// Whether a device is in use. The mouse points at the workpiece itself and needs no scaling.
    bool hasDevice() const noexcept { return device_.has_value(); }
    /// The device in use; empty: none.
    const std::optional<HandDevice>& device() const noexcept { return device_; }
    int buttons() const noexcept { return hasDevice() ? device_->description.buttons : 0; }
    /// The session that runs is moved by a device (empty: by none), whose settings apply from now on.
    void useDevice(const std::optional<HandDevice>& device);
    /// Whether the stylus may control the tool's velocity (rate control): it has no motors, which would push it away
    /// from its position, and does not do rate control by itself.
    bool canRate() const;
    const HandSettings& settings() const; ///< of the chosen stylus
    bool clutched() const noexcept { return clutched_; }
    const DeviceHealth& health() const noexcept { return session_.health(); }

    // These do nothing without a device. The first two are temporary; the others can be undone.
    void setClutched(bool clutched);
    void recentre();
    void setScale(double scale); ///< mm of setup per mm of device
    void scaleBy(double factor);
    /// Aligns the device with the view: moving the hand to the right moves the tool to the right of the picture; up
    /// stays up.
    /// @param right direction to the right of the picture, setup frame, not vertical
    void alignWith(const glm::dvec3& right);
    void setControl(WorkspaceControl control);
    void setClutchButton(int button);
    void setLevelButton(int button);
    void setForceButton(int button); ///< restarts mill mode, which ends a take

signals:
    void batteryLow(double share); ///< 0 … 1

private:
    struct Kept {
        std::string device; ///< id and mode
        HandSettings settings;
    };
    std::size_t kept();
    void change(const QString& title, const HandSettings& settings, bool merged = false);
    void set(std::size_t device, const HandSettings& settings);
    void prepare();
    void apply();
    void watch();

    WorkpieceController& workpiece_;
    MillController& mill_;
    SessionRunner& session_;
    StylusController& styluses_;
    GuideController& guides_;
    std::optional<HandDevice> device_;
    std::vector<Kept> kept_;
    std::uint32_t recentrings_ = 0;
    bool clutched_ = false, batteryTold_ = false;
};

} // namespace burin

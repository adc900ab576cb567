// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/guide_controller.h"

#include <vector>

namespace burin {

/// How the user wants a device's movements and buttons to work.
struct HandSettings {
    std::optional<double> scale;        ///< mm of setup per mm of device; none: as fits the stock
    std::optional<glm::dquat> rotation; ///< device to setup; none: as it lies before the user
    WorkspaceControl control = WorkspaceControl::position;
    // Numbers of buttons, from 1; 0: none does it.
    int clutchButton = 0; ///< the tool stays while it is held
    int levelButton = 0;  ///< the next level below, or the end of a pass
    int forceButton = 0;  ///< dead man's: forces only while it is held

    friend bool operator==(const HandSettings&, const HandSettings&) = default;
};

/// The device in the user's hand: how its movements become the tool's, what its buttons do, how it is doing. Settings
/// are entries of the undo stack; each device keeps its own as long as the window stands.
class HandController final : public Controller {
    Q_OBJECT
public:
    /// A low battery is told once, and again after it was fine. (Hot motors are the session's to tell.)
    static constexpr double lowBattery = 0.15, fineBattery = 0.20;

    HandController(const Desk& desk, WorkpieceController& workpiece, MillController& mill, SessionRunner& session,
                   StylusController& styluses, GuideController& guides, QObject* parent);

    /// A device is in the hand. The mouse points at the workpiece itself: there is nothing to scale.
    bool hasDevice() const noexcept { return mill_.device().has_value(); }
    int buttons() const noexcept { return hasDevice() ? mill_.device()->buttons : 0; }
    /// The stylus may lead the tool by its speed: it has no motors, which would push it out of its place, and does not
    /// do so by itself.
    bool canRate() const;
    const HandSettings& settings() const; ///< of the chosen stylus
    bool clutched() const noexcept { return clutched_; }
    const DeviceHealth& health() const noexcept { return session_.health(); }

    // Nothing happens without a device in the hand. The first two are of the moment; the others can be undone.
    void setClutched(bool clutched);
    void recentre();
    void setScale(double scale); ///< mm of setup per mm of device
    void scaleBy(double factor);
    /// What goes to the right of the picture follows a hand that goes to the right; up stays up. @param right of the
    /// picture, setup frame, not upright
    void alignWith(const glm::dvec3& right);
    void setControl(WorkspaceControl control);
    void setClutchButton(int button);
    void setLevelButton(int button);
    void setForceButton(int button); ///< takes the tool up anew: a take ends

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
    std::vector<Kept> kept_;
    std::uint32_t recentrings_ = 0;
    bool clutched_ = false, batteryTold_ = false;
};

} // namespace burin

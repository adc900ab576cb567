// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/session_runner.h"
#include "ui/workbench/stylus_controller.h"

#include <glm/glm.hpp>

#include <QElapsedTimer>
#include <QTimer>

#include <memory>
#include <string>

namespace burin {

/// Moves the view with a spring-centred device in the other hand than the stylus. It is found again after it was
/// disconnected. While the same device moves the tool, the view does not move.
class ViewDevice final : public Controller {
    Q_OBJECT
public:
    ViewDevice(const Desk& desk, StylusController& styluses, SessionRunner& session, QObject* parent);
    ~ViewDevice() override;

    /// @param id of a device, as StylusController::Choice has it; empty: none
    void choose(const std::string& id);
    /// The user keeps another assignment of a device's axes: if this is the device, it is used from now on.
    void assignAxes(const std::string& id);
    const std::string& chosen() const noexcept { return id_; }
    /// Whether a device can move the view: it has a spring-centred mode.
    bool suits(const std::string& id) const;
    bool connected() const; ///< whether it is being read

signals:
    /// Emitted at the frame rate while the device is deflected. @param push, turn share of full deflection, device
    /// frame; the turn is right-handed. @param seconds since the last one
    void pushed(const glm::dvec3& push, const glm::dvec3& turn, double seconds);
    void fitRequested(); ///< its first button was pressed

private:
    void follow();
    void connectDevice();
    void release();
    void close();
    void read();

    StylusController& styluses_;
    SessionRunner& session_;
    std::string id_;
    bool connecting_ = false;
    /// Opening failed and was reported: not tried again until it was disconnected or chosen again
    bool refused_ = false;
    std::shared_ptr<DeviceRegistry> registry_; ///< keeps the code of the plugin as long as the stylus
    std::unique_ptr<Stylus> stylus_;           ///< open
    QTimer timer_;
    QElapsedTimer clock_;
    double readAt_ = 0.0; ///< s
    std::uint32_t buttons_ = 0;
};

} // namespace burin

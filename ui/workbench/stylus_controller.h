// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_watch.h"
#include "ui/workbench/controller.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace burin {

/// The stylus that the user mills with: mouse and keyboard, or a connected device. A chosen device stays chosen while
/// it is disconnected.
class StylusController final : public Controller {
    Q_OBJECT
public:
    /// A stylus to choose; the first is always the mouse, with an empty id.
    struct Choice {
        std::string id, mode; ///< of DeviceRegistry
        QString name;
        bool there = true;
    };

    StylusController(const Desk& desk, QObject* parent);
    ~StylusController() override;

    /// Starts looking for devices, on a thread of its own. @param registry whose drivers to use; created if null
    void start(std::shared_ptr<DeviceRegistry> registry = {});
    /// Null before `start`.
    const std::shared_ptr<DeviceRegistry>& registry() const noexcept { return registry_; }
    const std::vector<Choice>& choices() const noexcept { return choices_; }
    std::size_t chosen() const noexcept { return chosen_; } ///< index in `choices`
    bool mouse() const noexcept { return chosen_ == 0; }
    const Choice& choice() const noexcept { return choices_[chosen_]; }
    const QString& chosenName() const noexcept { return choices_[chosen_].name; }
    void choose(std::size_t index); ///< does nothing if out of the range of `choices`
    /// Chooses a device as soon as it is connected, unless the user chose one meanwhile.
    void prefer(std::string id, std::string mode);

    /// How to look up the assignment of a device's axes that the user keeps, as UserSettings::axisMap has it. It is
    /// used for every device that is made here or by `make`.
    using AxisMaps = std::function<std::string(const std::string& id)>;
    void setAxisMaps(AxisMaps maps) { axisMaps_ = std::move(maps); }
    /// The text for a device; empty: the usual assignment.
    std::string axisMap(const std::string& id) const { return axisMaps_ ? axisMaps_(id) : std::string(); }
    /// Makes a stylus for a device with a kept assignment of its axes; any thread. Errors: deviceNotFound (no
    /// registry), those of DeviceRegistry::make and assignKept.
    static Result<AnyStylus> make(const std::shared_ptr<DeviceRegistry>& registry, const std::string& id,
                                  const std::string& mode, const std::string& axisMap);

    /// Connects the chosen device in the background. @param then gets null if that failed, which is reported by
    /// `failed`; not called if another connection is requested meanwhile. A stylus must not outlive this object.
    void connectDevice(std::function<void(std::unique_ptr<AnyStylus>)> then);

signals:
    void choiceMade(); ///< by the user

private:
    void hear(const DeviceChange& change);
    void select(const Choice& wanted);
    void choosePreferred();

    std::vector<Choice> choices_;
    std::size_t chosen_ = 0;
    std::string preferredId_, preferredMode_; ///< empty: none, or the user has chosen
    AxisMaps axisMaps_;
    std::shared_ptr<DeviceRegistry> registry_;
    std::unique_ptr<DeviceWatch> watch_; // last: it uses the registry, and calls this
};

} // namespace burin

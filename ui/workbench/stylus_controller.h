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

/// Which stylus the user mills with: mouse and keyboard, or a device that is plugged in. Devices come and go; one that
/// was chosen stays chosen while it is away.
class StylusController final : public Controller {
    Q_OBJECT
public:
    /// One way to mill; the first is always the mouse, with no id.
    struct Choice {
        std::string id, mode; ///< of DeviceRegistry
        QString name;
        bool there = true;
    };

    StylusController(const Desk& desk, QObject* parent);
    ~StylusController() override;

    /// Looks for devices from now on, on a thread of its own. @param registry whose drivers to use, made if there is
    /// none
    void start(std::shared_ptr<DeviceRegistry> registry = {});
    /// Null before `start`.
    const std::shared_ptr<DeviceRegistry>& registry() const noexcept { return registry_; }
    const std::vector<Choice>& choices() const noexcept { return choices_; }
    std::size_t chosen() const noexcept { return chosen_; } ///< index in `choices`
    bool mouse() const noexcept { return chosen_ == 0; }
    const Choice& choice() const noexcept { return choices_[chosen_]; }
    const QString& chosenName() const noexcept { return choices_[chosen_].name; }
    void choose(std::size_t index); ///< none of `choices`: nothing happens
    /// Chooses a device as soon as it is there, unless the user chose one meanwhile.
    void prefer(std::string id, std::string mode);

    /// Connects the chosen device, in the background. @param then null if that failed, which is told; not called any
    /// more once another is asked for. A stylus must not outlive this.
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
    std::shared_ptr<DeviceRegistry> registry_;
    std::unique_ptr<DeviceWatch> watch_; // last: it uses the registry, and calls this
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/stylus_controller.h"

#include "core/device/axis_map_json.h"
#include "core/device/stylus_handle.h"
#include "ui/messages/messages.h"

#include <QMetaObject>

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// A device with several modes gives one choice for each.
std::vector<StylusController::Choice> choicesOf(const FoundDevice& device) {
    const QString name = QString::fromStdString(device.name);
    if (device.modes.empty()) return {{device.id, {}, name}};
    std::vector<StylusController::Choice> choices;
    for (const DeviceMode& mode : device.modes)
        choices.push_back({device.id, mode.id, name + QStringLiteral(": ") + Messages::text(mode.name)});
    return choices;
}

} // namespace

StylusController::StylusController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    choices_.push_back({{}, {}, tr("Mouse")});
}

StylusController::~StylusController() = default;

void StylusController::start(std::shared_ptr<DeviceRegistry> registry) {
    watch_.reset();
    registry_ = registry ? std::move(registry) : std::make_shared<DeviceRegistry>();
    for (const Error& fault : registry_->takeFaults()) emit failed(fault);
    watch_ = std::make_unique<DeviceWatch>(*registry_, [this](const DeviceChange& change) {
        QMetaObject::invokeMethod(
            this, [this, change] { hear(change); }, Qt::QueuedConnection);
    });
}

void StylusController::hear(const DeviceChange& change) {
    const Choice before = choices_[chosen_];
    const auto isDevice = [&](const Choice& choice) { return choice.id == change.device.id; };
    if (change.arrived) {
        std::erase_if(choices_, isDevice);
        for (Choice& choice : choicesOf(change.device)) choices_.push_back(std::move(choice));
    } else {
        const auto isChosen = [&](const Choice& choice) {
            return choice.id == before.id && choice.mode == before.mode;
        };
        std::erase_if(choices_, [&](const Choice& choice) { return isDevice(choice) && !isChosen(choice); });
        for (Choice& choice : choices_)
            if (isDevice(choice)) choice.there = false;
    }
    select(before);
    choosePreferred();
    emit changed();
}

void StylusController::prefer(std::string id, std::string mode) {
    preferredId_ = std::move(id);
    preferredMode_ = std::move(mode);
}

void StylusController::choosePreferred() {
    if (preferredId_.empty() || !mouse()) return;
    const auto wanted = std::ranges::find_if(choices_, [this](const Choice& choice) {
        return choice.id == preferredId_ && choice.mode == preferredMode_ && choice.there;
    });
    if (wanted == choices_.end()) return;
    preferredId_.clear();
    chosen_ = static_cast<std::size_t>(wanted - choices_.begin());
}

void StylusController::choose(std::size_t index) {
    if (index >= choices_.size() || index == chosen_) return;
    const Choice wanted = choices_[index];
    // Disconnected devices are removed once another one is chosen.
    std::erase_if(choices_, [&](const Choice& choice) { return !choice.there && choice.id != wanted.id; });
    select(wanted);
    preferredId_.clear();
    emit changed();
    emit choiceMade();
}

/// Selects the same choice at its present index; the mouse if it is gone.
void StylusController::select(const Choice& wanted) {
    const auto same = std::ranges::find_if(
        choices_, [&](const Choice& choice) { return choice.id == wanted.id && choice.mode == wanted.mode; });
    chosen_ = same == choices_.end() ? 0 : static_cast<std::size_t>(same - choices_.begin());
}

Result<AnyStylus> StylusController::make(const std::shared_ptr<DeviceRegistry>& registry, const std::string& id,
                                         const std::string& mode, const std::string& axisMap) {
    if (!registry) return Error{ErrorCode::deviceNotFound, id, {}, {}};
    Result<AnyStylus> stylus = registry->make(id, mode);
    if (!stylus) return stylus;
    if (Result<void> assigned = assignKept(StylusHandle(*stylus).device(), axisMap); !assigned)
        return std::move(assigned).error();
    return stylus;
}

void StylusController::connectDevice(std::function<void(std::unique_ptr<AnyStylus>)> then) {
    const Choice wanted = choices_[chosen_];
    using Made = Result<std::shared_ptr<AnyStylus>>; // the result of a task must be copyable
    desk_.tasks.start(
        TaskKind::device, tr("Connecting %1").arg(wanted.name),
        [registry = registry_, wanted, map = axisMap(wanted.id)](Progress&) -> Made {
            Result<AnyStylus> stylus = make(registry, wanted.id, wanted.mode, map);
            if (!stylus) return std::move(stylus).error();
            return std::make_shared<AnyStylus>(std::move(*stylus));
        },
        [this, then = std::move(then)](Made made) {
            if (!made) emit failed(made.error());
            then(made ? std::make_unique<AnyStylus>(std::move(**made)) : nullptr);
        });
}

} // namespace burin

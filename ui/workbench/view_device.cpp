// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/view_device.h"

#include "core/device/axis_map_json.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <utility>
#include <variant>

namespace burin {

namespace {

constexpr int pictureInterval = 16;           // ms
constexpr const char* springing = "position"; // the mode of all drivers of spring-centred devices
// Full deflection in that mode.
constexpr double fullPush = 40.0;   // mm
constexpr double fullTurn = 0.5;    // rad
constexpr double atRest = 0.01;     // share
constexpr double longestStep = 0.1; // s: after a late frame the view does not jump

} // namespace

ViewDevice::ViewDevice(const Desk& desk, StylusController& styluses, SessionRunner& session, QObject* parent)
    : Controller(desk, parent), styluses_(styluses), session_(session) {
    timer_.setInterval(pictureInterval);
    connect(&timer_, &QTimer::timeout, this, &ViewDevice::read);
    connect(&styluses_, &StylusController::changed, this, &ViewDevice::follow);
    connect(&session_, &SessionRunner::changed, this, &ViewDevice::follow);
}

ViewDevice::~ViewDevice() {
    close(); // without signals: receivers may be partly destroyed
}

void ViewDevice::choose(const std::string& id) {
    if (id == id_) return;
    id_ = id;
    refused_ = false;
    release();
    follow();
    emit changed();
}

void ViewDevice::assignAxes(const std::string& id) {
    if (stylus_ == nullptr || id != id_) return;
    if (const Result<void> assigned = assignKept(*stylus_, styluses_.axisMap(id)); !assigned)
        emit failed(assigned.error());
}

bool ViewDevice::suits(const std::string& id) const {
    return std::ranges::any_of(styluses_.choices(), [&](const StylusController::Choice& choice) {
        return choice.id == id && choice.mode == springing;
    });
}

bool ViewDevice::connected() const {
    return stylus_ != nullptr && stylus_->health().connected;
}

void ViewDevice::follow() {
    const bool movesTheTool = session_.running() && styluses_.choice().id == id_;
    if (id_.empty() || movesTheTool) return release();
    const bool there = std::ranges::any_of(styluses_.choices(), [this](const StylusController::Choice& choice) {
        return choice.id == id_ && choice.mode == springing && choice.there;
    });
    if (!there) refused_ = false; // a different device may be connected next
    if (there && stylus_ == nullptr && !refused_) connectDevice();
}

void ViewDevice::connectDevice() {
    if (std::exchange(connecting_, true)) return;
    using Made = Result<std::shared_ptr<AnyStylus>>; // the result of a task must be copyable
    desk_.tasks.start(
        TaskKind::viewDevice, tr("Connecting the device that moves the view"),
        [registry = styluses_.registry(), id = id_, map = styluses_.axisMap(id_)](Progress&) -> Made {
            Result<AnyStylus> stylus = StylusController::make(registry, id, springing, map);
            if (!stylus) return std::move(stylus).error();
            return std::make_shared<AnyStylus>(std::move(*stylus));
        },
        [this, id = id_](Made made) {
            connecting_ = false;
            if (id != id_) return follow(); // another one was chosen meanwhile
            if (!made) {
                refused_ = true;
                emit failed(made.error());
                return;
            }
            auto* const stylus = std::get_if<std::unique_ptr<Stylus>>(made->get());
            refused_ = stylus == nullptr; // a stylus that paces itself has motors and is not spring-centred
            if (refused_) return;
            if (const Result<void> opened = (*stylus)->open(); !opened) {
                refused_ = true;
                emit failed(opened.error());
                return;
            }
            registry_ = styluses_.registry();
            stylus_ = std::move(*stylus);
            clock_.start();
            readAt_ = 0.0;
            timer_.start();
            emit changed();
            follow(); // it may have been chosen as the stylus meanwhile
        });
}

void ViewDevice::release() {
    const bool open = stylus_ != nullptr;
    close();
    if (open) emit changed();
}

void ViewDevice::close() {
    timer_.stop();
    if (stylus_ == nullptr) return;
    stylus_->close();
    stylus_.reset();
    registry_.reset();
    buttons_ = 0;
}

void ViewDevice::read() {
    const double now = 1e-9 * static_cast<double>(clock_.nsecsElapsed());
    const double seconds = std::min(longestStep, now - std::exchange(readAt_, now));
    const StylusState state = stylus_->read(now);
    (void)stylus_->takeFault(); // it reconnects by itself, and the list of devices shows that it is away
    const std::uint32_t pressed = state.buttons & ~std::exchange(buttons_, state.buttons);
    if (!state.valid) return;
    if ((pressed & 1U) != 0) emit fitRequested();
    const glm::dquat& rotation = state.pose.rotation;
    const auto unlessAtRest = [](const glm::dvec3& deflection) {
        return glm::length(deflection) < atRest ? glm::dvec3(0.0) : glm::clamp(deflection, -1.0, 1.0);
    };
    const glm::dvec3 push = unlessAtRest(state.pose.position / fullPush),
                     turn = unlessAtRest(glm::axis(rotation) * glm::angle(rotation) / fullTurn);
    if (push != glm::dvec3(0.0) || turn != glm::dvec3(0.0)) emit pushed(push, turn, seconds);
}

} // namespace burin

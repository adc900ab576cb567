// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/hole_presenter.h"

#include "core/base/units.h"
#include "core/cad/part_holes.h"
#include "core/passes/plan_pass.h"
#include "ui/window/hole_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

/// A circle on the mouth of a hole, mm.
std::vector<glm::dvec3> mouthOf(const UprightHole& hole, double height) {
    constexpr int corners = 48;
    std::vector<glm::dvec3> circle;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2.0 * pi * i / corners;
        circle.emplace_back(hole.centre + hole.radius * glm::dvec2(std::cos(angle), std::sin(angle)), height);
    }
    return circle;
}

} // namespace

HolePresenter::HolePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.workpiece, &workbench.tool}, parent), viewport_(viewport) {
    connect(&picker_, &HolePicker::chosen, this, &HolePresenter::toggle);
    connect(&picker_, &HolePicker::missed, this, [this] {
        emit told(studs_ ? tr("There is no round upright hole or stud here. Click the wall of a hole, inside "
                              "it, or a stud.")
                         : tr("There is no round upright hole here. Click the wall of a hole, or inside it."));
    });
    connect(&picker_, &HolePicker::finished, this, [this] {
        const RequestedPass wanted = *wanted_;
        leave();
        // The dialog must not open within the key's event.
        QTimer::singleShot(0, this, [this, wanted] { emit picked(wanted); });
    });
    connect(&viewport, &Viewport::interactiveToolChanged, this, [this] {
        const bool picker = viewport_.interactiveTool() == &picker_;
        if (wanted_ && !picker)
            leave();                 // another tool took the pointer
        else if (!wanted_ && picker) // that tool gave the pointer back, but picking has ended
            viewport_.setInteractiveTool(std::exchange(before_, nullptr));
    });
}

void HolePresenter::pick(const RequestedPass& wanted) {
    if (wanted_ || !workbench_.passes.possible()) return;
    emit pickBegins();
    milling_ = workbench_.workpiece.milling();
    std::vector<UprightHole> walls = uprightHoles(*milling_->partModel);
    studs_ = mayPlan(PassKind::thread, milling_->tool);
    if (studs_)
        for (const UprightHole& stud : uprightStuds(*milling_->partModel)) walls.push_back(stud);
    picker_.setPart(milling_->partModel, std::move(walls));
    before_ = workbench_.mill.stylus() == nullptr ? viewport_.interactiveTool() : nullptr; // that of mill mode ends
    wanted_ = wanted;
    viewport_.setInteractiveTool(&picker_);
    viewport_.setPartSeen(true);
    viewport_.setFocus(); // so that the picker receives Esc
    mark({});
    emit told(studs_
                  ? tr("Click the holes or the studs of the pass; a second click removes one. Enter or Esc goes back "
                       "to the pass.")
                  : tr("Click the holes of the pass; a second click removes a hole. Enter or Esc goes back to the "
                       "pass."));
}

void HolePresenter::setShown(JobStep step) {
    if (wanted_ && step != JobStep::path) leave();
}

void HolePresenter::toggle(std::size_t index) {
    const UprightHole& chosen = picker_.holes()[index];
    PassRequest& request = wanted_->request;
    std::vector<glm::dvec2>& places = request.places;
    if (request.external != chosen.stud) places.clear(); // a thread is internal or external
    request.external = chosen.stud;
    const std::vector<UprightHole> holes = offered();
    const auto isIt = [&](const glm::dvec2& place) {
        const UprightHole* around = holeAround(holes, place);
        return around != nullptr && around->centre == chosen.centre && around->radius == chosen.radius;
    };
    const bool wasPicked = std::erase_if(places, isIt) > 0;
    if (!wasPicked) places.push_back(chosen.centre);
    mark(index);
    const auto count = static_cast<int>(places.size());
    const QString what =
        (wasPicked ? tr("Removed: %1.") : tr("Picked: %1.")).arg(pickedText(chosen.centre, holes, unit()));
    const QString all = chosen.stud  ? count == 1 ? tr("1 stud is picked.") : tr("%n studs are picked.", nullptr, count)
                         : count == 1 ? tr("1 hole is picked.")
                                     : tr("%n holes are picked.", nullptr, count);
    emit told(what + QLatin1Char(' ') + all);
}

std::vector<UprightHole> HolePresenter::offered() const {
    return sideOf(picker_.holes(), wanted_->request.external);
}

void HolePresenter::leave() {
    wanted_.reset();
    milling_.reset();
    picker_.setPart(nullptr, {});
    if (viewport_.interactiveTool() == &picker_) viewport_.setInteractiveTool(std::exchange(before_, nullptr));
    viewport_.setPartSeen(false);
    emit marked({});
}

void HolePresenter::present() {
    if (wanted_ && workbench_.workpiece.milling() != milling_) leave();
}

/// Marks the picked holes or studs; the text is that of the newest.
void HolePresenter::mark(const std::optional<std::size_t>& newest) {
    const std::vector<UprightHole> holes = offered();
    MeasureMark mark;
    for (const glm::dvec2& place : wanted_->request.places) {
        const UprightHole* hole = holeAround(holes, place);
        if (hole == nullptr) continue;
        mark.lines.push_back(mouthOf(*hole, hole->top));
        mark.lines.push_back(mouthOf(*hole, hole->bottom));
        mark.place = {hole->centre, hole->top};
        if (newest && hole->centre == picker_.holes()[*newest].centre) mark.text = holeText(*hole, unit());
    }
    emit marked(mark.lines.empty() ? std::nullopt : std::optional(std::move(mark)));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/area_presenter.h"

#include "core/cad/face_area.h"
#include "ui/window/draped_area.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double turnedStep = 1.1; // factor of the brush per notch of the wheel

} // namespace

AreaPresenter::AreaPresenter(Workbench& workbench, Viewport& viewport, AreaCard& card, QObject* parent)
    : Presenter(workbench, {&workbench.area, &workbench.workpiece, &workbench.path}, parent)
    , viewport_(viewport)
    , card_(card) {
    connect(&card, &AreaCard::paintingRequested, this, &AreaPresenter::paint);
    connect(&card, &AreaCard::cleared, &workbench.area, &AreaController::clear);
    connect(&card, &AreaCard::brushChosen, this, [this](double diameter) {
        brush_ = diameter;
        painter_.setBrush(brush_);
        presentSoon();
    });
    connect(&painter_, &AreaPainter::painting, this, &AreaPresenter::showUnderWay);
    connect(&painter_, &AreaPainter::painted, this, [this](const PlanRegion& region, bool erase) {
        erase ? workbench_.area.erase(region) : workbench_.area.add(region);
    });
    connect(&painter_, &AreaPainter::faceChosen, this, &AreaPresenter::takeFace);
    connect(&painter_, &AreaPainter::brushTurned, this, &AreaPresenter::turnBrush);
    connect(&painter_, &AreaPainter::hovered, this, [this](const std::optional<glm::dvec3>& place) {
        if (painting_ == AreaShape::brush)
            showUnderWay(place ? brushed({glm::dvec2(*place)}, 0.5 * brush_) : PlanRegion{});
    });
    connect(&painter_, &AreaPainter::givenUp, this, [this] { viewport_.setArea(lines_); });
    connect(&painter_, &AreaPainter::cancelled, this, [this] { paint(AreaShape::brush, false); });
    connect(&painter_, &AreaPainter::stateChanged, this, &AreaPresenter::escapeChanged);
    connect(&viewport, &Viewport::interactiveToolChanged, this, [this] {
        if (painting_ && viewport_.interactiveTool() != &painter_) { // another tool took the pointer
            painting_.reset();
            viewport_.setPartSeen(false);
            presentSoon();
        }
    });
    painter_.setBrush(brush_);
}

void AreaPresenter::setUnit(LengthUnit unit) {
    card_.setUnit(unit);
    Presenter::setUnit(unit);
}

void AreaPresenter::connectActions(const Actions& actions) {
    const auto on = [this, &actions](ActionId id, AreaShape shape) {
        connect(actions[id], &QAction::triggered, this, [this, shape] { toggle(shape); });
    };
    on(ActionId::brushArea, AreaShape::brush);
    on(ActionId::lassoArea, AreaShape::lasso);
    on(ActionId::faceArea, AreaShape::face);
    connect(actions[ActionId::clearArea], &QAction::triggered, &workbench_.area, &AreaController::clear);
}

void AreaPresenter::setShown(JobStep step) {
    shown_ = step == JobStep::path;
    if (!shown_) paint(AreaShape::brush, false);
    presentSoon();
}

void AreaPresenter::paint(AreaShape shape, bool wanted) {
    followPart();
    if (wanted && !milling_) return;
    const bool was = painting_.has_value();
    if (wanted) {
        emit paintingBegins();
        painter_.setShape(shape);
        if (!was) before_ = viewport_.interactiveTool();
        painting_ = shape;
        viewport_.setInteractiveTool(&painter_);
        viewport_.setFocus(); // so that the painter receives Esc, wherever painting was started
    } else if (was) {
        painting_.reset();
        if (viewport_.interactiveTool() == &painter_) viewport_.setInteractiveTool(std::exchange(before_, nullptr));
        viewport_.setArea(lines_);
    }
    if (wanted != was) viewport_.setPartSeen(wanted);
    presentSoon();
}

void AreaPresenter::takeFace(const glm::dvec3& place, bool erase) {
    const Result<PlanRegion> face = faceArea(*milling_->partModel, place);
    if (!face)
        emit refused(face.error());
    else if (erase)
        workbench_.area.erase(*face);
    else
        workbench_.area.add(*face);
}

void AreaPresenter::turnBrush(double notches) {
    brush_ = std::clamp(brush_ * std::pow(turnedStep, notches), thinnestBrush, widestBrush);
    painter_.setBrush(brush_);
    presentSoon();
}

/// The area is painted on the part of the workpiece.
void AreaPresenter::followPart() {
    std::shared_ptr<const MillingContext> milling = workbench_.workpiece.milling();
    if (milling && milling->part.bounds().empty()) milling = nullptr;
    if (milling == milling_) return;
    milling_ = std::move(milling);
    if (!milling_) {
        painter_.setPart({}, 0.0);
        return;
    }
    painter_.setPart(
        [part = milling_](const Sight& sight) -> std::optional<glm::dvec3> {
            const Ray ray{sight.seenOrigin(), sight.direction};
            const std::optional<TriangleHit> hit = part->part.hit(ray);
            return hit ? std::optional(ray.origin + hit->distance * ray.direction) : std::nullopt;
        },
        milling_->part.bounds().high.z);
    drawn_ = {}; // the lines were made for another part
    lines_.clear();
}

void AreaPresenter::present() {
    followPart();
    if (painting_ && !milling_) paint(AreaShape::brush, false);
    AreaState state;
    state.area = areaInPlan(workbench_.area.area());
    state.painting = painting_;
    state.brush = brush_;
    state.possible = milling_ != nullptr;
    card_.setState(state);
    showArea();
}

void AreaPresenter::showArea() {
    const PlanRegion& area = workbench_.area.area();
    if (!(area == drawn_)) {
        lines_ = milling_ ? drapedArea(area, milling_->part) : PlaceChains{};
        drawn_ = area;
    }
    viewport_.setArea(shown_ ? lines_ : PlaceChains{});
}

void AreaPresenter::showUnderWay(const PlanRegion& region) {
    if (!milling_) return;
    PlaceChains lines = lines_;
    for (std::vector<glm::dvec3>& line : drapedOutlines(region, milling_->part)) lines.push_back(std::move(line));
    viewport_.setArea(lines);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/view_options.h"

#include "ui/scene/section_side.h"

#include <algorithm>

namespace burin {

namespace {

constexpr int firstTransparency = 60; // %: until the user chooses another

} // namespace

ViewOptions::ViewOptions(Viewport& viewport, ViewBar& bar, const Actions& actions, UserSettings& settings,
                         QObject* parent)
    : QObject(parent)
    , viewport_(viewport)
    , bar_(bar)
    , actions_(actions)
    , settings_(settings)
    , usualTransparency_(firstTransparency) {
    QAction* parallel = actions[ActionId::parallelView];
    parallel->setChecked(settings.parallelView());
    viewport.setParallel(parallel->isChecked());
    connect(parallel, &QAction::toggled, this, [this](bool wanted) {
        viewport_.setParallel(wanted);
        settings_.setParallelView(wanted);
    });
    QAction* handles = actions[ActionId::placementHandles];
    handles->setChecked(settings.placementHandles());
    connect(handles, &QAction::toggled, this, [this](bool shown) { settings_.setPlacementHandles(shown); });
    setTransparency(settings.transparency());
    connect(&bar, &ViewBar::transparencyChosen, this, &ViewOptions::setTransparency);
    connect(actions[ActionId::seeThrough], &QAction::triggered, this,
            [this](bool wanted) { setTransparency(wanted ? usualTransparency_ : 0); });
    connect(actions[ActionId::sectionPlane], &QAction::toggled, this, &ViewOptions::openSection);
    connect(actions[ActionId::flipSection], &QAction::triggered, this, [this] {
        if (!section_) return;
        section_->keepsLow = !section_->keepsLow;
        showSection();
    });
    connect(&bar, &ViewBar::axisChosen, this, &ViewOptions::chooseAxis);
    connect(&bar, &ViewBar::positionChosen, this, &ViewOptions::moveSection);
    connect(&viewport, &Viewport::sectionDragged, this, &ViewOptions::moveSection);
    showSection();
}

void ViewOptions::setTransparency(int percent) {
    transparency_ = std::clamp(percent, 0, ViewBar::mostTransparent);
    if (transparency_ > 0) usualTransparency_ = transparency_;
    viewport_.setWorkpieceOpacity(1.0 - transparency_ / 100.0);
    bar_.showTransparency(transparency_);
    actions_[ActionId::seeThrough]->setChecked(transparency_ > 0);
    settings_.setTransparency(transparency_);
}

void ViewOptions::openSection(bool open) {
    if (open)
        chooseAxis(1); // removes the front, which faces a view from the corner
    else
        section_.reset();
    showSection();
}

/// Puts the section through the middle; the half nearer to the eye is removed.
void ViewOptions::chooseAxis(int axis) {
    const Box content = viewport_.contentBox();
    const glm::dvec3 along = viewport_.sight(QRectF(viewport_.rect()).center()).rayDirection;
    section_ = SectionPlane{axis, content.empty() ? 0.0 : content.centre()[axis], keepsLowBefore(along, axis)};
    showSection();
}

void ViewOptions::moveSection(double position) {
    if (!section_) return;
    section_->position = position;
    showSection();
}

void ViewOptions::showSection() {
    viewport_.setSection(section_);
    std::optional<ViewBar::Section> shown;
    const Box content = viewport_.contentBox();
    if (section_)
        shown = {section_->axis, section_->position, content.low[section_->axis], content.high[section_->axis]};
    bar_.showSection(shown);
    actions_[ActionId::flipSection]->setEnabled(section_.has_value());
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/selection_card.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/hand_times.h"
#include "ui/panels/length_field.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace burin {

SelectionCard::SelectionCard(QWidget* parent)
    : QFrame(parent)
    , chosen_(new ElidedLabel({}, this))
    , shown_(new ElidedLabel({}, this))
    , clear_(makeIconButton(QStringLiteral("cancel"), tr("Clear the selection (Esc in the view)"),
                            QStringLiteral("clearSelectionButton"), this))
    , drag_(new ChoiceBox(this))
    , draw_(makeButton(tr("Draw instead"), QStringLiteral("path"), QStringLiteral("drawStretchButton"), this))
    , stylus_(makeButton(tr("Edit with the stylus"), QStringLiteral("edit"), QStringLiteral("stylusEditButton"), this))
    , reach_(new LengthField(this))
    , stylusText_(new ElidedLabel({}, this)) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    chosen_->setObjectName(QStringLiteral("pathSelection"));
    chosen_->setToolTip(
        tr("Click a point of the path in the view to select it; Shift+click selects everything up to it"));
    auto* head = new QHBoxLayout;
    head->addWidget(chosen_, 1);
    head->addWidget(clear_);
    column->addLayout(head);
    shown_->setObjectName(QStringLiteral("pathAtTime"));
    shown_->setVisible(false);
    column->addWidget(shown_);
    drag_->setObjectName(QStringLiteral("dragChoice"));
    drag_->addItems({tr("on its level"), QStringLiteral("X"), QStringLiteral("Y"), tr("Z, the tool's axis"),
                     tr("the part's surface")});
    column->addWidget(new FieldRow(tr("Drag along"), drag_, tr("How a dragged point of the path moves"), this,
                                   FieldRow::choiceWidth));
    draw_->setCheckable(true);
    draw_->setProperty("look", "choice");
    column->addWidget(draw_);
    addStylus(*column);
    connect(drag_, &QComboBox::activated, this, [this](int index) { emit dragChosen(static_cast<DragChoice>(index)); });
    connect(draw_, &QPushButton::clicked, this, &SelectionCard::drawingRequested);
    connect(clear_, &QToolButton::clicked, this, &SelectionCard::cleared);
}

void SelectionCard::addStylus(QVBoxLayout& column) {
    stylus_->setCheckable(true);
    stylus_->setProperty("look", "choice");
    column.addWidget(stylus_);
    reach_->setObjectName(QStringLiteral("stylusReach"));
    reachRow_ = new FieldRow(
        tr("Reach"), reach_,
        tr("Distance from the tool's tip within which a device takes the nearest point of the path"), this);
    column.addWidget(reachRow_);
    stylusText_->setObjectName(QStringLiteral("stylusEditText"));
    column.addWidget(stylusText_);
    reachRow_->hide();
    stylusText_->hide();
    connect(stylus_, &QPushButton::clicked, this, &SelectionCard::stylusRequested);
    connect(reach_, &LengthField::valueEdited, this, &SelectionCard::stylusReachEdited);
    setStylus({}, LengthUnit::millimetre);
}

void SelectionCard::setStylus(const StylusEditState& state, LengthUnit unit) {
    stylus_->setChecked(state.active);
    enableUnless(stylus_, state.missing,
                 tr("Move points of the path with the chosen stylus, and feel part and fixtures meanwhile"));
    reach_->setLengthUnit(unit);
    reach_->limit(state.leastReach, state.mostReach);
    reach_->showValue(state.reach);
    reachRow_->setVisible(state.active && state.device);
    stylusText_->setText(state.text);
    stylusText_->setVisible(state.active);
}

void SelectionCard::showTimelinesPlace(const PathState& state, LengthUnit unit) {
    shown_->setVisible(state.atTime.moment.has_value());
    if (!state.atTime.moment) return;
    const QString time = momentText(state.takes, *state.atTime.moment);
    if (!state.atTime.place) {
        shown_->setText(tr("Timeline: not in this path"));
        shown_->setToolTip(tr("The path has no point that was milled at %1").arg(time));
        return;
    }
    const glm::dvec3 place = *state.atTime.place - state.zero;
    shown_->setText(tr("Timeline: X %1, Y %2, Z %3")
                        .arg(lengthNumber(place.x, unit), lengthNumber(place.y, unit), lengthText(place.z, unit)));
    shown_->setToolTip(tr("Point of the path at the time on the timeline, from program zero: %1").arg(time));
}

void SelectionCard::setState(const PathState& state, LengthUnit unit) {
    showTimelinesPlace(state, unit);
    QString chosen = state.selection ? tr("Selected: %1").arg(intervalText(state.takes, *state.selection))
                                     : tr("No part of the path is selected");
    if (state.selectedSide == MillingSide::climb) chosen += QStringLiteral(" · ") + tr("climb");
    if (state.selectedSide == MillingSide::conventional) chosen += QStringLiteral(" · ") + tr("conventional");
    if (state.drawing) chosen = tr("Draw it in the view; Esc cancels");
    chosen_->setText(chosen);
    setEnabledKeepingFocus(clear_, state.selection.has_value());
    drag_->setCurrentIndex(static_cast<int>(state.drag));
    draw_->setChecked(state.drawing);
    enableUnless(draw_, state.selection ? QString() : tr("Select part of the path in the view first."),
                 tr("Draw a stroke in the view that replaces the selected part of the path, at its height"));
}

} // namespace burin

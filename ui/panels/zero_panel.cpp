// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/zero_panel.h"

#include "core/nc/work_offset.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/zero_labels.h"

#include <array>

namespace burin {

namespace {

constexpr double farthestZero = 1e6; // mm
constexpr std::array offered{54, 55, 56, 57, 58, 59, 591, 592, 593};
constexpr std::array axisNames{"X", "Y", "Z"};

} // namespace

class ZeroPanel::Fields : public QObject {
public:
    explicit Fields(ZeroPanel* panel);
    void refresh();
    void setUnit(LengthUnit unit);

    ZeroState state;

private:
    void makeChoices();
    void makePlace(std::size_t axis);
    void makePicking();
    /// Stores the choice at once, since the next one builds on it and the state arrives a moment later.
    void tell(const ProgramZero& zero) {
        state.zero = zero;
        emit panel_->zeroChosen(zero);
    }

    ZeroPanel* panel_;
    QVBoxLayout* column_;
    ChoiceBox *offset_ = nullptr, *on_ = nullptr;
    std::array<ChoiceBox*, 3> sides_{};
    std::array<LengthField*, 3> places_{};
    QPushButton* pick_ = nullptr;
    Notice* asked_ = nullptr;
};

ZeroPanel::Fields::Fields(ZeroPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(ZeroPanel::tr("Program zero"), panel));
    makeChoices();
    for (std::size_t axis = 0; axis < places_.size(); ++axis) makePlace(axis);
    makePicking();
}

void ZeroPanel::Fields::makeChoices() {
    offset_ = new ChoiceBox(panel_);
    offset_->setObjectName(QStringLiteral("workOffset"));
    column_->addWidget(new FieldRow(
        ZeroPanel::tr("Work offset"), offset_,
        ZeroPanel::tr("The control stores program zero in this work offset; the program calls it"), panel_));
    connect(offset_, &QComboBox::activated, this, [this] {
        const auto number = workOffsetFromName(offset_->currentText().toStdString());
        ProgramZero zero = state.zero;
        zero.workOffset = number.value_or(zero.workOffset);
        tell(zero);
    });
    on_ = new ChoiceBox(panel_);
    on_->setObjectName(QStringLiteral("zeroReference"));
    on_->addItems({ZeroPanel::tr("stock"), ZeroPanel::tr("part"), ZeroPanel::tr("coordinates")});
    column_->addWidget(
        new FieldRow(ZeroPanel::tr("Zero on"), on_,
                     ZeroPanel::tr("A point of the bounding box of the stock or the part, or coordinates"), panel_));
    connect(on_, &QComboBox::activated, this, [this](int index) {
        ProgramZero zero = state.zero;
        zero.on = zeroReferences[static_cast<std::size_t>(index)];
        if (zero.on == ZeroReference::point) zero.point = state.place; // its position is kept
        tell(zero);
    });
}

void ZeroPanel::Fields::makePlace(std::size_t axis) {
    const QString name = QString::fromLatin1(axisNames[axis]);
    sides_[axis] = new ChoiceBox(panel_);
    sides_[axis]->setObjectName(QStringLiteral("zeroSide%1").arg(name));
    for (const QString& side : sideTexts(axis)) sides_[axis]->addItem(side);
    column_->addWidget(
        new FieldRow(name, sides_[axis], ZeroPanel::tr("Position on the bounding box along %1").arg(name), panel_));
    connect(sides_[axis], &QComboBox::activated, this, [this, axis](int index) {
        ProgramZero zero = state.zero;
        zero.sides[axis] = boxSides[static_cast<std::size_t>(index)];
        tell(zero);
    });
    places_[axis] = new LengthField(panel_);
    places_[axis]->setObjectName(QStringLiteral("zero%1").arg(name));
    places_[axis]->limit(-farthestZero, farthestZero);
    column_->addWidget(
        new FieldRow(name, places_[axis], ZeroPanel::tr("Program zero in the frame of the setup"), panel_));
    connect(places_[axis], &QuantityField::valueEdited, this, [this, axis](double place) {
        ProgramZero zero = state.zero;
        zero.point[static_cast<int>(axis)] = place;
        tell(zero);
    });
}

void ZeroPanel::Fields::makePicking() {
    pick_ = makeChoiceButton(ZeroPanel::tr("Pick in the view"), {}, QStringLiteral("pickZeroButton"), panel_);
    column_->addWidget(pick_);
    connect(pick_, &QPushButton::clicked, panel_, &ZeroPanel::pickRequested);
    asked_ = new Notice(panel_);
    asked_->setObjectName(QStringLiteral("zeroPickNotice"));
    column_->addWidget(asked_);
}

void ZeroPanel::Fields::refresh() {
    panel_->setVisible(state.hasPart);
    QStringList names;
    for (const int number : offered) names.append(QString::fromStdString(workOffsetName(number)));
    const QString own = QString::fromStdString(workOffsetName(state.zero.workOffset));
    if (!names.contains(own)) names.append(own); // another work offset, set on the command line
    offset_->offer(names, names, own);
    on_->setCurrentIndex(static_cast<int>(state.zero.on));
    const bool stated = state.zero.on == ZeroReference::point;
    for (std::size_t axis = 0; axis < places_.size(); ++axis) {
        sides_[axis]->setCurrentIndex(static_cast<int>(state.zero.sides[axis]));
        sides_[axis]->parentWidget()->setVisible(!stated);
        places_[axis]->showValue(state.place[static_cast<int>(axis)]);
        places_[axis]->parentWidget()->setVisible(stated);
    }
    pick_->setChecked(state.picking);
    enableUnless(pick_, {},
                 ZeroPanel::tr("Click a vertex, the middle of an edge or a circle of the part, or a corner of the "
                               "stock: program zero is placed there"));
    asked_->tell(Notice::Kind::information,
                 state.picking ? ZeroPanel::tr("Click a vertex, an edge or a circle of the part, or a corner of the "
                                               "stock.")
                               : QString());
}

void ZeroPanel::Fields::setUnit(LengthUnit unit) {
    for (LengthField* field : places_) field->setLengthUnit(unit);
}

ZeroPanel::ZeroPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("zeroPanel"));
    fields_->refresh();
}

void ZeroPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void ZeroPanel::setState(const ZeroState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

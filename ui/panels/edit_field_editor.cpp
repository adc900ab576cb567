// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_field_editor.h"
#include "ui/messages/messages.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/field_row.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace burin {

EditFieldEditor::EditFieldEditor(const EditParameter& parameter, const QString& name, const QString& accessible,
                                 QWidget* parent)
    : QWidget(parent), choices_(parameter.field.choices), value_(parameter.field.value) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    if (std::holds_alternative<double>(value_))
        addNumber(parameter, name, accessible);
    else if (std::holds_alternative<bool>(value_))
        addSwitch(parameter, name);
    else if (std::holds_alternative<std::string_view>(value_))
        addChoice(parameter, name);
    else if (std::holds_alternative<glm::dvec3>(value_))
        addPlace(parameter, name, accessible);
    else if (std::holds_alternative<std::vector<glm::dvec3>>(value_))
        addPlaces(parameter, name, accessible);
    else
        addText(parameter, name);
    showParameter(parameter);
}

void EditFieldEditor::addNumber(const EditParameter& parameter, const QString& name, const QString& accessible) {
    number_ = new QuantityField(parameter.quantity, this);
    number_->setObjectName(name);
    layout()->addWidget(new FieldRow(parameter.label,
                                     parameter.drawn ? besideDrawing(number_, name, accessible) : number_,
                                     parameter.toolTip, this));
    number_->setAccessibleName(accessible);
    connect(number_, &QuantityField::valueEdited, this,
            [this](double value) { emit edited(value_ = value + zero_.x); });
}

void EditFieldEditor::addSwitch(const EditParameter& parameter, const QString& name) {
    switch_ = new QCheckBox(parameter.label, this);
    switch_->setObjectName(name);
    switch_->setToolTip(parameter.toolTip);
    layout()->addWidget(switch_);
    connect(switch_, &QCheckBox::clicked, this, [this](bool on) { emit edited(value_ = on); });
}

void EditFieldEditor::addChoice(const EditParameter& parameter, const QString& name) {
    choice_ = new ChoiceBox(this);
    choice_->setObjectName(name);
    for (const EditChoice& choice : choices_) choice_->addItem(Messages::text(choice.words));
    layout()->addWidget(new FieldRow(parameter.label, choice_, parameter.toolTip, this, FieldRow::choiceWidth));
    connect(choice_, &QComboBox::activated, this,
            [this](int index) { emit edited(value_ = choices_[static_cast<std::size_t>(index)].name); });
}

void EditFieldEditor::addPlace(const EditParameter& parameter, const QString& name, const QString& accessible) {
    for (int axis = 0; axis < 3; ++axis) {
        QuantityField*& field = place_[static_cast<std::size_t>(axis)];
        field = new LengthField(this);
        field->setObjectName(name + axisLetter(axis));
        layout()->addWidget(
            new FieldRow(parameter.label + QLatin1Char(' ') + axisLetter(axis), field, parameter.toolTip, this));
        field->setAccessibleName(accessible + QLatin1Char(' ') + axisLetter(axis));
        connect(field, &QuantityField::valueEdited, this, [this, axis](double value) {
            glm::dvec3 place = std::get<glm::dvec3>(value_);
            place[axis] = value + zero_[axis];
            emit edited(value_ = place);
        });
    }
}

void EditFieldEditor::addText(const EditParameter& parameter, const QString& name) {
    text_ = new ElidedLabel({}, this);
    text_->setObjectName(name);
    text_->setProperty("look", "small");
    layout()->addWidget(new FieldRow(parameter.label, text_, parameter.toolTip, this));
}

void EditFieldEditor::addPlaces(const EditParameter& parameter, const QString& name, const QString& accessible) {
    text_ = new ElidedLabel({}, this);
    text_->setObjectName(name);
    text_->setProperty("look", "small");
    layout()->addWidget(new FieldRow(parameter.label, besideDrawing(text_, name, accessible), parameter.toolTip, this));
}

/// A value with the button that starts drawing it.
QWidget* EditFieldEditor::besideDrawing(QWidget* value, const QString& name, const QString& accessible) {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    draw_ = makeIconButton(QStringLiteral("path"), tr("Draw it in the view; Esc leaves it as it is"),
                           name + QStringLiteral("_draw"), row);
    draw_->setCheckable(true);
    draw_->setProperty("look", "toggle");
    draw_->setAccessibleName(tr("Draw %1").arg(accessible));
    line->addWidget(value, 1);
    line->addWidget(draw_);
    connect(draw_, &QToolButton::clicked, this, &EditFieldEditor::drawingRequested);
    return row;
}

void EditFieldEditor::setDrawing(bool drawing) {
    if (draw_ != nullptr) draw_->setChecked(drawing); // doesn't emit `clicked`
}

void EditFieldEditor::showParameter(const EditParameter& parameter) {
    zero_ = parameter.zero;
    const double low = parameter.field.low, high = parameter.field.high;
    if (number_ != nullptr) {
        number_->setQuantity(parameter.quantity);
        number_->limit(low - zero_.x, high - zero_.x);
    }
    for (int axis = 0; axis < 3; ++axis)
        if (QuantityField* field = place_[static_cast<std::size_t>(axis)])
            field->limit(low - zero_[axis], high - zero_[axis]);
    showValue(parameter.field.value);
    if (text_ != nullptr) text_->setText(parameter.text);
}

void EditFieldEditor::showValue(const EditValue& value) {
    value_ = value;
    if (number_ != nullptr) number_->showValue(std::get<double>(value) - zero_.x);
    if (switch_ != nullptr) switch_->setChecked(std::get<bool>(value)); // doesn't emit `clicked`
    if (choice_ != nullptr) {
        const auto found = std::ranges::find(choices_, std::get<std::string_view>(value), &EditChoice::name);
        choice_->setCurrentIndex(static_cast<int>(found - choices_.begin()));
    }
    for (int axis = 0; axis < 3; ++axis)
        if (QuantityField* field = place_[static_cast<std::size_t>(axis)])
            field->showValue(std::get<glm::dvec3>(value)[axis] - zero_[axis]);
}

void EditFieldEditor::setUnit(LengthUnit unit) {
    if (number_ != nullptr) number_->setLengthUnit(unit);
    for (QuantityField* field : place_)
        if (field != nullptr) field->setLengthUnit(unit);
}

} // namespace burin

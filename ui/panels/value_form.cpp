// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/value_form.h"

#include "ui/panels/choice_box.h"
#include "ui/panels/panel_layout.h"

#include <QGridLayout>
#include <QLineEdit>

namespace burin {

namespace {

constexpr int numberFieldWidth = 116, sourceFieldWidth = 200, formColumns = 5; // pixels
enum Column { labelColumn, firstField, sourceColumn = 4 };

QString rangeText(Quantity quantity, NumberRange range, bool optional, LengthUnit unit) {
    const QString both = ValueForm::tr("%1 to %2")
                             .arg(quantityText(range.low, quantity, unit), quantityText(range.high, quantity, unit));
    return optional ? ValueForm::tr("%1, or 0: not stated").arg(both) : both;
}

} // namespace

ValueForm::ValueForm(const QString& sourcePlaceholder, QWidget* parent)
    : QWidget(parent), sourcePlaceholder_(sourcePlaceholder), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(16, 8, 16, 16);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(6);
    grid_->setColumnStretch(labelColumn, 1);
    grid_->setColumnStretch(sourceColumn, 1);
}

void ValueForm::closeRows() {
    grid_->setRowStretch(grid_->rowCount(), 1);
    refresh();
}

void ValueForm::placeWide(QWidget* field, int row) {
    grid_->addWidget(field, row, firstField, 1, 3);
}

void ValueForm::placeToEnd(QWidget* field, int row) {
    grid_->addWidget(field, row, firstField, 1, formColumns - 1);
}

void ValueForm::addTitle(const QString& text) {
    const int row = grid_->rowCount();
    grid_->addWidget(makeSectionTitle(text, this), row, labelColumn, 1, formColumns - 1);
    grid_->addWidget(makeSectionTitle(tr("Source"), this), row, sourceColumn);
}

int ValueForm::beginRow(const QString& label, QWidget* buddy, const QString& toolTip) {
    const int row = grid_->rowCount();
    auto* name = new QLabel(label, this);
    name->setProperty("look", "quiet");
    name->setBuddy(buddy);
    name->setToolTip(toolTip);
    buddy->setAccessibleName(label);
    buddy->setToolTip(toolTip);
    grid_->addWidget(name, row, labelColumn);
    fields_.push_back(buddy);
    return row;
}

void ValueForm::addNumberFields(const char* key, const QString& label, const QString& toolTip,
                                std::vector<NumberField> numbers, bool withSource) {
    const std::string name(key);
    int row = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const NumberField& number = numbers[i];
        auto* field = new QuantityField(number.quantity, this);
        field->setObjectName(QString::fromLatin1(key) + (numbers.size() > 1 ? QString::number(i) : QString()));
        field->limit(number.optional ? 0.0 : number.range.low, number.range.high);
        field->setFixedWidth(numberFieldWidth);
        if (i == 0)
            row = beginRow(label, field, toolTip);
        else
            fields_.push_back(field);
        grid_->addWidget(field, row, firstField + static_cast<int>(i));
        numbers_.push_back(field);
        connect(field, &QuantityField::valueEdited, this, [this, name, set = number.set](double value) {
            set(value);
            changed(name.substr(0, name.find('.')));
        });
        refreshers_.emplace_back([this, field, label, toolTip, number] {
            field->showValue(number.get());
            field->setToolTip(toolTip + QStringLiteral(" (") +
                              rangeText(number.quantity, number.range, number.optional, unit_) + QLatin1Char(')'));
            field->setAccessibleName(label);
            if (number.used) field->setReadOnly(locked_ || !number.used());
        });
    }
    if (withSource) addSource(key, label, row);
}

void ValueForm::addChoiceField(const char* key, const QString& label, const QString& toolTip, ChoiceField choice,
                               bool withSource) {
    auto* box = new ChoiceBox(this);
    box->setObjectName(QString::fromLatin1(key));
    box->addItems(choice.texts);
    const int row = beginRow(label, box, toolTip);
    placeWide(box, row);
    connect(box, &QComboBox::activated, this, [this, key = std::string(key), set = choice.set](int index) {
        set(index);
        changed(key);
    });
    refreshers_.emplace_back([box, get = choice.get] { box->setCurrentIndex(get()); });
    if (withSource) addSource(key, label, row);
}

QLineEdit* ValueForm::addTextField(const char* name, const QString& label, const QString& toolTip, TextField text) {
    auto* field = new QLineEdit(this);
    field->setObjectName(QString::fromLatin1(name));
    const int row = beginRow(label, field, toolTip);
    grid_->addWidget(field, row, firstField, 1, formColumns - 1);
    connect(field, &QLineEdit::textEdited, this, [this, set = text.set](const QString& typed) {
        set(typed.trimmed().toStdString());
        emit edited();
    });
    refreshers_.emplace_back([field, toolTip, get = text.get] {
        const QString said = QString::fromStdString(get());
        field->setToolTip(said.isEmpty() ? toolTip : toolTip + QLatin1Char('\n') + said); // it may be a long one
        if (field->text().trimmed() != said) field->setText(said);
        field->setCursorPosition(0);
    });
    return field;
}

/// Adds the field for the source of a key's values.
void ValueForm::addSource(const char* key, const QString& label, int row) {
    auto* field = new QLineEdit(this);
    field->setObjectName(QString::fromLatin1(key) + QStringLiteral("Source"));
    field->setPlaceholderText(sourcePlaceholder_);
    field->setAccessibleName(label + QStringLiteral(", ") + tr("Source"));
    field->setMinimumWidth(sourceFieldWidth);
    field->setProperty("look", "quiet");
    grid_->addWidget(field, row, sourceColumn);
    fields_.push_back(field);
    connect(field, &QLineEdit::textEdited, this, [this, key = std::string(key)](const QString& typed) {
        if (typed.trimmed().isEmpty())
            sources().erase(key);
        else
            sources()[key] = typed.trimmed().toStdString();
        emit edited();
    });
    refreshers_.emplace_back([this, field, key = std::string(key)] {
        const auto found = sources().find(key);
        const QString said = found == sources().end() ? QString() : QString::fromStdString(found->second);
        if (field->text().trimmed() != said) field->setText(said);
        field->setCursorPosition(0);
        field->setToolTip(said.isEmpty() ? tr("Where this value comes from, e.g. the nameplate or a measurement") +
                                               QLatin1Char('\n') + sourcePlaceholder_
                                         : said); // either may be longer than the field
    });
}

/// The user becomes the source of a value that they changed.
void ValueForm::changed(const std::string& key) {
    sources()[key] = tr("entered by the user").toStdString();
    settle(key);
    refresh();
    emit edited();
}

void ValueForm::refresh() {
    for (const auto& show : refreshers_) show();
}

void ValueForm::setUnit(LengthUnit unit) {
    unit_ = unit;
    for (QuantityField* field : numbers_) field->setLengthUnit(unit);
    refresh();
}

void ValueForm::lock(bool locked) {
    locked_ = locked;
    for (QWidget* field : fields_) {
        if (auto* text = qobject_cast<QLineEdit*>(field))
            text->setReadOnly(locked);
        else if (auto* number = qobject_cast<QuantityField*>(field))
            number->setReadOnly(locked);
        else
            field->setEnabled(!locked);
    }
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_card.h"

#include "ui/messages/messages.h"
#include "ui/panels/edit_parameters.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/field_row.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QCheckBox>
#include <QVBoxLayout>

namespace burin {

EditCard::EditCard(std::size_t place, const Edit& edit, QWidget* parent) : QFrame(parent), edit_(edit) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    const QString name = QStringLiteral("edit%1").arg(place);
    const QString title = Messages::text(titleOf(edit.parameters));
    enabled_ = new QCheckBox(title, this);
    enabled_->setObjectName(name + QStringLiteral("Switch"));
    enabled_->setToolTip(tr("Switch this edit on or off"));
    column->addWidget(enabled_);
    connect(enabled_, &QCheckBox::clicked, this, [this](bool on) {
        edit_.enabled = on;
        showEdit(edit_);
        emit edited(edit_);
    });
    for (const EditParameter& parameter : parametersOf(edit.parameters)) {
        auto* field = new QuantityField(parameter.quantity, this);
        field->setObjectName(name + QLatin1Char('_') +
                             QLatin1String(parameter.number.key.data(), qsizetype(parameter.number.key.size())));
        field->limit(parameter.number.low, parameter.number.high);
        column->addWidget(new FieldRow(parameter.label, field, parameter.toolTip, this));
        field->setAccessibleName(title + QStringLiteral(", ") + parameter.label);
        connect(field, &QuantityField::valueEdited, this, [this, key = parameter.number.key](double value) {
            setNumber(edit_.parameters, key, value);
            emit edited(edit_);
        });
        fields_.push_back(field);
    }
    report_ = new ElidedLabel({}, this);
    report_->setObjectName(name + QStringLiteral("Report"));
    report_->setProperty("look", "small");
    report_->setFont(numberFont(report_->font()));
    column->addWidget(report_);
    showEdit(edit);
    showReport(nullptr, LengthUnit::millimetre);
}

void EditCard::showEdit(const Edit& edit) {
    edit_ = edit;
    enabled_->setChecked(edit.enabled); // `clicked` is the user's alone
    const std::vector<EditNumber> numbers = numbersOf(edit.parameters);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        fields_[i]->showValue(numbers[i].value);
        fields_[i]->parentWidget()->setEnabled(edit.enabled);
    }
}

void EditCard::showReport(const EditReport* report, LengthUnit unit) {
    report_->setVisible(report != nullptr);
    if (report == nullptr) return;
    QString text = tr("%1 → %2 points").arg(countText(report->pointsBefore), countText(report->pointsAfter));
    if (report->largestDeviation > 0.0)
        text += QStringLiteral(" · ") + tr("off by %1").arg(lengthText(report->largestDeviation, unit));
    if (report_->text() != text) report_->setText(text);
}

void EditCard::setUnit(LengthUnit unit) {
    for (QuantityField* field : fields_) field->setLengthUnit(unit);
}

} // namespace burin

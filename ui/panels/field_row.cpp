// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/field_row.h"

#include <QHBoxLayout>
#include <QLabel>

namespace burin {

FieldRow::FieldRow(const QString& label, QWidget* field, const QString& toolTip, QWidget* parent, int fieldWidth)
    : QWidget(parent), label_(new QLabel(label, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    label_->setProperty("look", "quiet");
    label_->setWordWrap(true);
    label_->setBuddy(field);
    row->addWidget(label_, 1);
    row->addWidget(field);
    field->setFixedWidth(fieldWidth);
    field->setAccessibleName(QString(label).remove(QLatin1Char('&')));
    if (field->toolTip().isEmpty()) field->setToolTip(toolTip);
    label_->setToolTip(field->toolTip());
}

} // namespace burin

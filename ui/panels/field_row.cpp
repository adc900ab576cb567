// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/field_row.h"

#include <QBoxLayout>
#include <QLabel>

namespace burin {

FieldRow::FieldRow(const QString& label, QWidget* field, const QString& toolTip, QWidget* parent, int fieldWidth)
    : QWidget(parent), label_(new QLabel(label, this)) {
    const bool below = fieldWidth == wholeWidth;
    auto* row = new QBoxLayout(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(below ? 4 : 8);
    label_->setProperty("look", "quiet");
    label_->setWordWrap(true);
    label_->setBuddy(field);
    // In a wider panel a choice gets the extra width, for long names.
    const bool grows = fieldWidth == choiceWidth;
    row->addWidget(label_, grows ? 2 : 1);
    row->addWidget(field, grows ? 3 : 0);
    if (grows) {
        field->setMinimumWidth(fieldWidth);
        field->setSizePolicy(QSizePolicy::Expanding, field->sizePolicy().verticalPolicy());
    } else if (!below) {
        field->setFixedWidth(fieldWidth);
    }
    // A name would hide the text of a label from assistive programs.
    if (qobject_cast<QLabel*>(field) == nullptr) field->setAccessibleName(QString(label).remove(QLatin1Char('&')));
    if (field->toolTip().isEmpty()) field->setToolTip(toolTip);
    label_->setToolTip(field->toolTip());
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/value_row.h"

#include "ui/panels/elided_label.h"
#include "ui/theme/number_font.h"

#include <QHBoxLayout>

namespace burin {

ValueRow::ValueRow(const QString& label, QWidget* parent)
    : QWidget(parent), label_(new ElidedLabel(label, this)), value_(new ElidedLabel({}, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    label_->setProperty("look", "quiet");
    value_->setFont(numberFont(font()));
    value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value_->setTextInteractionFlags(Qt::NoTextInteraction);
    row->addWidget(label_, 0);
    row->addWidget(value_, 1); // all the available width, so that a longer value is shown in full without a new layout
    setAccessibleName(label);
}

void ValueRow::setValue(const QString& value, const QString& spoken) {
    if (const QString& read = spoken.isEmpty() ? value : spoken; accessibleDescription() != read) {
        setAccessibleDescription(read);
        value_->setAccessibleName(spoken);
    }
    if (value_->text() != value) value_->setText(value);
}

QString ValueRow::value() const {
    return value_->text();
}

} // namespace burin

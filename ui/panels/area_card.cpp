// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/area_card.h"

#include "ui/panels/buttons.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/texts.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace burin {

AreaCard::AreaCard(QWidget* parent)
    : QFrame(parent)
    , size_(new ElidedLabel({}, this))
    , clear_(makeIconButton(QStringLiteral("cancel"), tr("Clear the area: the next pass goes over the whole part"),
                            QStringLiteral("clearAreaButton"), this))
    , brush_(new QuantityField(Quantity::length, this)) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    size_->setObjectName(QStringLiteral("paintedArea"));
    auto* head = new QHBoxLayout;
    head->addWidget(size_, 1);
    head->addWidget(clear_);
    column->addLayout(head);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    const std::array names{"brushAreaButton", "lassoAreaButton", "faceAreaButton"};
    const std::array texts{tr("Brush"), tr("Lasso"), tr("Face")};
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        shapes_[i] = makeChoiceButton(texts[i], {}, QLatin1String(names[i]), this);
        shapes_[i]->setAutoExclusive(false); // a second click ends painting
        row->addWidget(shapes_[i], 1);
        connect(shapes_[i], &QPushButton::clicked, this,
                [this, i](bool on) { emit paintingRequested(static_cast<AreaShape>(i), on); });
    }
    column->addLayout(row);
    brush_->setObjectName(QStringLiteral("brushDiameter"));
    brush_->limit(thinnestBrush, widestBrush);
    brushRow_ = new FieldRow(tr("Brush diameter"), brush_, tr("Ctrl+wheel in the view changes it, too"), this);
    column->addWidget(brushRow_);
    connect(brush_, &QuantityField::valueEdited, this, &AreaCard::brushChosen);
    connect(clear_, &QToolButton::clicked, this, &AreaCard::cleared);
    show();
}

void AreaCard::setUnit(LengthUnit unit) {
    unit_ = unit;
    brush_->setLengthUnit(unit);
    show();
}

void AreaCard::setState(const AreaState& state) {
    if (state == state_) return;
    state_ = state;
    show();
}

void AreaCard::show() {
    const bool painted = state_.area > 0.0;
    QString text = painted ? tr("Area of the next pass: %1").arg(areaText(state_.area, unit_))
                           : tr("Area of the next pass: whole part");
    if (state_.painting == AreaShape::brush && !painted) text = tr("Paint on the part; Shift erases");
    if (state_.painting == AreaShape::lasso && !painted) text = tr("Draw round an area; Shift erases");
    if (state_.painting == AreaShape::face && !painted) text = tr("Click faces of the part; Shift removes");
    size_->setText(text);
    setEnabledKeepingFocus(clear_, painted);
    const QString none = state_.possible ? QString() : tr("There is no part to paint on yet.");
    const std::array toolTips{tr("Paint the area of the next pass on the part with a brush; Shift erases"),
                              tr("Draw round the area of the next pass; Shift erases"),
                              tr("Click faces of the part for the next pass; Shift removes them")};
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        shapes_[i]->setChecked(state_.painting == static_cast<AreaShape>(i));
        enableUnless(shapes_[i], none, toolTips[i]);
    }
    brush_->showValue(state_.brush);
    brushRow_->setVisible(state_.painting == AreaShape::brush);
}

} // namespace burin

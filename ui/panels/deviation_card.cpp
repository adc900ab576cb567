// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/deviation_card.h"

#include "ui/panels/buttons.h"
#include "ui/panels/deviation_legend.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QCheckBox>
#include <QEvent>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <cmath>

namespace burin {

DeviationCard::DeviationCard(QWidget* parent)
    : QFrame(parent)
    , switch_(new QCheckBox(tr("Show the deviation"), this))
    , faces_(makeButton(tr("Faces…"), {}, QStringLiteral("facesButton"), this))
    , legend_(new DeviationLegend(this))
    , under_(makeWrappedLabel(this))
    , bands_(new RowList(this)) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    switch_->setObjectName(QStringLiteral("deviationSwitch"));
    switch_->setToolTip(
        tr("Colours the part by the excess stock that the program leaves, or by the depth of its gouges"));
    legend_->setObjectName(QStringLiteral("deviationLegend"));
    bands_->setObjectName(QStringLiteral("deviationBands"));
    bands_->setAccessibleName(tr("Bands of deviation and their shares of the part"));
    bands_->setSelectionMode(QAbstractItemView::NoSelection);
    under_->setObjectName(QStringLiteral("deviationUnderPointer"));
    under_->setProperty("look", "small");
    under_->setFont(numberFont(under_->font()));
    auto* top = new QHBoxLayout;
    top->addWidget(switch_, 1);
    top->addWidget(faces_);
    column->addLayout(top);
    connect(faces_, &QPushButton::clicked, this, &DeviationCard::facesRequested);
    setFacesPossible(true);
    column->addWidget(legend_);
    column->addWidget(under_);
    column->addWidget(bands_);
    connect(switch_, &QCheckBox::clicked, this, [this](bool on) {
        showOn(on);
        if (on) QTimer::singleShot(0, this, &DeviationCard::scrollIntoView); // after the layout has been updated
        emit switched(on);
    });
    showOn(false);
}

void DeviationCard::setUnit(LengthUnit unit) {
    unit_ = unit;
    refresh();
}

void DeviationCard::setShares(const DeviationMap::Shares& shares, const DeviationTolerance& tolerance) {
    shares_ = shares;
    tolerance_ = tolerance;
    refresh();
}

void DeviationCard::showOn(bool on) {
    switch_->setChecked(on);
    legend_->setVisible(on);
    bands_->setVisible(on);
    under_->setVisible(on);
    refresh();
}

void DeviationCard::setFacesPossible(bool possible) {
    enableUnless(faces_, possible ? QString() : tr("Something has changed since the check; post and check it again"),
                 tr("Lists the faces of the part with gouges and stock left on each"));
}

/// The legend opens below the visible area.
void DeviationCard::scrollIntoView() {
    for (QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(above)) return area->ensureWidgetVisible(this);
}

void DeviationCard::showUnderPointer(const std::optional<DeviationSample>& sample) {
    sample_ = sample;
    refresh();
}

void DeviationCard::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh(); // swatches store colours, not roles
}

void DeviationCard::refresh() {
    const DeviationScale scale(tolerance_);
    const auto row = [](const DeviationColour& colour, const QString& title, double share) {
        ListRow shown;
        shown.title = shown.toolTip = title;
        shown.value = QLocale().toString(100.0 * share, 'f', 1) + QChar(QChar::Nbsp) + QLatin1Char('%');
        shown.swatch = QColor(colour[0], colour[1], colour[2]);
        return shown;
    };
    // The colour at the middle of each band.
    const double left = tolerance_.allowance + 5.0 * tolerance_.excess, deep = -5.0 * tolerance_.gouge;
    legend_->setTolerance(tolerance_);
    legend_->setUnit(unit_);
    legend_->setPointer(sample_ ? std::optional(deviationOf(*sample_)) : std::nullopt);
    bands_->setRows(
        {row(scale.colourOf(left), tr("More is left"), shares_.excess),
         row(scale.colourOf(tolerance_.allowance),
             tr("Within %1").arg(shortLength(tolerance_.allowance + tolerance_.excess, unit_)), shares_.inTolerance),
         row(scale.colourOf(deep), tr("Gouge deeper than %1").arg(shortLength(tolerance_.gouge, unit_)), shares_.gouge),
         row(unmeasuredColour, tr("Out of the tool's reach"), shares_.unreachable)});
    QString text = tr("Move the pointer over the part to read the deviation.");
    if (sample_) {
        const double deviation = deviationOf(*sample_);
        text = deviation < 0.0 ? tr("Here: %1 too deep").arg(lengthText(-deviation, unit_))
                               : tr("Here: %1 left").arg(lengthText(deviation, unit_));
        if (!sample_->reachable) text += QStringLiteral(" · ") + tr("out of the tool's reach");
    }
    setWrappedText(under_, text);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/deviation_card.h"

#include "ui/panels/panel_layout.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/theme/deviation_colours.h"
#include "ui/theme/number_font.h"

#include <QCheckBox>
#include <QEvent>
#include <QVBoxLayout>

#include <cmath>

namespace burin {

DeviationCard::DeviationCard(QWidget* parent)
    : QFrame(parent)
    , switch_(new QCheckBox(tr("Show the deviation"), this))
    , bands_(new RowList(this))
    , under_(makeWrappedLabel(this)) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    switch_->setObjectName(QStringLiteral("deviationSwitch"));
    switch_->setToolTip(tr("Draw the bare part with what the program leaves on it, or takes from it"));
    bands_->setObjectName(QStringLiteral("deviationBands"));
    bands_->setAccessibleName(tr("Bands of deviation and their shares of the part"));
    bands_->setSelectionMode(QAbstractItemView::NoSelection);
    under_->setObjectName(QStringLiteral("deviationUnderPointer"));
    under_->setProperty("look", "small");
    under_->setFont(numberFont(under_->font()));
    column->addWidget(switch_);
    column->addWidget(bands_);
    column->addWidget(under_);
    connect(switch_, &QCheckBox::clicked, this, [this](bool on) {
        showOn(on);
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
    bands_->setVisible(on);
    under_->setVisible(on);
    refresh();
}

void DeviationCard::showUnderPointer(const std::optional<DeviationSample>& sample) {
    sample_ = sample;
    refresh();
}

void DeviationCard::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh(); // swatches are colours, not roles
}

void DeviationCard::refresh() {
    const auto row = [](DeviationBand band, const QString& title, double share) {
        ListRow row;
        row.title = row.toolTip = title;
        row.value = QLocale().toString(100.0 * share, 'f', 1) + QChar(QChar::Nbsp) + QLatin1Char('%');
        row.swatch = activePalette().*roleOf(band);
        return row;
    };
    bands_->setRows(
        {row(DeviationBand::gouge, tr("Gouge deeper than %1").arg(shortLength(tolerance_.gouge, unit_)), shares_.gouge),
         row(DeviationBand::inTolerance,
             tr("Within %1").arg(shortLength(tolerance_.allowance + tolerance_.excess, unit_)), shares_.inTolerance),
         row(DeviationBand::excess, tr("More is left"), shares_.excess),
         row(DeviationBand::unreachable, tr("Out of the tool's reach"), shares_.unreachable)});
    QString text = tr("Point at the part for its figure.");
    if (sample_) {
        const double deviation = deviationOf(*sample_);
        text = deviation < 0.0 ? tr("Here: %1 too deep").arg(lengthText(-deviation, unit_))
                               : tr("Here: %1 left").arg(lengthText(deviation, unit_));
        if (!sample_->reachable) text += QStringLiteral(" · ") + tr("out of the tool's reach");
    }
    setWrappedText(under_, text);
}

} // namespace burin

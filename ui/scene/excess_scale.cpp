// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/excess_scale.h"

#include "core/base/units.h"

#include <QCoreApplication>

namespace burin {

ColourScaleContent excessScale(const DeviationScale& scale, LengthUnit unit) {
    const bool inch = unit == LengthUnit::inch;
    QStringList marks;
    for (const DeviationScale::Mark& mark : scale.marks())
        marks << (inch ? fixedNumber(mark.deviation / millimetresPerInch, 4) : fixedNumber(mark.deviation, 2));
    return {QCoreApplication::translate("burin::Viewport", "Excess stock, %1").arg(unitText(unit)),
            [scale](double share) {
                const DeviationColour colour = scale.colourAt(share);
                return QColor(colour[0], colour[1], colour[2]);
            },
            std::move(marks)};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/fixture_labels.h"

#include "ui/panels/quantity.h"

#include <QCoreApplication>

#include <cmath>

namespace burin {

namespace {

class FixtureLabels {
    Q_DECLARE_TR_FUNCTIONS(FixtureLabels)
};

} // namespace

QString fitText(const std::string& name, const FixtureFit& fit, LengthUnit unit) {
    const QString fixture = QString::fromStdString(name);
    if (fit.depth > 0.0)
        return FixtureLabels::tr("“%1” is %2 deep in the stock; change its position or size.")
            .arg(fixture, lengthText(fit.depth, unit));
    if (std::isinf(fit.gap))
        return FixtureLabels::tr("There is no stock where “%1” clamps; change its position or size.").arg(fixture);
    if (fit.gap > 0.0)
        return FixtureLabels::tr("“%1” doesn't touch the stock: a gap of %2 remains.")
            .arg(fixture, lengthText(fit.gap, unit));
    return {};
}

} // namespace burin

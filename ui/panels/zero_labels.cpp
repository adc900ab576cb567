// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/zero_labels.h"

#include <QCoreApplication>

namespace burin {

namespace {

class ZeroLabels {
    Q_DECLARE_TR_FUNCTIONS(burin::ZeroLabels)
};

} // namespace

std::array<QString, 3> sideTexts(std::size_t axis) {
    if (axis == 0) return {ZeroLabels::tr("left"), ZeroLabels::tr("middle"), ZeroLabels::tr("right")};
    if (axis == 1) return {ZeroLabels::tr("front"), ZeroLabels::tr("middle"), ZeroLabels::tr("back")};
    return {ZeroLabels::tr("bottom"), ZeroLabels::tr("middle"), ZeroLabels::tr("top")};
}

QString zeroText(const ProgramZero& zero) {
    if (zero.on == ZeroReference::point) return ZeroLabels::tr("at stated coordinates");
    const auto side = [&zero](std::size_t axis) { return sideTexts(axis)[static_cast<std::size_t>(zero.sides[axis])]; };
    const QString pattern = zero.on == ZeroReference::stock ? ZeroLabels::tr("on the stock: X %1, Y %2, Z %3")
                                                            : ZeroLabels::tr("on the part: X %1, Y %2, Z %3");
    return pattern.arg(side(0), side(1), side(2));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/zero_words.h"

#include <QCoreApplication>

namespace burin {

namespace {

class ZeroWords {
    Q_DECLARE_TR_FUNCTIONS(burin::ZeroWords)
};

} // namespace

std::array<QString, 3> sideTexts(std::size_t axis) {
    if (axis == 0) return {ZeroWords::tr("left"), ZeroWords::tr("middle"), ZeroWords::tr("right")};
    if (axis == 1) return {ZeroWords::tr("front"), ZeroWords::tr("middle"), ZeroWords::tr("back")};
    return {ZeroWords::tr("bottom"), ZeroWords::tr("middle"), ZeroWords::tr("top")};
}

QString zeroText(const ProgramZero& zero) {
    if (zero.on == ZeroReference::point) return ZeroWords::tr("at stated coordinates");
    const auto side = [&zero](std::size_t axis) { return sideTexts(axis)[static_cast<std::size_t>(zero.sides[axis])]; };
    const QString pattern = zero.on == ZeroReference::stock ? ZeroWords::tr("on the stock: X %1, Y %2, Z %3")
                                                            : ZeroWords::tr("on the part: X %1, Y %2, Z %3");
    return pattern.arg(side(0), side(1), side(2));
}

} // namespace burin

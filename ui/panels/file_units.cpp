// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/file_units.h"

#include "core/base/numbers.h"
#include "core/cad/file_unit.h"
#include "ui/panels/texts.h"

#include <QComboBox>
#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace burin {

namespace {

constexpr const char* context = "FileUnits";
constexpr std::array units{
    std::pair{1.0, QT_TRANSLATE_NOOP("FileUnits", "mm")}, std::pair{25.4, QT_TRANSLATE_NOOP("FileUnits", "inch")},
    std::pair{10.0, QT_TRANSLATE_NOOP("FileUnits", "cm")}, std::pair{1000.0, QT_TRANSLATE_NOOP("FileUnits", "m")}};

QString nameOfUnit(double millimetres) {
    for (const auto& [scale, name] : units)
        if (isSameUnit(millimetres, scale)) return QCoreApplication::translate(context, name);
    const std::string length = formatShortest(millimetres) + " mm";
    return QCoreApplication::translate("ImportUnit", unitName(millimetres, length).c_str());
}

QString markedText(double millimetres, const Model& model) {
    const QString text = nameOfUnit(millimetres);
    if (model.statedUnit <= 0.0 || !isSameUnit(millimetres, model.statedUnit)) return text;
    const char* mark = statesUnit(model) ? QT_TRANSLATE_NOOP("FileUnits", "%1 (stated)")
                                         : QT_TRANSLATE_NOOP("FileUnits", "%1 (assumed)");
    return QCoreApplication::translate(context, mark).arg(text);
}

void add(std::vector<double>& scales, double millimetres) {
    const auto same = [&](double scale) { return isSameUnit(scale, millimetres); };
    if (millimetres > 0.0 && std::ranges::none_of(scales, same)) scales.push_back(millimetres);
}

} // namespace

void offerFileUnits(QComboBox& box, const Model& model, LengthUnit shown) {
    std::vector<double> scales;
    for (const auto& [millimetres, name] : units) scales.push_back(millimetres);
    add(scales, model.statedUnit);
    add(scales, model.unitScale); // the command line accepts any
    while (box.count() > static_cast<int>(scales.size())) box.removeItem(box.count() - 1);
    for (std::size_t i = 0; i < scales.size(); ++i) {
        const int item = static_cast<int>(i);
        if (item == box.count()) box.addItem(QString());
        box.setItemText(item, markedText(scales[i], model));
        box.setItemData(item, scales[i]);
        box.setItemData(item, sizeText(sizeInUnit(model, scales[i]), shown), Qt::ToolTipRole);
        if (isSameUnit(scales[i], model.unitScale)) box.setCurrentIndex(item);
    }
}

void addFileUnits(QComboBox& box) {
    for (const auto& [millimetres, name] : units) box.addItem(QCoreApplication::translate(context, name), millimetres);
}

} // namespace burin

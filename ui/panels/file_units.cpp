// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/file_units.h"

#include <QComboBox>
#include <QCoreApplication>

#include <array>
#include <utility>

namespace burin {

namespace {

constexpr const char* context = "FileUnits";
constexpr std::array units{
    std::pair{1.0, QT_TRANSLATE_NOOP("FileUnits", "mm")}, std::pair{25.4, QT_TRANSLATE_NOOP("FileUnits", "inch")},
    std::pair{10.0, QT_TRANSLATE_NOOP("FileUnits", "cm")}, std::pair{1000.0, QT_TRANSLATE_NOOP("FileUnits", "m")}};

} // namespace

void addFileUnits(QComboBox& box) {
    for (const auto& [millimetres, name] : units) box.addItem(QCoreApplication::translate(context, name), millimetres);
}

} // namespace burin

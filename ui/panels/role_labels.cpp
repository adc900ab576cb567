// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/role_labels.h"

#include <QCoreApplication>

namespace burin {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("burin::RoleLabels", text);
}

} // namespace

QString roleText(BodyRole role) {
    switch (role) {
    case BodyRole::part:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Part"));
    case BodyRole::stock:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Stock"));
    case BodyRole::insert:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Insert"));
    case BodyRole::protectedInsert:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Protected insert"));
    case BodyRole::fixture:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Fixture"));
    case BodyRole::ignored:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Ignored"));
    }
    return {};
}

QString roleToolTip() {
    return words(QT_TRANSLATE_NOOP(
        "burin::RoleLabels", "A part and a protected insert are not cut; an insert is cut and has a material of its "
                             "own; a fixture holds the stock; stock is what the part is cut from"));
}

QString stockFormText(StockForm form) {
    switch (form) {
    case StockForm::box:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Box"));
    case StockForm::cylinder:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Cylinder"));
    case StockForm::solids:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "Bodies of the model"));
    case StockForm::file:
        return words(QT_TRANSLATE_NOOP("burin::RoleLabels", "From a file"));
    }
    return {};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/role_words.h"

#include <QCoreApplication>

namespace burin {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("burin::RoleWords", text);
}

} // namespace

QString roleText(BodyRole role) {
    switch (role) {
    case BodyRole::part:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Part"));
    case BodyRole::stock:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Stock"));
    case BodyRole::insert:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Insert"));
    case BodyRole::protectedInsert:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Protected insert"));
    case BodyRole::fixture:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Fixture"));
    case BodyRole::ignored:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Ignored"));
    }
    return {};
}

QString roleToolTip() {
    return words(QT_TRANSLATE_NOOP(
        "burin::RoleWords", "A part and a protected insert are not cut; an insert is cut and has a material of its "
                            "own; a fixture holds the stock; stock is what the part is cut from"));
}

QString stockFormText(StockForm form) {
    switch (form) {
    case StockForm::box:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Box"));
    case StockForm::cylinder:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Cylinder"));
    case StockForm::solids:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "Bodies of the model"));
    case StockForm::file:
        return words(QT_TRANSLATE_NOOP("burin::RoleWords", "From a file"));
    }
    return {};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/preferences_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace burin {

PreferencesDialog::PreferencesDialog(const Preferences& preferences, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("preferencesDialog"));
    setWindowTitle(tr("Preferences"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 16);
    layout->setSpacing(16);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(24);
    form->setVerticalSpacing(8);
    form->setObjectName(QStringLiteral("preferencesForm"));
    layout->addLayout(form);
    const auto add = [&](const QString& label, const char* name, const QString& toolTip) {
        auto* choice = new QComboBox(this);
        choice->setObjectName(QString::fromLatin1(name));
        choice->setToolTip(toolTip);
        choice->setMinimumWidth(200);
        form->addRow(label, choice);
        return choice;
    };
    unit_ = add(tr("Unit"), "unitChoice", tr("The unit in which lengths are shown. Files always hold millimetres."));
    unit_->addItem(tr("Millimetres"), static_cast<int>(LengthUnit::millimetre));
    unit_->addItem(tr("Inches"), static_cast<int>(LengthUnit::inch));
    theme_ = add(tr("Theme"), "themeChoice", tr("Colours of the window."));
    theme_->addItem(tr("Dark"), static_cast<int>(Theme::dark));
    theme_->addItem(tr("Light"), static_cast<int>(Theme::light));
    language_ = add(tr("Language"), "languageChoice", tr("Takes effect at the next start."));
    language_->addItem(tr("Same as the system"), QString());
    language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
    language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
    language_->addItem(QString::fromUtf8("简体中文"), QStringLiteral("zh_CN"));

    unit_->setCurrentIndex(unit_->findData(static_cast<int>(preferences.unit)));
    theme_->setCurrentIndex(theme_->findData(static_cast<int>(preferences.theme)));
    language_->setCurrentIndex(std::max(0, language_->findData(preferences.language)));
    for (QComboBox* choice : {unit_, theme_, language_})
        connect(choice, &QComboBox::currentIndexChanged, this,
                [this] { emit preferencesChanged(this->preferences()); });

    auto* note = new QLabel(tr("A new language takes effect at the next start."), this);
    note->setObjectName(QStringLiteral("languageNote"));
    note->setProperty("look", "quiet");
    note->setWordWrap(true);
    layout->addWidget(note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->setObjectName(QStringLiteral("preferencesButtons"));
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close this window."));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

Preferences PreferencesDialog::preferences() const {
    return {static_cast<Theme>(theme_->currentData().toInt()), static_cast<LengthUnit>(unit_->currentData().toInt()),
            language_->currentData().toString()};
}

} // namespace burin

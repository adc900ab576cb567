// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/setup_dialog.h"

#include "core/base/units.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>

namespace burin {

namespace {

/// Translation context of this file.
struct SetupDialog {
    Q_DECLARE_TR_FUNCTIONS(SetupDialog)
};

/// A rotation of the part between two setups, in the order of the list.
struct Turn {
    QString text;
    int axis = 0;
    double angle = 0.0; ///< rad
};

std::array<Turn, 7> turns() {
    return {{{SetupDialog::tr("rotated by 180° about X"), 0, pi},
             {SetupDialog::tr("rotated by 180° about Y"), 1, pi},
             {SetupDialog::tr("rotated by 90° about X"), 0, 0.5 * pi},
             {SetupDialog::tr("rotated by -90° about X"), 0, -0.5 * pi},
             {SetupDialog::tr("rotated by 90° about Y"), 1, 0.5 * pi},
             {SetupDialog::tr("rotated by -90° about Y"), 1, -0.5 * pi},
             {SetupDialog::tr("not rotated"), 2, 0.0}}};
}

Placement placementOf(const Turn& turn, const glm::dvec3& middle) {
    if (turn.angle == 0.0) return {};
    glm::dvec3 axis(0.0);
    axis[turn.axis] = 1.0;
    return turnedAbout(axis, turn.angle, middle);
}

} // namespace

std::optional<RequestedSetup> askSetup(QWidget* parent, const QString& name, const glm::dvec3& middle, bool leaves) {
    QDialog dialog(parent);
    dialog.setObjectName(QStringLiteral("setupDialog"));
    dialog.setWindowTitle(SetupDialog::tr("Add a setup"));
    auto* column = new QVBoxLayout(&dialog);
    auto* form = new QFormLayout;
    column->addLayout(form);

    auto* nameField = new QLineEdit(name, &dialog);
    nameField->setObjectName(QStringLiteral("setupNameField"));
    nameField->setMaxLength(60);
    nameField->setToolTip(SetupDialog::tr("Name of the setup, shown in lists and in the file name of its program"));
    form->addRow(SetupDialog::tr("Name"), nameField);
    auto* turn = new QComboBox(&dialog);
    turn->setObjectName(QStringLiteral("setupTurn"));
    turn->setToolTip(
        SetupDialog::tr("Rotation about the centre of the part, relative to this setup. You can change it later"));
    for (const Turn& offered : turns()) turn->addItem(offered.text);
    form->addRow(SetupDialog::tr("The part is"), turn);
    auto* stock = new QComboBox(&dialog);
    stock->setObjectName(QStringLiteral("setupStock"));
    stock->addItem(SetupDialog::tr("the workpiece of this setup"));
    stock->addItem(SetupDialog::tr("new stock with the same margins"));
    stock->setToolTip(
        SetupDialog::tr("The workpiece after the checked program of this setup. Without one: after its recordings"));
    if (!leaves) {
        stock->setCurrentIndex(1);
        stock->setEnabled(false);
    }
    form->addRow(SetupDialog::tr("Its stock is"), stock);

    auto* buttons = new QDialogButtonBox(&dialog);
    QPushButton* confirm = buttons->addButton(SetupDialog::tr("Add"), QDialogButtonBox::AcceptRole);
    confirm->setObjectName(QStringLiteral("confirmButton"));
    confirm->setToolTip(SetupDialog::tr("Add the setup and switch to it"));
    confirm->setDefault(true);
    QPushButton* cancel = buttons->addButton(SetupDialog::tr("Cancel"), QDialogButtonBox::RejectRole);
    cancel->setObjectName(QStringLiteral("cancelButton"));
    cancel->setToolTip(SetupDialog::tr("Change nothing"));
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    column->addWidget(buttons);
    nameField->selectAll();
    nameField->setFocus();
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    const auto chosen = turns()[static_cast<std::size_t>(turn->currentIndex())];
    return RequestedSetup{nameField->text().trimmed(), placementOf(chosen, middle), stock->currentIndex() == 0};
}

} // namespace burin

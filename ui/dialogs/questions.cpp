// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/questions.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace burin {

namespace {

/// Translation context of this file.
struct Questions {
    Q_DECLARE_TR_FUNCTIONS(Questions)
};

QPushButton* addButton(QMessageBox& box, const QString& text, QMessageBox::ButtonRole role, const char* name,
                       const QString& toolTip) {
    QPushButton* button = box.addButton(text, role);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(toolTip);
    return button;
}

} // namespace

UnsavedAnswer askUnsaved(QWidget* parent, const QString& project) {
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("unsavedDialog"));
    box.setWindowTitle(Questions::tr("Unsaved changes"));
    box.setText(Questions::tr("“%1” has changes that are not saved.").arg(project));
    box.setInformativeText(Questions::tr("Do you want to save them?"));
    QPushButton* save = addButton(box, Questions::tr("Save"), QMessageBox::AcceptRole, "saveButton",
                                  Questions::tr("Save the project, then go on."));
    const QPushButton* discard = addButton(box, Questions::tr("Discard"), QMessageBox::DestructiveRole, "discardButton",
                                           Questions::tr("Go on; the changes are lost."));
    QPushButton* cancel = addButton(box, Questions::tr("Cancel"), QMessageBox::RejectRole, "cancelButton",
                                    Questions::tr("Change nothing."));
    box.setDefaultButton(save);
    box.setEscapeButton(cancel);
    box.exec();
    if (box.clickedButton() == save) return UnsavedAnswer::save;
    return box.clickedButton() == discard ? UnsavedAnswer::discard : UnsavedAnswer::cancel;
}

bool confirm(QWidget* parent, const QString& question, const QString& consequence, const QString& confirmText) {
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("confirmDialog"));
    box.setWindowTitle(Questions::tr("Burin"));
    box.setText(question);
    box.setInformativeText(consequence);
    const QPushButton* yes = addButton(box, confirmText, QMessageBox::DestructiveRole, "confirmButton", consequence);
    QPushButton* cancel = addButton(box, Questions::tr("Cancel"), QMessageBox::RejectRole, "cancelButton",
                                    Questions::tr("Change nothing."));
    box.setDefaultButton(cancel);
    box.setEscapeButton(cancel);
    box.exec();
    return box.clickedButton() == yes;
}

QString askOverride(QWidget* parent, int findings) {
    constexpr int width = 420, longest = 200; // pixels; characters: a few lines of a header
    const QString consequence =
        findings == 1 ? Questions::tr("Its check found 1 problem that can damage a tool, the part or the machine.")
                      : Questions::tr("Its check found %n problems that can damage a tool, the part or the machine.",
                                      nullptr, findings);
    const QString label = Questions::tr("Your reason. It goes into the program's header together with the findings.");
    QDialog dialog(parent);
    dialog.setObjectName(QStringLiteral("reasonDialog"));
    dialog.setWindowTitle(Questions::tr("Burin"));
    auto* column = new QVBoxLayout(&dialog);
    auto* heading = new QLabel(Questions::tr("Export a program that was refused?"), &dialog);
    heading->setProperty("look", "title");
    column->addWidget(heading);
    for (const QString& text : {consequence, label}) {
        auto* line = new QLabel(text, &dialog);
        line->setWordWrap(true);
        column->addWidget(line);
    }
    auto* reason = new QLineEdit(&dialog);
    reason->setObjectName(QStringLiteral("reasonField"));
    reason->setAccessibleName(label);
    reason->setToolTip(label);
    reason->setMaxLength(longest);
    reason->setMinimumWidth(width);
    column->addWidget(reason);
    auto* buttons = new QDialogButtonBox(&dialog);
    QPushButton* yes = buttons->addButton(Questions::tr("Override the check"), QDialogButtonBox::AcceptRole);
    yes->setObjectName(QStringLiteral("confirmButton"));
    yes->setToolTip(consequence);
    yes->setEnabled(false);
    QPushButton* cancel = buttons->addButton(Questions::tr("Cancel"), QDialogButtonBox::RejectRole);
    cancel->setObjectName(QStringLiteral("cancelButton"));
    cancel->setToolTip(Questions::tr("Change nothing."));
    column->addWidget(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    QObject::connect(reason, &QLineEdit::textChanged, yes,
                     [yes](const QString& text) { yes->setEnabled(!text.trimmed().isEmpty()); });
    return dialog.exec() == QDialog::Accepted ? reason->text().trimmed() : QString();
}

void showAbout(QWidget* parent, const QString& version) {
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("aboutDialog"));
    box.setWindowTitle(Questions::tr("About Burin"));
    box.setText(Questions::tr("Burin %1").arg(version));
    box.setInformativeText(Questions::tr(
        "Milling tool paths authored by hand.\n\nThe method follows Chen and Yang, “Haptic rendering based on spatial "
        "run-length encoding”, Robotics and Computer-Integrated Manufacturing 20 (2004) 237–246.\n\nFree software "
        "under the Apache License 2.0. Made with Qt, VTK, OpenCASCADE, oneTBB, SQLite and Zstandard."));
    QPushButton* close = addButton(box, Questions::tr("Close"), QMessageBox::AcceptRole, "closeButton",
                                   Questions::tr("Close this window."));
    box.setEscapeButton(close);
    box.exec();
}

} // namespace burin

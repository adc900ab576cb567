// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/material_dialog.h"

#include "core/base/file.h"
#include "core/cutting/material_file.h"
#include "core/cutting/material_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/details.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/material_form.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"
#include "ui/window/calibration_dialog.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize firstSize(1120, 720);
constexpr int listWidth = 320; // pixels

QString nameOf(const Property& material) {
    return QCoreApplication::translate("Resource", material.name.c_str());
}

void addKey(QPushButton* button, const QKeySequence& key, const QString& toolTip) {
    button->setShortcut(key);
    button->setToolTip(toolTip + QStringLiteral(" (") + key.toString(QKeySequence::NativeText) + QLatin1Char(')'));
}

} // namespace

MaterialDialog::MaterialDialog(MaterialController& library, const std::string& inUse, bool locked, QWidget* parent)
    : QDialog(parent), library_(library), locked_(locked) {
    setObjectName(QStringLiteral("materialDialog"));
    setWindowTitle(tr("Materials"));
    layOut();
    resize(firstSize);
    connect(&library, &Controller::changed, this, &MaterialDialog::refresh);
    connect(&library, &Controller::failed, this,
            [this](const Error& error) { notice_->tell(Notice::Kind::error, Messages::sentence(error)); });
    showMaterial(inUse);
    list_->setFocus();
}

void MaterialDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(makeList());
    auto* values = new QVBoxLayout;
    values->setSpacing(8);
    title_ = new QLabel(this);
    title_->setProperty("look", "title");
    title_->setObjectName(QStringLiteral("materialTitle"));
    values->addWidget(title_);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("materialNotice"));
    values->addWidget(notice_);
    form_ = new MaterialForm(this);
    values->addWidget(form_, 1);
    row->addLayout(values, 1);
    column->addLayout(row, 1);
    column->addWidget(makeButtons());
    for (auto* button : findChildren<QPushButton*>()) button->setAutoDefault(false); // Enter belongs to the fields
    connect(form_, &MaterialForm::edited, this, &MaterialDialog::follow);
}

QWidget* MaterialDialog::makeList() {
    auto* side = new QWidget(this);
    side->setFixedWidth(listWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    list_ = new RowList(side);
    list_->setObjectName(QStringLiteral("materialList"));
    list_->setAccessibleName(tr("Materials"));
    list_->setTextsWrap(true);
    list_->setFillsHeight(true);
    column->addWidget(list_, 1);
    copy_ = makeButton(tr("Copy"), QStringLiteral("add"), QStringLiteral("copyMaterialButton"), side);
    addKey(copy_, QKeySequence(Qt::CTRL | Qt::Key_D), tr("Copy this material to one of your own and change that"));
    remove_ = makeButton(tr("Delete"), QStringLiteral("remove"), QStringLiteral("deleteMaterialButton"), side);
    auto* add = makeButton(tr("Add from a file…"), QStringLiteral("import"), QStringLiteral("addMaterialButton"), side);
    addKey(add, QKeySequence(Qt::CTRL | Qt::Key_O), tr("Add a material file, or a material card of FreeCAD (.FCMat)"));
    auto* calibrated =
        makeButton(tr("Calibrate…"), QStringLiteral("import"), QStringLiteral("calibrateMaterialButton"), side);
    addKey(calibrated, QKeySequence(Qt::CTRL | Qt::Key_K), tr("Fit K and Kr to measured cutting forces (CSV)"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(copy_);
    buttons->addWidget(remove_);
    column->addLayout(buttons);
    column->addWidget(add);
    column->addWidget(calibrated);
    connect(list_, &RowList::rowChosen, this, &MaterialDialog::choose);
    connect(copy_, &QPushButton::clicked, this, &MaterialDialog::copy);
    connect(remove_, &QPushButton::clicked, this, &MaterialDialog::remove);
    connect(add, &QPushButton::clicked, this, &MaterialDialog::addFromFile);
    connect(calibrated, &QPushButton::clicked, this, &MaterialDialog::calibrate);
    auto* deletes = new QShortcut(Qt::Key_Delete, list_);
    deletes->setContext(Qt::WidgetShortcut);
    connect(deletes, &QShortcut::activated, remove_, &QPushButton::click);
    return side;
}

QWidget* MaterialDialog::makeButtons() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    revert_ = makeButton(tr("Revert"), QStringLiteral("undo"), QStringLiteral("revertMaterialButton"), foot);
    save_ = makePrimaryButton(tr("Save"), QStringLiteral("saveMaterialButton"), foot);
    auto* close = makeButton(tr("Close"), QStringLiteral("cancel"), QStringLiteral("closeMaterialsButton"), foot);
    close->setToolTip(tr("Close this page (Esc)"));
    row->addStretch(1);
    for (QPushButton* button : {revert_, save_, close}) row->addWidget(button);
    connect(save_, &QPushButton::clicked, this, &MaterialDialog::saveChanges);
    connect(revert_, &QPushButton::clicked, this, [this] { showMaterial(id_); });
    connect(close, &QPushButton::clicked, this, &MaterialDialog::reject);
    return foot;
}

const Property* MaterialDialog::shown() const {
    const auto& materials = library_.materials();
    const auto found = std::ranges::find(materials, id_, &Property::id);
    return found == materials.end() ? nullptr : &*found;
}

bool MaterialDialog::modified() const {
    const Property* material = shown();
    return material != nullptr && (toJson(form_->material()) != toJson(*material) || !form_->problem().isEmpty());
}

void MaterialDialog::refreshList() {
    std::vector<ListRow> rows;
    int chosen = -1;
    for (const Property& material : library_.materials()) {
        ListRow row;
        row.title = row.toolTip = nameOf(material);
        row.badge = isShippedMaterial(material.id) ? tr("shipped") : tr("own");
        row.detail = QString::fromStdString(material.id);
        if (material.id == id_) chosen = static_cast<int>(rows.size());
        rows.push_back(row);
    }
    list_->setRows(rows);
    list_->setChosen(chosen);
}

/// What is not saved stays in the fields.
void MaterialDialog::refresh() {
    if (modified()) {
        refreshList();
        follow();
    } else {
        showMaterial(id_);
    }
}

/// The first one where it is not there any more.
void MaterialDialog::showMaterial(const std::string& id) {
    id_ = id;
    if (shown() == nullptr && !library_.materials().empty()) id_ = library_.materials().front().id;
    const Property* material = shown();
    if (material == nullptr) return;
    const bool shipped = isShippedMaterial(id_);
    title_->setText(nameOf(*material));
    form_->showMaterial(*material, shipped);
    if (shipped)
        notice_->tell(Notice::Kind::information,
                      tr("Burin is shipped with this material, which can't be changed. Copy it and change the copy."));
    else
        notice_->tell(Notice::Kind::passed, locked_ ? tr("Your own material. The open project has recordings and keeps "
                                                         "the values that they were made with.")
                                                    : tr("Your own material."));
    refreshList();
    follow();
}

void MaterialDialog::follow() {
    const bool shipped = isShippedMaterial(id_), unsaved = modified();
    const QString problem = form_->problem();
    if (unsaved)
        notice_->tell(problem.isEmpty() ? Notice::Kind::warning : Notice::Kind::error,
                      problem.isEmpty() ? tr("Changed, and not saved yet.") : problem);
    enableUnless(remove_, shipped ? tr("The materials that Burin is shipped with can't be deleted.") : QString(),
                 tr("Delete this material; Undo brings it back (Del in the list)"));
    const QString unchanged = tr("Nothing is changed.");
    enableUnless(save_,
                 !problem.isEmpty() ? problem
                 : unsaved          ? QString()
                                    : unchanged,
                 tr("Keep the changed values (Ctrl+S)"));
    enableUnless(revert_, unsaved ? QString() : unchanged, tr("Discard the changes (Ctrl+R)"));
    save_->setShortcut(QKeySequence::Save);
    revert_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
}

bool MaterialDialog::leaveChanges() {
    return !modified() || confirm(this, tr("Discard the changes of “%1”?").arg(title_->text()),
                                  tr("They are not saved. This can't be undone."), tr("Discard"));
}

void MaterialDialog::choose(int row) {
    if (row < 0 || row >= static_cast<int>(library_.materials().size())) return;
    const std::string id = library_.materials()[static_cast<std::size_t>(row)].id;
    if (id == id_) return;
    if (leaveChanges())
        showMaterial(id);
    else
        refreshList();
}

void MaterialDialog::copy() {
    const Property* material = shown();
    if (material == nullptr || !leaveChanges()) return;
    showMaterial(library_.copyMaterial(Property(*material), tr("%1 (copy)").arg(nameOf(*material))));
    auto* name = form_->findChild<QLineEdit*>(QStringLiteral("materialName"));
    name->setFocus();
    name->selectAll();
}

void MaterialDialog::remove() {
    if (isShippedMaterial(id_)) return;
    const QString name = title_->text();
    library_.deleteMaterial(std::string(id_));
    notice_->tell(Notice::Kind::information, tr("“%1” was deleted; Undo brings it back.").arg(name));
}

void MaterialDialog::addFromFile() {
    if (!leaveChanges()) return;
    const QString file = askMaterialToAdd(this, QDir::homePath());
    if (file.isEmpty()) return;
    const Result<std::string> text = readFile(file.toStdString());
    const Result<ReadMaterial> read =
        text ? materialFromText(*text, file.toStdString()) : Result<ReadMaterial>(text.error());
    if (!read) {
        notice_->tell(Notice::Kind::error, Messages::sentence(read.error()));
        return;
    }
    const auto& materials = library_.materials();
    if (std::ranges::find(materials, read->material.id, &Property::id) != materials.end()) {
        notice_->tell(Notice::Kind::error,
                      tr("There is a material with the ID “%1” already; give the one in the file another ID.")
                          .arg(QString::fromStdString(read->material.id)));
        return;
    }
    library_.keepMaterial(read->material);
    showMaterial(read->material.id);
    QStringList notes;
    for (const std::string& note : read->notes) notes << detailText(note);
    if (!notes.isEmpty()) notice_->tell(Notice::Kind::warning, notes.join(QLatin1Char(' ')));
}

void MaterialDialog::calibrate() {
    const Property* material = shown();
    if (material == nullptr || !leaveChanges()) return;
    CalibrationDialog dialog(library_.materials(), material->id, this);
    if (dialog.exec() != QDialog::Accepted) return;
    for (const Property& calibrated : dialog.calibrated()) library_.keepMaterial(calibrated);
    if (!dialog.calibrated().empty()) showMaterial(dialog.calibrated().front().id);
}

/// What can't be kept is not lost, but stays in the fields.
void MaterialDialog::saveChanges() {
    save_->setFocus(); // what is being typed is entered
    if (!modified() || !form_->problem().isEmpty()) return;
    const Property wanted = form_->material();
    if (const Result<void> sound = checkMaterial(wanted, wanted.id); !sound) {
        notice_->tell(Notice::Kind::error, Messages::sentence(sound.error()));
        return;
    }
    library_.keepMaterial(wanted);
}

void MaterialDialog::reject() {
    if (leaveChanges()) QDialog::reject();
}

} // namespace burin

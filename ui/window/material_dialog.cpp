// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/material_dialog.h"

#include "core/base/file.h"
#include "core/cutting/material_file.h"
#include "core/cutting/material_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/details.h"
#include "ui/panels/material_form.h"
#include "ui/window/calibration_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QPushButton>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize firstMaterialSize(1110, 720);

QString nameOf(const Property& material) {
    return QCoreApplication::translate("Resource", material.name.c_str());
}

} // namespace

MaterialDialog::MaterialDialog(MaterialController& library, const std::string& inUse, bool locked, QWidget* parent)
    : LibraryDialog({QStringLiteral("Material"), tr("Materials"), tr("shipped"),
                     tr("Copy this material to one of your own and change that"),
                     tr("Add a material file, or a material card of FreeCAD (.FCMat)"),
                     tr("Delete this material; Undo brings it back (Del in the list)"),
                     tr("The materials that Burin is shipped with can't be deleted."),
                     tr("There is a material with the ID “%1” already; give the one in the file another ID.")},
                    firstMaterialSize, parent)
    , library_(library)
    , locked_(locked)
    , form_(new MaterialForm(this)) {
    auto* calibrates =
        addListButton(tr("Calibrate…"), QStringLiteral("import"), QStringLiteral("calibrateMaterialButton"),
                      QKeySequence(Qt::CTRL | Qt::Key_K), tr("Fit K and Kr to measured cutting forces (CSV)"));
    connect(calibrates, &QPushButton::clicked, this, &MaterialDialog::calibrate);
    connect(&library, &Controller::changed, this, &MaterialDialog::refresh);
    connect(&library, &Controller::failed, this, &MaterialDialog::fail);
    start(form_, QStringLiteral("materialName"), inUse);
    connect(form_, &MaterialForm::edited, this, &MaterialDialog::follow);
}

const Property* MaterialDialog::material(const std::string& id) const {
    const auto& materials = library_.materials();
    const auto found = std::ranges::find(materials, id, &Property::id);
    return found == materials.end() ? nullptr : &*found;
}

std::vector<LibraryDialog::Entry> MaterialDialog::entries() const {
    std::vector<Entry> entries;
    for (const Property& material : library_.materials())
        entries.push_back({material.id, nameOf(material), isShippedMaterial(material.id), false});
    return entries;
}

void MaterialDialog::fill(const std::string& id, bool shipped) {
    if (const Property* wanted = material(id)) form_->showMaterial(*wanted, shipped);
}

bool MaterialDialog::edited() const {
    const Property* shown = material(shownId());
    return shown != nullptr && (toJson(form_->material()) != toJson(*shown) || !form_->problem().isEmpty());
}

QString MaterialDialog::problem() const {
    return form_->problem();
}

QString MaterialDialog::about(bool shipped) const {
    if (shipped) return tr("Burin is shipped with this material, which can't be changed. Copy it and change the copy.");
    return locked_ ? tr("Your own material. The open project has recordings and keeps the values that they were made "
                        "with.")
                   : tr("Your own material.");
}

std::string MaterialDialog::copy(const std::string& id) {
    const Property* original = material(id);
    return original == nullptr ? id
                               : library_.copyMaterial(Property(*original), tr("%1 (copy)").arg(nameOf(*original)));
}

void MaterialDialog::erase(const std::string& id) {
    library_.deleteMaterial(id);
}

QString MaterialDialog::askFile() {
    return askMaterialToAdd(this, QDir::homePath());
}

Result<LibraryDialog::Incoming> MaterialDialog::read(const std::string& file) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const Result<ReadMaterial> read = materialFromText(*text, file);
    if (!read) return read.error();
    QStringList notes;
    for (const std::string& note : read->notes) notes << detailText(note);
    return Incoming{read->material.id, [this, material = read->material] { library_.keepMaterial(material); },
                    notes.join(QLatin1Char(' '))};
}

void MaterialDialog::calibrate() {
    if (shownId().empty() || !leaveChanges()) return;
    CalibrationDialog dialog(library_.materials(), shownId(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    for (const Property& calibrated : dialog.calibrated()) library_.keepMaterial(calibrated);
    if (!dialog.calibrated().empty()) showEntry(dialog.calibrated().front().id);
}

Result<void> MaterialDialog::keep() {
    const Property wanted = form_->material();
    if (const Result<void> sound = checkMaterial(wanted, wanted.id); !sound) return sound.error();
    library_.keepMaterial(wanted);
    return {};
}

} // namespace burin

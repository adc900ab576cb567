// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/material_controller.h"

#include "core/cutting/material_library.h"
#include "ui/workbench/undo_refusal.h"
#include "ui/workbench/value_command.h"

namespace burin {

MaterialController::MaterialController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    readLibrary();
}

void MaterialController::readLibrary() {
    materials_.clear();
    for (const std::string& id : materialIds()) {
        if (Result<Property> material = loadMaterial(id))
            materials_.push_back(std::move(*material));
        else // queued: nothing is connected during construction
            QMetaObject::invokeMethod(
                this, [this, fault = material.error()] { emit failed(fault); }, Qt::QueuedConnection);
    }
}

std::string MaterialController::copyMaterial(const Property& material, const QString& name) {
    if (refusedDuringUndo(desk_, *this, tr("copy of a material"))) return material.id;
    const std::string id = freeId(materials_, material.id + "-copy");
    push(tr("copy of a material"), {id, copyOf(material, id, name.toStdString())});
    return id;
}

void MaterialController::keepMaterial(const Property& material) {
    push(tr("values of a material"), {material.id, material});
}

void MaterialController::deleteMaterial(const std::string& id) {
    push(tr("deleting a material"), {id, std::nullopt});
}

void MaterialController::push(const QString& text, const OwnFile<Property>& wanted) {
    if (refusedDuringUndo(desk_, *this, text)) return;
    const OwnFile<Property> before{wanted.id,
                                   isShippedMaterial(wanted.id) ? std::nullopt : itemOf(materials_, wanted.id)};
    desk_.undo.push(new ValueCommand<OwnFile<Property>>(text, -1, before, wanted,
                                                        [this](const OwnFile<Property>& own) { apply(own); }));
}

void MaterialController::apply(const OwnFile<Property>& own) {
    if (const Result<void> done = write(own, saveMaterial, removeMaterial); !done) emit failed(done.error());
    readLibrary();
    emit changed();
}

} // namespace burin

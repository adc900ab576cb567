// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/material_controller.h"

#include "core/cutting/material_library.h"
#include "ui/workbench/value_command.h"

#include <algorithm>

namespace burin {

MaterialController::MaterialController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    readLibrary();
}

void MaterialController::readLibrary() {
    materials_.clear();
    for (const std::string& id : materialIds()) {
        if (Result<Property> material = loadMaterial(id))
            materials_.push_back(std::move(*material));
        else // at the beginning nobody listens yet
            QMetaObject::invokeMethod(
                this, [this, fault = material.error()] { emit failed(fault); }, Qt::QueuedConnection);
    }
}

std::string MaterialController::copyMaterial(const Property& material, const QString& name) {
    const std::string first = material.id + "-copy";
    std::string id = first;
    for (int i = 2; std::ranges::find(materials_, id, &Property::id) != materials_.end(); ++i)
        id = first + "-" + std::to_string(i);
    push(tr("copy of a material"), {id, copyOf(material, id, name.toStdString())});
    return id;
}

void MaterialController::keepMaterial(const Property& material) {
    push(tr("values of a material"), {material.id, material});
}

void MaterialController::deleteMaterial(const std::string& id) {
    push(tr("deleting a material"), {id, std::nullopt});
}

void MaterialController::push(const QString& text, const OwnMaterial& wanted) {
    OwnMaterial before{wanted.id, std::nullopt};
    const auto found = std::ranges::find(materials_, wanted.id, &Property::id);
    if (found != materials_.end() && !isShippedMaterial(wanted.id)) before.material = *found;
    desk_.undo.push(new ValueCommand<OwnMaterial>(text, -1, before, wanted,
                                                  [this](const OwnMaterial& material) { apply(material); }));
}

/// Material files are a few kilobytes: they are written here, before anything shows them.
void MaterialController::apply(const OwnMaterial& material) {
    const Result<void> done = [&]() -> Result<void> {
        if (!material.material) return removeMaterial(material.id);
        const Result<std::filesystem::path> file = saveMaterial(*material.material, true);
        return file ? Result<void>() : Result<void>(file.error());
    }();
    if (!done) emit failed(done.error());
    readLibrary();
    emit changed();
}

} // namespace burin

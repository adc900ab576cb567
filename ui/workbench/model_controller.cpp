// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/model_controller.h"

#include <utility>

namespace burin {

void ModelController::read(const std::filesystem::path& file, double stlUnit, Then then) {
    const QString title = tr("Importing %1").arg(QString::fromStdString(file.filename().string()));
    desk_.tasks.start(
        TaskKind::importing, title,
        [file, stlUnit](Progress& progress) -> Result<std::shared_ptr<const Model>> {
            ImportOptions options;
            options.stlUnit = stlUnit;
            Result<Model> model = importModel(file, options, progress);
            if (!model) return std::move(model).error();
            return std::make_shared<const Model>(std::move(*model));
        },
        [this, then = std::move(then)](const Result<std::shared_ptr<const Model>>& outcome) {
            emit changed();
            if (outcome)
                then(*outcome);
            else
                emit failed(outcome.error());
        });
    emit changed();
}

void ModelController::adopt(const std::shared_ptr<const Model>& model) {
    load(model);
    store([model](Project& project) { return project.setModel(*model); });
    emit imported();
}

void ModelController::load(std::shared_ptr<const Model> model) {
    model_ = std::move(model);
    emit changed();
}

} // namespace burin

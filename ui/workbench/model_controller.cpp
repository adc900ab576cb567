// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/model_controller.h"

#include "ui/workbench/value_command.h"

#include <QPointer>

#include <utility>

namespace burin {

void ModelController::read(const std::filesystem::path& file, const ImportOptions& options, Then then) {
    preview_.reset();
    const QString name = QString::fromStdString(file.filename().string());
    // Posted to the task runner, which outlives this controller; the controller may be gone when a preview comes.
    const auto show = [tasks = &desk_.tasks, self = QPointer(this), read = ++reads_,
                       title = tr("%1: preview; the fine mesh is being made").arg(name)](ModelPreview preview) {
        const auto shared = std::make_shared<const ModelPreview>(std::move(preview));
        QMetaObject::invokeMethod(
            tasks,
            [self, read, title, shared] {
                if (self) self->showPreview(read, shared, title);
            },
            Qt::QueuedConnection);
    };
    desk_.tasks.start(
        TaskKind::importing, tr("Importing %1").arg(name),
        [file, options, show](Progress& progress) -> Result<std::shared_ptr<const Model>> {
            Result<Model> model = importModel(file, options, progress, show);
            if (!model) return std::move(model).error();
            return std::make_shared<const Model>(std::move(*model));
        },
        [this, then = std::move(then)](const Result<std::shared_ptr<const Model>>& outcome) {
            if (!outcome) preview_.reset();
            emit changed();
            if (outcome)
                then(*outcome);
            else
                emit failed(outcome.error());
        });
    emit changed();
}

void ModelController::showPreview(quint64 read, std::shared_ptr<const ModelPreview> preview, const QString& title) {
    if (read != reads_ || !importing()) return;
    preview_ = std::move(preview);
    desk_.tasks.rename(TaskKind::importing, title);
    emit changed();
}

void ModelController::dropPreview() {
    if (std::exchange(preview_, nullptr)) emit changed();
}

void ModelController::adopt(const std::shared_ptr<const Model>& model) {
    preview_.reset();
    load(model);
    store([model](Project& project) { return project.setModel(*model); });
    emit imported();
}

void ModelController::exchange(const QString& title, const std::shared_ptr<const Model>& other) {
    preview_.reset();
    using Shared = std::shared_ptr<const Model>;
    desk_.undo.pushForming(new ValueCommand<Shared>(title, -1, model_, other, [this](const Shared& model) {
        model_ = model;
        store([model, colours = colours_](Project& project) {
            const Result<void> stored = project.setModel(*model);
            return stored ? project.setBodyColours(colours) : stored;
        });
        emit exchanged();
        emit changed();
    }));
}

void ModelController::mirror(int axis) {
    if (model_) exchange(tr("mirrored part"), placed(model_, mirroredAcross(axis, model_->box().centre())));
}

void ModelController::chooseColour(const std::vector<std::size_t>& bodies, const BodyColour& colour) {
    std::vector<BodyColour> colours = colours_;
    for (const std::size_t body : bodies)
        if (body < colours.size()) colours[body] = colour;
    if (colours == colours_) return;
    desk_.undo.push(new ValueCommand<std::vector<BodyColour>>(
        tr("colour of bodies"), -1, colours_, colours, [this](const std::vector<BodyColour>& chosen) {
            colours_ = chosen;
            store([chosen](Project& project) { return project.setBodyColours(chosen); });
            emit changed();
        }));
}

void ModelController::load(std::shared_ptr<const Model> model) {
    model_ = std::move(model);
    colours_.clear();
    if (model_)
        for (const Body& body : model_->bodies) colours_.push_back(body.colour);
    emit changed();
}

} // namespace burin

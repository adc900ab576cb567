// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "ui/workbench/controller.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace burin {

/// Imports the part in the background and holds it.
class ModelController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    const std::shared_ptr<const Model>& model() const noexcept { return model_; }
    /// A coarse model of the part being read, for display alone. Null: none.
    const std::shared_ptr<const ModelPreview>& preview() const noexcept { return preview_; }
    /// Discards the preview: the part that was read is not adopted, or only after a question about the open project.
    void dropPreview();
    bool importing() const { return desk_.tasks.running(TaskKind::importing); }

    using Then = std::function<void(std::shared_ptr<const Model>)>;
    /// Reads a file and changes nothing but the preview; calls `then` on success, otherwise `failed` reports the error.
    /// The preview is removed when reading fails or is cancelled, by `adopt` or by `dropPreview`.
    /// @param fileUnit mm per unit of a file that states none
    void read(const std::filesystem::path& file, double fileUnit, Then then);
    /// Makes a model that was read the part of the open project.
    void adopt(const std::shared_ptr<const Model>& model);
    /// Mirrors the part about the middle plane of its box; an entry of the undo stack.
    /// @param axis 0, 1, 2 for x, y, z of the model's frame
    void mirror(int axis);
    /// Loads the model of a project, which is stored already.
    void load(std::shared_ptr<const Model> model);

signals:
    /// There is a new part; everything made for the previous one is invalid.
    void imported();
    void mirrored(); ///< the part was replaced by its mirror image

private:
    void showPreview(quint64 read, std::shared_ptr<const ModelPreview> preview, const QString& title);

    std::shared_ptr<const Model> model_;
    std::shared_ptr<const ModelPreview> preview_;
    quint64 reads_ = 0; ///< counts calls of `read`, so that previews of a replaced one are ignored
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"
#include "ui/workbench/controller.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace burin {

/// The part: imports it in the background and keeps it.
class ModelController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    const std::shared_ptr<const Model>& model() const noexcept { return model_; }
    /// What there is to see of the part that is being read, for the picture alone. Null: nothing.
    const std::shared_ptr<const ModelPreview>& preview() const noexcept { return preview_; }
    /// The part that was read isn't adopted, or not before a question about what is open.
    void dropPreview();
    bool importing() const { return desk_.tasks.running(TaskKind::importing); }

    using Then = std::function<void(std::shared_ptr<const Model>)>;
    /// Reads a file and changes nothing but the preview; `then` is called where that went well, `failed` reports it
    /// otherwise. The preview goes with an end that is no success, `adopt` or `dropPreview`.
    /// @param fileUnit mm per unit of a file that states none
    void read(const std::filesystem::path& file, double fileUnit, Then then);
    /// Makes a model that was read the part of the open project.
    void adopt(const std::shared_ptr<const Model>& model);
    /// Makes the part its own mirror image across the middle of its box; an entry of the undo stack.
    /// @param axis 0, 1, 2 for x, y, z of the model's frame
    void mirror(int axis);
    /// What a project holds; stored already.
    void load(std::shared_ptr<const Model> model);

signals:
    /// A new part is here; what was made for the one before is void.
    void imported();
    void mirrored(); ///< the part is its mirror image

private:
    void showPreview(quint64 read, std::shared_ptr<const ModelPreview> preview, const QString& title);

    std::shared_ptr<const Model> model_;
    std::shared_ptr<const ModelPreview> preview_;
    quint64 reads_ = 0; ///< counts read: the preview of one that was replaced comes too late
};

} // namespace burin

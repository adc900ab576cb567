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
    /// The colours of the model's bodies, as in its file or as chosen; they replace those in the model.
    const std::vector<BodyColour>& colours() const noexcept { return colours_; }
    /// An entry of the undo stack. @param colour empty: the part's blue
    void chooseColour(const std::vector<std::size_t>& bodies, const BodyColour& colour);
    /// A coarse model of the part being read, for display alone. Null: none.
    const std::shared_ptr<const ModelPreview>& preview() const noexcept { return preview_; }
    /// Discards the preview: the part that was read is not adopted, or only after a question about the open project.
    void dropPreview();
    bool importing() const { return desk_.tasks.running(TaskKind::importing); }

    using Then = std::function<void(std::shared_ptr<const Model>)>;
    /// Reads a file and changes nothing but the preview; calls `then` on success, otherwise `failed` reports the error.
    /// The preview is removed when reading fails or is cancelled, by `adopt` or by `dropPreview`.
    void read(const std::filesystem::path& file, const ImportOptions& options, Then then);
    /// Makes a model that was read the part of the open project.
    void adopt(const std::shared_ptr<const Model>& model);
    /// Replaces the part by one with the same bodies; an entry of the undo stack.
    void exchange(const QString& title, const std::shared_ptr<const Model>& other);
    /// Mirrors the part about the middle plane of its box; an entry of the undo stack.
    /// @param axis 0, 1, 2 for x, y, z of the model's frame
    void mirror(int axis);
    /// Loads the model of a project, which is stored already.
    void load(std::shared_ptr<const Model> model);

signals:
    /// There is a new part; everything made for the previous one is invalid.
    void imported();
    void exchanged(); ///< the part was replaced by one with the same bodies

private:
    void showPreview(quint64 read, std::shared_ptr<const ModelPreview> preview, const QString& title);

    std::shared_ptr<const Model> model_;
    std::vector<BodyColour> colours_;
    std::shared_ptr<const ModelPreview> preview_;
    quint64 reads_ = 0; ///< counts calls of `read`, so that previews of a replaced one are ignored
};

} // namespace burin

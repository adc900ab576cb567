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
    bool importing() const { return desk_.tasks.running(TaskKind::importing); }

    using Then = std::function<void(std::shared_ptr<const Model>)>;
    /// Reads a file and changes nothing; `then` is called where that went well, `failed` reports it otherwise.
    /// @param stlUnit mm per unit of an STL file, which states none
    void read(const std::filesystem::path& file, double stlUnit, Then then);
    /// Makes a model that was read the part of the open project.
    void adopt(const std::shared_ptr<const Model>& model);
    /// What a project holds; stored already.
    void load(std::shared_ptr<const Model> model);

signals:
    /// A new part is here; what was made for the one before is void.
    void imported();

private:
    std::shared_ptr<const Model> model_;
};

} // namespace burin

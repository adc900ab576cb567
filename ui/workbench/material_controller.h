// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"
#include "ui/workbench/controller.h"
#include "ui/workbench/own_file.h"

#include <string>
#include <vector>

namespace burin {

/// The library of materials: those shipped with Burin, preceded by the user's own. It belongs to the user, not to the
/// project: undoing a change of a material restores its file.
class MaterialController final : public Controller {
    Q_OBJECT
public:
    MaterialController(const Desk& desk, QObject* parent);

    const std::vector<Property>& materials() const noexcept { return materials_; } ///< by id

    // Entries of the undo stack.
    /// @return id of the copy: that of the original with "-copy" and, if needed, a number
    std::string copyMaterial(const Property& material, const QString& name);
    /// New or changed; one with the id of a shipped material takes precedence over it
    void keepMaterial(const Property& material);
    void deleteMaterial(const std::string& id); ///< one of the user's own

private:
    void push(const QString& text, const OwnFile<Property>& wanted);
    void apply(const OwnFile<Property>& own);
    void readLibrary();

    std::vector<Property> materials_;
};

} // namespace burin

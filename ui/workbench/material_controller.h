// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"
#include "ui/workbench/controller.h"
#include "ui/workbench/own_file.h"

#include <string>
#include <vector>

namespace burin {

/// The library of materials: those that Burin is shipped with and the user's own, which stand before them. It is the
/// user's, not the project's: who undoes a change of one has the file as it was.
class MaterialController final : public Controller {
    Q_OBJECT
public:
    MaterialController(const Desk& desk, QObject* parent);

    const std::vector<Property>& materials() const noexcept { return materials_; } ///< by id

    // Entries of the undo stack.
    /// @return its id: that of the original with "-copy" and, where needed, a number
    std::string copyMaterial(const Property& material, const QString& name);
    void keepMaterial(const Property& material); ///< new or changed; one of a shipped id stands before that
    void deleteMaterial(const std::string& id);  ///< one of the user's own

private:
    void push(const QString& text, const OwnFile<Property>& wanted);
    void apply(const OwnFile<Property>& own);
    void readLibrary();

    std::vector<Property> materials_;
};

} // namespace burin

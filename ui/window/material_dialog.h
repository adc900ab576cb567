// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/library_dialog.h"
#include "ui/workbench/material_controller.h"

namespace burin {

class MaterialForm;

/// The materials shipped with Burin and the user's own: to view, copy, change, delete, add from a file and calibrate.
/// Each step is an entry of the undo stack. `library` outlives the dialog.
class MaterialDialog final : public LibraryDialog {
    Q_OBJECT
public:
    /// @param inUse id of the stock's material, which is shown first
    /// @param locked the project keeps its own values because it has recordings
    MaterialDialog(MaterialController& library, const std::string& inUse, bool locked, QWidget* parent);

private:
    std::vector<Entry> entries() const override;
    void fill(const std::string& id, bool shipped) override;
    bool edited() const override;
    QString problem() const override;
    QString about(bool shipped) const override;
    std::string copy(const std::string& id) override;
    void erase(const std::string& id) override;
    Result<void> keep() override;
    QString askFile() override;
    Result<Incoming> read(const std::string& file) override;

    void calibrate();
    const Property* material(const std::string& id) const;

    MaterialController& library_;
    bool locked_;
    MaterialForm* form_ = nullptr;
};

} // namespace burin

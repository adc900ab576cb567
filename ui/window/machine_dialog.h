// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/window/library_dialog.h"
#include "ui/workbench/target_controller.h"

namespace burin {

class MachineForm;

/// The machines shipped with Burin and the user's own: to view, copy, change, delete and use. Each step is an entry of
/// the undo stack. `target` outlives the dialog.
class MachineDialog final : public LibraryDialog {
    Q_OBJECT
public:
    MachineDialog(TargetController& target, LengthUnit unit, QWidget* parent);

private:
    std::vector<Entry> entries() const override;
    void fill(const std::string& id, bool shipped) override;
    bool edited() const override;
    QString about(bool shipped) const override;
    std::string copy(const std::string& id) override;
    void erase(const std::string& id) override;
    Result<void> keep() override;
    QString askFile() override;
    Result<Incoming> read(const std::string& file) override;
    void followFoot() override;

    MachineForm* makeForm(LengthUnit unit);
    const MachineProfile* machine(const std::string& id) const;

    TargetController& target_;
    MachineForm* form_ = nullptr;
    QPushButton* use_ = nullptr;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/program_target.h"
#include "core/nc/dialect_library.h"
#include "ui/workbench/controller.h"
#include "ui/workbench/own_file.h"

#include <string>
#include <vector>

namespace burin {

/// The target of the programs: the machine, which also limits feeds, speeds and travel, and the dialect of its control.
class TargetController final : public Controller {
    Q_OBJECT
public:
    TargetController(const Desk& desk, QObject* parent);

    const ProgramTarget& target() const noexcept { return target_; }
    /// Machines that can be chosen; damaged files are left out and reported.
    const std::vector<MachineProfile>& machines() const noexcept { return machines_; }
    /// The machine in force; another one stands in if the project's is not known on this computer.
    const MachineProfile& machine() const noexcept;
    /// Dialects that can be chosen; damaged files are left out and reported.
    const std::vector<DialectDescription>& dialects() const noexcept { return dialects_; }
    const std::string& dialect() const noexcept { return target_.dialectFor(machine()); }

    /// The project's machine if it is not known on this computer, so that `machine` stands in for it; empty if it is
    /// known.
    std::string missingMachine() const;

    // Entries of the undo stack. The machines belong to the user, not to the project: undoing a change restores the
    // file.
    /// @return id of the copy, which is not chosen: that of the original with "-copy" and, if needed, a number
    std::string copyMachine(const MachineProfile& machine, const QString& name);
    void keepMachine(const MachineProfile& machine); ///< one of the user's own, new or changed
    void deleteMachine(const std::string& id);       ///< one of the user's own
    void chooseMachine(const std::string& id);       ///< together with the dialect of its control
    void chooseDialect(const std::string& dialect);
    void chooseUnits(NcUnits units); ///< of the text of programs

    void load(const ProgramTarget& target);

private:
    void readLibraries();
    void push(const QString& text, const ProgramTarget& wanted);
    void apply(const ProgramTarget& target);
    void pushMachine(const QString& text, const OwnFile<MachineProfile>& wanted);
    void applyMachine(const OwnFile<MachineProfile>& own);

    std::vector<MachineProfile> machines_;
    std::vector<DialectDescription> dialects_;
    ProgramTarget target_;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/target_controller.h"

#include "core/machine/machine_library.h"
#include "ui/workbench/undo_refusal.h"
#include "ui/workbench/value_command.h"

#include <algorithm>

namespace burin {

namespace {

/// @param faults receives the errors of files that can't be read
std::vector<MachineProfile> library(std::vector<Error>& faults) {
    std::vector<MachineProfile> machines;
    for (const std::string& id : machineIds()) {
        if (Result<MachineProfile> machine = loadMachine(id))
            machines.push_back(std::move(*machine));
        else
            faults.push_back(machine.error());
    }
    return machines;
}

} // namespace

TargetController::TargetController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    readLibraries();
}

void TargetController::readLibraries() {
    DialectList list = burin::dialects();
    dialects_ = std::move(list.known);
    machines_ = library(list.faults);
    for (const Error& fault : list.faults) // queued: nothing is connected during construction
        QMetaObject::invokeMethod(
            this, [this, fault] { emit failed(fault); }, Qt::QueuedConnection);
}

const MachineProfile& TargetController::machine() const noexcept {
    static const MachineProfile none;
    for (const std::string& wanted : {target_.machine, std::string(firstMachine)})
        if (const auto found = std::ranges::find(machines_, wanted, &MachineProfile::id); found != machines_.end())
            return *found;
    return machines_.empty() ? none : machines_.front();
}

std::string TargetController::missingMachine() const {
    return machine().id == target_.machine ? std::string() : target_.machine;
}

std::string TargetController::copyMachine(const MachineProfile& machine, const QString& name) {
    const std::string id = freeId(machines_, machine.id + "-copy");
    pushMachine(tr("copy of a machine"), {id, copyOf(machine, id, name.toStdString())});
    return id;
}

void TargetController::keepMachine(const MachineProfile& machine) {
    pushMachine(tr("values of a machine"), {machine.id, machine});
}

void TargetController::deleteMachine(const std::string& id) {
    pushMachine(tr("deleting a machine"), {id, std::nullopt});
}

void TargetController::pushMachine(const QString& text, const OwnFile<MachineProfile>& wanted) {
    if (refusedDuringUndo(desk_, *this, text)) return;
    const OwnFile<MachineProfile> before{wanted.id, itemOf(machines_, wanted.id)};
    desk_.undo.push(new ValueCommand<OwnFile<MachineProfile>>(
        text, -1, before, wanted, [this](const OwnFile<MachineProfile>& own) { applyMachine(own); }));
}

void TargetController::applyMachine(const OwnFile<MachineProfile>& own) {
    if (const Result<void> done = write(own, saveMachine, removeMachine); !done) emit failed(done.error());
    readLibraries();
    emit changed();
    emit desk_.project.worked(); // a stored verdict applied to the previous state of the machine
}

void TargetController::chooseMachine(const std::string& id) {
    if (id != target_.machine) push(tr("machine"), {id, {}, target_.units});
}

void TargetController::chooseDialect(const std::string& dialect) {
    if (dialect != this->dialect()) push(tr("dialect"), {target_.machine, dialect, target_.units});
}

void TargetController::chooseUnits(NcUnits units) {
    if (units != target_.units) push(tr("units of the program"), {target_.machine, target_.dialect, units});
}

void TargetController::push(const QString& text, const ProgramTarget& wanted) {
    desk_.undo.push(new ValueCommand<ProgramTarget>(text, -1, target_, wanted,
                                                    [this](const ProgramTarget& value) { apply(value); }));
}

void TargetController::apply(const ProgramTarget& target) {
    target_ = target;
    store([target](Project& project) { return project.setProgramTarget(target); });
    emit changed();
}

void TargetController::load(const ProgramTarget& target) {
    readLibraries();
    target_ = target;
    emit changed();
}

} // namespace burin

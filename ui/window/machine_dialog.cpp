// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/machine_dialog.h"

#include "core/base/file.h"
#include "core/machine/machine_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/panels/buttons.h"
#include "ui/panels/machine_form.h"
#include "ui/panels/panel_layout.h"

#include <QCoreApplication>
#include <QDir>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize firstMachineSize(1090, 760);

QString nameOf(const MachineProfile& machine) {
    return QCoreApplication::translate("Resource", machine.name.c_str());
}

/// Without the note in brackets after the name of a shipped machine.
QString nameOfCopy(const MachineProfile& machine) {
    QString name = nameOf(machine);
    if (isTypicalMachine(machine.id) && name.endsWith(QLatin1Char(')')))
        name = name.left(name.lastIndexOf(QLatin1Char('('))).trimmed();
    return MachineDialog::tr("%1 (copy)").arg(name);
}

} // namespace

MachineDialog::MachineDialog(TargetController& target, LengthUnit unit, QWidget* parent)
    : LibraryDialog({QStringLiteral("Machine"), tr("Machines"), tr("typical"),
                     tr("Copy this machine to one of your own and change that"),
                     tr("Add a machine file to your own machines"),
                     tr("Delete this machine; Undo brings it back (Del in the list)"),
                     tr("The machines that Burin is shipped with can't be deleted."),
                     tr("There is a machine with the ID “%1” already; give the one in the file another ID.")},
                    firstMachineSize, parent)
    , target_(target)
    , form_(makeForm(unit)) {
    use_ = addFootButton(tr("Use for this project"), QStringLiteral("check"), QStringLiteral("useMachineButton"));
    connect(use_, &QPushButton::clicked, this, [this] { target_.chooseMachine(shownId()); });
    connect(&target, &Controller::changed, this, &MachineDialog::refresh);
    connect(&target, &Controller::failed, this, &MachineDialog::fail);
    start(makeFormArea(form_, this), QStringLiteral("name"), target.machine().id);
    connect(form_, &MachineForm::edited, this, &MachineDialog::follow);
}

MachineForm* MachineDialog::makeForm(LengthUnit unit) {
    auto* form = new MachineForm;
    form->setUnit(unit);
    QStringList names, ids;
    for (const DialectDescription& dialect : target_.dialects()) {
        names.push_back(QCoreApplication::translate("Resource", dialect.name.c_str()));
        ids.push_back(QString::fromStdString(dialect.id));
    }
    form->setDialects(names, ids);
    return form;
}

const MachineProfile* MachineDialog::machine(const std::string& id) const {
    const auto& machines = target_.machines();
    const auto found = std::ranges::find(machines, id, &MachineProfile::id);
    return found == machines.end() ? nullptr : &*found;
}

std::vector<LibraryDialog::Entry> MachineDialog::entries() const {
    std::vector<Entry> entries;
    for (const MachineProfile& machine : target_.machines())
        entries.push_back(
            {machine.id, nameOf(machine), isTypicalMachine(machine.id), machine.id == target_.machine().id});
    return entries;
}

void MachineDialog::fill(const std::string& id, bool shipped) {
    if (const MachineProfile* wanted = machine(id)) form_->showMachine(*wanted, shipped);
}

bool MachineDialog::edited() const {
    const MachineProfile* shown = machine(shownId());
    return shown != nullptr && toJson(form_->machine()) != toJson(*shown);
}

QString MachineDialog::about(bool shipped) const {
    return shipped ? tr("Typical values of its class, which can't be changed. Copy the machine and enter the "
                        "values of your own.")
                   : tr("Your own machine.");
}

void MachineDialog::followFoot() {
    enableUnless(use_, shownId() == target_.target().machine ? tr("The programs are for this machine.") : QString(),
                 tr("Make the programs of this project for this machine (Ctrl+Return)"));
    use_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return));
}

std::string MachineDialog::copy(const std::string& id) {
    const MachineProfile* original = machine(id);
    return original == nullptr ? id : target_.copyMachine(MachineProfile(*original), nameOfCopy(*original));
}

void MachineDialog::erase(const std::string& id) {
    target_.deleteMachine(id);
}

QString MachineDialog::askFile() {
    return askMachineToAdd(this, QDir::homePath());
}

Result<LibraryDialog::Incoming> MachineDialog::read(const std::string& file) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    Result<MachineProfile> read = machineFromJson(*text, file);
    if (!read) return read.error();
    return Incoming{read->id, [this, machine = *read] { target_.keepMachine(machine); }, {}};
}

/// Validates the values as when a file is read.
Result<void> MachineDialog::keep() {
    const MachineProfile wanted = form_->machine();
    const Result<MachineProfile> sound = machineFromJson(toJson(wanted), wanted.id + ".json");
    if (!sound) return sound.error();
    target_.keepMachine(wanted);
    return {};
}

} // namespace burin

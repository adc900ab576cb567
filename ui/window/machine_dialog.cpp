// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/machine_dialog.h"

#include "core/base/file.h"
#include "core/machine/machine_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/machine_form.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"

#include <QBoxLayout>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QTimer>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize firstSize(1080, 760);
constexpr int listWidth = 300; // pixels

QString nameOf(const MachineProfile& machine) {
    return QCoreApplication::translate("Resource", machine.name.c_str());
}

/// Without what a shipped machine says of itself in brackets.
QString nameOfCopy(const MachineProfile& machine) {
    QString name = nameOf(machine);
    if (isTypicalMachine(machine.id) && name.endsWith(QLatin1Char(')')))
        name = name.left(name.lastIndexOf(QLatin1Char('('))).trimmed();
    return MachineDialog::tr("%1 (copy)").arg(name);
}

void addKey(QPushButton* button, const QKeySequence& key, const QString& toolTip) {
    button->setShortcut(key);
    button->setToolTip(toolTip + QStringLiteral(" (") + key.toString(QKeySequence::NativeText) + QLatin1Char(')'));
}

} // namespace

MachineDialog::MachineDialog(TargetController& target, LengthUnit unit, QWidget* parent)
    : QDialog(parent), target_(target) {
    setObjectName(QStringLiteral("machineDialog"));
    setWindowTitle(tr("Machines"));
    layOut();
    resize(firstSize);
    form_->setUnit(unit);
    QStringList names, ids;
    for (const DialectDescription& dialect : target.dialects()) {
        names.push_back(QCoreApplication::translate("Resource", dialect.name.c_str()));
        ids.push_back(QString::fromStdString(dialect.id));
    }
    form_->setDialects(names, ids);
    connect(&target, &Controller::changed, this, &MachineDialog::refresh);
    connect(&target, &Controller::failed, this,
            [this](const Error& error) { notice_->tell(Notice::Kind::error, Messages::sentence(error)); });
    showMachine(target.machine().id);
    list_->setFocus();
}

void MachineDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(makeList());
    auto* values = new QVBoxLayout;
    values->setSpacing(8);
    title_ = new QLabel(this);
    title_->setProperty("look", "title");
    title_->setObjectName(QStringLiteral("machineTitle"));
    values->addWidget(title_);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("machineNotice"));
    values->addWidget(notice_);
    form_ = new MachineForm;
    auto* area = new QScrollArea(this);
    area->setWidget(form_);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFrameShape(QFrame::NoFrame);
    values->addWidget(area, 1);
    row->addLayout(values, 1);
    column->addLayout(row, 1);
    column->addWidget(makeButtons());
    for (auto* button : findChildren<QPushButton*>()) button->setAutoDefault(false); // Enter belongs to the fields
    connect(form_, &MachineForm::edited, this, &MachineDialog::follow);
}

QWidget* MachineDialog::makeList() {
    auto* side = new QWidget(this);
    side->setFixedWidth(listWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    list_ = new RowList(side);
    list_->setObjectName(QStringLiteral("machineList"));
    list_->setAccessibleName(tr("Machines"));
    list_->setTextsWrap(true);
    list_->setFillsHeight(true);
    column->addWidget(list_, 1);
    copy_ = makeButton(tr("Copy"), QStringLiteral("add"), QStringLiteral("copyMachineButton"), side);
    addKey(copy_, QKeySequence(Qt::CTRL | Qt::Key_D), tr("Copy this machine to one of your own and change that"));
    remove_ = makeButton(tr("Delete"), QStringLiteral("remove"), QStringLiteral("deleteMachineButton"), side);
    add_ = makeButton(tr("Add from a file…"), QStringLiteral("import"), QStringLiteral("addMachineButton"), side);
    addKey(add_, QKeySequence(Qt::CTRL | Qt::Key_O), tr("Add a machine file to your own machines"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(copy_);
    buttons->addWidget(remove_);
    column->addLayout(buttons);
    column->addWidget(add_);
    connect(list_, &RowList::rowChosen, this, &MachineDialog::choose);
    connect(copy_, &QPushButton::clicked, this, &MachineDialog::copy);
    connect(remove_, &QPushButton::clicked, this, &MachineDialog::remove);
    connect(add_, &QPushButton::clicked, this, &MachineDialog::addFromFile);
    auto* deletes = new QShortcut(Qt::Key_Delete, list_);
    deletes->setContext(Qt::WidgetShortcut);
    connect(deletes, &QShortcut::activated, remove_, &QPushButton::click);
    return side;
}

QWidget* MachineDialog::makeButtons() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    use_ = makeButton(tr("Use for this project"), QStringLiteral("check"), QStringLiteral("useMachineButton"), foot);
    revert_ = makeButton(tr("Revert"), QStringLiteral("undo"), QStringLiteral("revertMachineButton"), foot);
    save_ = makePrimaryButton(tr("Save"), QStringLiteral("saveMachineButton"), foot);
    auto* close = makeButton(tr("Close"), QStringLiteral("cancel"), QStringLiteral("closeMachinesButton"), foot);
    addKey(close, QKeySequence(Qt::Key_Escape), tr("Close this page"));
    close->setShortcut({}); // Esc belongs to the dialog, and to a field while one types in it
    row->addWidget(use_);
    row->addStretch(1);
    for (QPushButton* button : {revert_, save_, close}) row->addWidget(button);
    connect(use_, &QPushButton::clicked, this, [this] { target_.chooseMachine(id_); });
    connect(save_, &QPushButton::clicked, this, &MachineDialog::saveChanges);
    connect(revert_, &QPushButton::clicked, this, &MachineDialog::revert);
    connect(close, &QPushButton::clicked, this, &MachineDialog::reject);
    return foot;
}

const MachineProfile* MachineDialog::shown() const {
    const auto& machines = target_.machines();
    const auto found = std::ranges::find(machines, id_, &MachineProfile::id);
    return found == machines.end() ? nullptr : &*found;
}

bool MachineDialog::modified() const {
    const MachineProfile* machine = shown();
    return machine != nullptr && toJson(form_->machine()) != toJson(*machine);
}

void MachineDialog::refreshList() {
    std::vector<ListRow> rows;
    int chosen = -1;
    for (const MachineProfile& machine : target_.machines()) {
        ListRow row;
        row.title = row.toolTip = nameOf(machine);
        row.badge = isTypicalMachine(machine.id) ? tr("typical") : tr("own");
        row.detail = QString::fromStdString(machine.id);
        if (machine.id == target_.machine().id) row.detail += QStringLiteral(" · ") + tr("in use");
        if (machine.id == id_) chosen = static_cast<int>(rows.size());
        rows.push_back(row);
    }
    list_->setRows(rows);
    list_->setChosen(chosen);
}

/// What is not saved stays in the fields.
void MachineDialog::refresh() {
    if (modified()) {
        refreshList();
        follow();
    } else {
        showMachine(id_);
    }
}

/// The one in force where that one is not there any more.
void MachineDialog::showMachine(const std::string& id) {
    id_ = id;
    if (shown() == nullptr) id_ = target_.machine().id;
    const MachineProfile* machine = shown();
    if (machine == nullptr) return;
    const bool typical = isTypicalMachine(id_);
    title_->setText(nameOf(*machine));
    form_->showMachine(*machine, typical);
    notice_->tell(typical ? Notice::Kind::information : Notice::Kind::passed,
                  typical ? tr("Typical values of its class, which can't be changed. Copy the machine and enter the "
                               "values of your own.")
                          : tr("Your own machine."));
    refreshList();
    follow();
}

void MachineDialog::follow() {
    const bool typical = isTypicalMachine(id_), unsaved = modified();
    if (unsaved) notice_->tell(Notice::Kind::warning, tr("Changed, and not saved yet."));
    enableUnless(remove_, typical ? tr("The machines that Burin is shipped with can't be deleted.") : QString(),
                 tr("Delete this machine; Undo brings it back (Del in the list)"));
    const QString unchanged = tr("Nothing is changed.");
    enableUnless(save_, unsaved ? QString() : unchanged, tr("Keep the changed values (Ctrl+S)"));
    enableUnless(revert_, unsaved ? QString() : unchanged, tr("Discard the changes (Ctrl+R)"));
    save_->setShortcut(QKeySequence::Save);
    revert_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    enableUnless(use_, id_ == target_.target().machine ? tr("The programs are for this machine.") : QString(),
                 tr("Make the programs of this project for this machine (Ctrl+Return)"));
    use_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return));
}

bool MachineDialog::leaveChanges() {
    return !modified() || confirm(this, tr("Discard the changes of “%1”?").arg(title_->text()),
                                  tr("They are not saved. This can't be undone."), tr("Discard"));
}

void MachineDialog::choose(int row) {
    if (row < 0 || row >= static_cast<int>(target_.machines().size())) return;
    const std::string id = target_.machines()[static_cast<std::size_t>(row)].id;
    if (id == id_) return;
    if (leaveChanges())
        showMachine(id);
    else
        refreshList();
}

void MachineDialog::copy() {
    const MachineProfile* machine = shown();
    if (machine == nullptr || !leaveChanges()) return;
    showMachine(target_.copyMachine(MachineProfile(*machine), nameOfCopy(*machine)));
    auto* name = form_->findChild<QLineEdit*>(QStringLiteral("name"));
    name->setFocus();
    name->selectAll();
}

void MachineDialog::remove() {
    if (isTypicalMachine(id_)) return;
    const QString name = title_->text();
    target_.deleteMachine(std::string(id_));
    notice_->tell(Notice::Kind::information, tr("“%1” was deleted; Undo brings it back.").arg(name));
}

void MachineDialog::addFromFile() {
    if (!leaveChanges()) return;
    const QString file = askMachineToAdd(this, QDir::homePath());
    if (file.isEmpty()) return;
    const Result<std::string> text = readFile(file.toStdString());
    const Result<MachineProfile> machine =
        text ? machineFromJson(*text, file.toStdString()) : Result<MachineProfile>(text.error());
    if (!machine) {
        notice_->tell(Notice::Kind::error, Messages::sentence(machine.error()));
        return;
    }
    const bool known =
        std::ranges::find(target_.machines(), machine->id, &MachineProfile::id) != target_.machines().end();
    if (known) {
        notice_->tell(Notice::Kind::error,
                      tr("There is a machine with the ID “%1” already; give the one in the file another ID.")
                          .arg(QString::fromStdString(machine->id)));
        return;
    }
    target_.keepMachine(*machine);
    showMachine(machine->id);
}

/// As a file of it would be read: what can't be kept is not lost, but stays in the fields.
void MachineDialog::saveChanges() {
    save_->setFocus(); // what is being typed is entered
    if (!modified()) return;
    const MachineProfile wanted = form_->machine();
    const Result<MachineProfile> sound = machineFromJson(toJson(wanted), wanted.id + ".json");
    if (!sound) {
        notice_->tell(Notice::Kind::error, Messages::sentence(sound.error()));
        return;
    }
    target_.keepMachine(wanted);
}

void MachineDialog::revert() {
    showMachine(id_);
}

void MachineDialog::reject() {
    if (leaveChanges()) QDialog::reject();
}

} // namespace burin

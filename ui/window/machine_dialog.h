// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/workbench/target_controller.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace burin {

class MachineForm;
class Notice;
class RowList;

/// The machines that Burin is shipped with and the user's own: to look at, copy, change, delete and use. What is
/// changed counts when it is saved; each step is an entry of the undo stack. `target` outlives it.
class MachineDialog final : public QDialog {
    Q_OBJECT
public:
    MachineDialog(TargetController& target, LengthUnit unit, QWidget* parent);

    void reject() override; ///< asks about changes that are not saved

private:
    void layOut();
    QWidget* makeList();
    QWidget* makeButtons();
    void refresh();
    void refreshList();
    void showMachine(const std::string& id);
    void follow(); ///< the fields were edited
    void choose(int row);
    void copy();
    void remove();
    void addFromFile();
    void saveChanges();
    void revert();
    bool leaveChanges(); ///< nothing is unsaved, or the user gives it up
    const MachineProfile* shown() const;
    bool modified() const;

    TargetController& target_;
    std::string id_; ///< of the machine that is shown
    RowList* list_ = nullptr;
    MachineForm* form_ = nullptr;
    QLabel* title_ = nullptr;
    Notice* notice_ = nullptr;
    QPushButton *copy_ = nullptr, *remove_ = nullptr, *add_ = nullptr, *use_ = nullptr, *save_ = nullptr,
                *revert_ = nullptr;
};

} // namespace burin

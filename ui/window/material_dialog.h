// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/material_controller.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace burin {

class MaterialForm;
class Notice;
class RowList;

/// The materials that Burin is shipped with and the user's own: to look at, copy, change, delete, add from a file and
/// calibrate. What is changed counts when it is saved; each step is an entry of the undo stack. `library` outlives it.
class MaterialDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param inUse id of the stock's material: shown first
    /// @param locked the project keeps its own values, as there are recordings
    MaterialDialog(MaterialController& library, const std::string& inUse, bool locked, QWidget* parent);

    void reject() override; ///< asks about changes that are not saved

private:
    void layOut();
    QWidget* makeList();
    QWidget* makeButtons();
    void refresh();
    void refreshList();
    void showMaterial(const std::string& id);
    void follow(); ///< the fields were edited
    void choose(int row);
    void copy();
    void remove();
    void addFromFile();
    void calibrate();
    void saveChanges();
    bool leaveChanges(); ///< nothing is unsaved, or the user gives it up
    const Property* shown() const;
    bool modified() const;

    MaterialController& library_;
    std::string id_; ///< of the material that is shown
    bool locked_;
    RowList* list_ = nullptr;
    MaterialForm* form_ = nullptr;
    QLabel* title_ = nullptr;
    Notice* notice_ = nullptr;
    QPushButton *copy_ = nullptr, *remove_ = nullptr, *save_ = nullptr, *revert_ = nullptr;
};

} // namespace burin

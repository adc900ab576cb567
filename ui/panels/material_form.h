// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace burin {

/// The values of one material as a table: name, number, unit, source, and whether it is an estimate. More named values
/// can be added. Text that can't be read as a number stays in its cell, marked, and the value remains unchanged.
class MaterialForm final : public QWidget {
    Q_OBJECT
public:
    explicit MaterialForm(QWidget* parent = nullptr);
    /// Never emits. @param locked whether the values are read-only
    void showMaterial(const Property& material, bool locked);
    const Property& material() const noexcept { return material_; } ///< the material with the values of the fields
    /// Why the cells don't match `material()`, as a sentence; empty if they match.
    QString problem() const;

signals:
    void edited(); ///< by the user

private:
    void showRows();
    void addRow(const std::string& key, const NamedValue& value);
    void take();
    void addValue();
    void removeValue();
    void chooseColour();
    void showColour();

    Property material_;
    bool locked_ = false, showing_ = false;
    QLineEdit* name_;
    QPushButton *colour_, *add_, *remove_;
    QTableWidget* table_;
};

} // namespace burin

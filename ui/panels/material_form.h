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

/// The values of one material as a table: name, number, unit, source, whether it is an estimate. Further named values
/// may be added. What can't be read as a number stays in its cell, marked, and the value as it was.
class MaterialForm final : public QWidget {
    Q_OBJECT
public:
    explicit MaterialForm(QWidget* parent = nullptr);
    /// Never emits. @param locked the values are shown and can't be changed
    void showMaterial(const Property& material, bool locked);
    const Property& material() const noexcept { return material_; } ///< as the fields say
    /// Why the cells are not the material of `material`: a sentence; empty: they are.
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

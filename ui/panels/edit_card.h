// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <vector>

class QCheckBox;

namespace burin {

class ElidedLabel;
class QuantityField;

/// One edit of a path: its switch, its parameters and what it did.
class EditCard : public QFrame {
    Q_OBJECT
public:
    /// @param place in the path, from 0: part of the object names ("edit2Switch", "edit2_tolerance_mm")
    EditCard(std::size_t place, const Edit& edit, QWidget* parent = nullptr);

    /// Shows values without a signal. The kind of edit must be the one it was made for.
    void showEdit(const Edit& edit);
    void showReport(const EditReport* report, LengthUnit unit); ///< null: none (switched off, or not evaluated)
    void setUnit(LengthUnit unit);
    std::string_view kind() const { return idOf(edit_.parameters); }

signals:
    void edited(const burin::Edit& edit);

private:
    Edit edit_;
    QCheckBox* enabled_ = nullptr;
    std::vector<QuantityField*> fields_;
    ElidedLabel* report_ = nullptr;
};

} // namespace burin

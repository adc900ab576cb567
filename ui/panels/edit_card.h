// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <vector>

class QToolButton;

namespace burin {

class EditFieldEditor;
class ElidedLabel;
class NamedSwitch;

/// One edit of a path: its switch, its place in the order, its parameters and what it did.
class EditCard : public QFrame {
    Q_OBJECT
public:
    /// @param place in the path, from 0: part of the object names ("edit2Switch", "edit2_tolerance_mm", "edit2Earlier")
    EditCard(std::size_t place, const Edit& edit, QWidget* parent = nullptr);

    /// Shows values without a signal. The kind of edit must be the one it was made for. @param zero  mm, of the
    /// program, in the setup frame @param takes  whose names and times are told
    void showEdit(const Edit& edit, const glm::dvec3& zero, const std::vector<TakeInfo>& takes);
    /// What it did. @param report null: none (switched off, or not evaluated) @param zero as for showEdit
    void showReport(const EditReport* report, LengthUnit unit, const glm::dvec3& zero);
    void setUnit(LengthUnit unit);
    /// Whether the edit may go one place up, one down.
    void setMovable(bool earlier, bool later);
    void setDrawing(std::string_view key); ///< the parameter that is being drawn; empty: none
    std::string_view kind() const { return idOf(edit_.parameters); }

signals:
    void edited(const burin::Edit& edit);
    void moveRequested(int by); ///< -1: one place earlier, 1: one later
    void removalRequested();
    void drawingWanted(const QString& key, bool wanted); ///< of a parameter
    void placeWanted(const glm::dvec3& place);           ///< mm, setup frame: where its error is the largest

private:
    void addHead(const QString& name);
    void addFields(const QString& name);

    Edit edit_;
    glm::dvec3 zero_{0.0};
    std::vector<TakeInfo> takes_;
    NamedSwitch* switch_ = nullptr;
    QToolButton *earlier_ = nullptr, *later_ = nullptr, *worst_ = nullptr;
    glm::dvec3 worstPlace_{0.0}; ///< mm, setup frame
    std::vector<EditFieldEditor*> fields_;
    ElidedLabel* report_ = nullptr;
};

} // namespace burin

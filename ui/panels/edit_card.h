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

/// One edit of a path: its switch, its position in the order, its parameters and its effect.
class EditCard : public QFrame {
    Q_OBJECT
public:
    /// @param place index in the path's list of edits, from 0: part of the object names ("edit2Switch",
    /// "edit2_tolerance_mm", "edit2Earlier")
    EditCard(std::size_t place, const Edit& edit, QWidget* parent = nullptr);

    /// Shows values without emitting a signal. The edit must be of the same kind as the one passed to the constructor.
    /// @param zero program zero, mm, setup frame @param takes whose names and times are shown
    void showEdit(const Edit& edit, const glm::dvec3& zero, const std::vector<TakeInfo>& takes);
    /// Shows the effect of the edit. @param report null: none (switched off, or not evaluated) @param zero as for
    /// showEdit
    void showReport(const EditReport* report, LengthUnit unit, const glm::dvec3& zero);
    void setUnit(LengthUnit unit);
    /// Whether the edit can move up and down by one position.
    void setMovable(bool earlier, bool later);
    void setDrawing(std::string_view key); ///< the parameter that is being drawn in the view; empty: none
    std::string_view kind() const { return idOf(edit_.parameters); }

signals:
    void edited(const burin::Edit& edit);
    void moveRequested(int by); ///< -1: one position earlier, 1: one later
    void removalRequested();
    void drawingRequested(const QString& key, bool wanted); ///< of a parameter
    void placeRequested(const glm::dvec3& place); ///< the point with the edit's largest error, mm, setup frame

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

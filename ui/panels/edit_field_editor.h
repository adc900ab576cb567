// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/edit_parameters.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QToolButton;

namespace burin {

class ChoiceBox;
class ElidedLabel;
class QuantityField;

/// One parameter of an edit: a field for a number, three for a point, a switch or a choice. A moment or interval of the
/// recording is shown as text and can't be typed; lists of points are drawn in the view, as a mirror plane may be.
class EditFieldEditor : public QWidget {
    Q_OBJECT
public:
    /// @param name object name of the field; the names of the three fields of a point end in "X", "Y", "Z"
    /// @param accessible the accessible name
    EditFieldEditor(const EditParameter& parameter, const QString& name, const QString& accessible,
                    QWidget* parent = nullptr);

    void showParameter(const EditParameter& parameter); ///< another value of the same parameter; emits no signal
    void setUnit(LengthUnit unit);
    void setDrawing(bool drawing); ///< whether the parameter is being drawn in the view

signals:
    void edited(const burin::EditValue& value);
    void drawingRequested(bool wanted);

private:
    void addNumber(const EditParameter& parameter, const QString& name, const QString& accessible);
    void addSwitch(const EditParameter& parameter, const QString& name);
    void addChoice(const EditParameter& parameter, const QString& name);
    void addPlace(const EditParameter& parameter, const QString& name, const QString& accessible);
    void addText(const EditParameter& parameter, const QString& name);
    void addPlaces(const EditParameter& parameter, const QString& name, const QString& accessible);
    void showValue(const EditValue& value);
    QWidget* besideDrawing(QWidget* value, const QString& name, const QString& accessible);

    QuantityField* number_ = nullptr;
    QCheckBox* switch_ = nullptr;
    ChoiceBox* choice_ = nullptr;
    ElidedLabel* text_ = nullptr;
    QToolButton* draw_ = nullptr;
    std::array<QuantityField*, 3> place_{};
    std::span<const EditChoice> choices_;
    EditValue value_;
    glm::dvec3 zero_{0.0}; ///< see EditParameter
};

} // namespace burin

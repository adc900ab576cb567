// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "core/volume/runs/property_list.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <vector>

class QLineEdit;

namespace burin {

class ChoiceBox;
class FieldRow;
class LengthField;
class QuantityField;

/// One layer of the stock: name, material, bounding planes, and how its value varies with position.
class LayerFields : public QWidget {
    Q_OBJECT
public:
    explicit LayerFields(QWidget* parent = nullptr);
    /// Never emits. @param within mm: the box whose limits are shown for sides without a plane
    void showLayer(const MaterialRegion& layer, const std::vector<Property>& materials, const Box& within, bool locked);
    void setUnit(LengthUnit unit);

signals:
    void edited(const burin::MaterialRegion& layer);

private:
    enum class Kind { uniform, formula, table };
    QLineEdit* addText(const QString& label, const QString& toolTip, const char* name, FieldRow** row = nullptr);
    ChoiceBox* addChoice(const QString& label, const QString& toolTip, const char* name, FieldRow** row = nullptr);
    LengthField* addPlane(const QString& label, const char* name, double MaterialRegion::*plane);
    void addGrade();
    void chooseKind(int kind);
    void takeFormula();
    void offerValues(const std::vector<Property>& materials);
    Kind kind() const;

    MaterialRegion layer_;
    Box within_;
    QLineEdit *name_, *formula_;
    ChoiceBox *material_, *axis_, *kind_, *value_, *gradeAxis_;
    LengthField *from_, *to_;
    QuantityField* bands_;
    FieldRow *valueRow_, *formulaRow_, *gradeAxisRow_, *bandsRow_;
};

} // namespace burin

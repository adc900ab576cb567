// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/layer_fields.h"

#include "core/base/numbers.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"
#include "ui/panels/texts.h"

#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double farthestLayer = 10'000.0; // mm

/// Parses "0 0.2; 40 0.6". Invalid numbers are left to the check of the layer to reject.
std::vector<Grading::Control> tableOf(const QString& text) {
    std::vector<Grading::Control> table;
    for (const QString& line : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        const QStringList numbers = line.simplified().split(QLatin1Char(' '));
        const auto number = [&](qsizetype i) {
            const std::optional<double> read =
                i < numbers.size() ? parseNumber(numbers[i].toStdString()) : std::nullopt;
            return read.value_or(std::nan(""));
        };
        table.push_back({number(0), number(1)});
    }
    return table;
}

QString textOf(const std::vector<Grading::Control>& table) {
    QStringList lines;
    for (const Grading::Control& control : table)
        lines.append(QString::fromStdString(formatShortest(control.distance) + " " + formatShortest(control.value)));
    return lines.join(QStringLiteral("; "));
}

} // namespace

LayerFields::LayerFields(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    name_ = addText(tr("Name"), tr("Name of the layer, each once"), "layerName");
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        const std::string typed = name_->text().trimmed().toStdString();
        if (typed == layer_.name) return;
        layer_.name = typed;
        emit edited(layer_);
    });
    material_ = addChoice(tr("Material"), tr("Material of the layer"), "layerMaterial");
    connect(material_, &QComboBox::activated, this, [this] {
        layer_.material = material_->currentData().toString().toStdString();
        emit edited(layer_);
    });
    axis_ = addChoice(tr("Across"), tr("Axis that both planes of the layer stand across"), "layerAxis");
    connect(axis_, &QComboBox::activated, this, [this](int axis) {
        layer_.axis = axis;
        layer_.from = -std::numeric_limits<double>::infinity();
        layer_.to = std::numeric_limits<double>::infinity();
        emit edited(layer_);
    });
    for (int axis = 0; axis < 3; ++axis) axis_->addItem(axisLetter(axis));
    from_ = addPlane(tr("From"), "layerFrom", &MaterialRegion::from);
    to_ = addPlane(tr("To"), "layerTo", &MaterialRegion::to);
    addGrade();
}

QLineEdit* LayerFields::addText(const QString& label, const QString& toolTip, const char* name, FieldRow** row) {
    auto* field = new QLineEdit(this);
    field->setObjectName(QLatin1String(name));
    auto* made = new FieldRow(label, field, toolTip, this, FieldRow::choiceWidth);
    layout()->addWidget(made);
    if (row != nullptr) *row = made;
    return field;
}

ChoiceBox* LayerFields::addChoice(const QString& label, const QString& toolTip, const char* name, FieldRow** row) {
    auto* field = new ChoiceBox(this);
    field->setObjectName(QLatin1String(name));
    auto* made = new FieldRow(label, field, toolTip, this, FieldRow::choiceWidth);
    layout()->addWidget(made);
    if (row != nullptr) *row = made;
    return field;
}

LengthField* LayerFields::addPlane(const QString& label, const char* name, double MaterialRegion::*plane) {
    auto* field = new LengthField(this);
    field->setObjectName(QLatin1String(name));
    field->limit(-farthestLayer, farthestLayer);
    layout()->addWidget(new FieldRow(label, field, tr("Position of the plane, in the model's frame"), this));
    connect(field, &LengthField::valueEdited, this, [this, plane](double value) {
        layer_.*plane = value;
        emit edited(layer_);
    });
    return field;
}

void LayerFields::addGrade() {
    kind_ = addChoice(tr("Its values"), tr("The same everywhere, or changing from place to place"), "layerGrade");
    kind_->addItems({tr("The same everywhere"), tr("By a formula"), tr("By a table")}); // in the order of Kind
    connect(kind_, &QComboBox::activated, this, &LayerFields::chooseKind);
    value_ = addChoice(tr("What changes"), tr("Value of the material that changes"), "gradeValue", &valueRow_);
    connect(value_, &QComboBox::activated, this, [this] {
        layer_.grade->value = value_->currentData().toString().toStdString();
        emit edited(layer_);
    });
    gradeAxis_ = addChoice(tr("Along"), tr("Axis that the positions of the table lie on"), "gradeAxis", &gradeAxisRow_);
    for (int axis = 0; axis < 3; ++axis) gradeAxis_->addItem(axisLetter(axis));
    connect(gradeAxis_, &QComboBox::activated, this, [this](int axis) {
        layer_.grade->axis = axis;
        emit edited(layer_);
    });
    formula_ = addText(tr("Formula"),
                       tr("Of X, Y and Z in mm, as 0.4 + 0.02 * Z; or a table: position value; position value; …"),
                       "gradeFormula", &formulaRow_);
    connect(formula_, &QLineEdit::editingFinished, this, &LayerFields::takeFormula);
    bands_ = new QuantityField(Quantity::count, this);
    bands_->setObjectName(QStringLiteral("gradeBands"));
    bands_->limit(1, maximumGrades);
    bandsRow_ = new FieldRow(tr("Bands"), bands_, tr("Equally high bands that the values are sorted into"), this);
    layout()->addWidget(bandsRow_);
    connect(bands_, &QuantityField::valueEdited, this, [this](double value) {
        layer_.grade->entries = static_cast<int>(std::lround(value));
        emit edited(layer_);
    });
}

LayerFields::Kind LayerFields::kind() const {
    if (!layer_.grade) return Kind::uniform;
    return layer_.grade->formula.empty() ? Kind::table : Kind::formula;
}

/// A new grade starts with values that can be embedded, and is edited from there.
void LayerFields::chooseKind(int kind) {
    const auto wanted = static_cast<Kind>(kind);
    if (wanted == this->kind()) return;
    if (wanted == Kind::uniform) {
        layer_.grade.reset();
    } else {
        RegionGrade grade = layer_.grade.value_or(RegionGrade{});
        const double low = std::max(layer_.from, within_.low[layer_.axis]);
        const double high = std::min(layer_.to, within_.high[layer_.axis]);
        grade.axis = layer_.axis;
        grade.table = wanted == Kind::table ? std::vector<Grading::Control>{{low, 0.1}, {high, 0.2}}
                                            : std::vector<Grading::Control>{};
        const std::string from = formatShortest(std::round(low * 1e3) / 1e3);
        grade.formula = wanted == Kind::formula
                            ? "0.1 + 0.01 * (" + axisLetter(layer_.axis).toUpper().toStdString() + " - (" + from + "))"
                            : std::string();
        layer_.grade = grade;
    }
    emit edited(layer_);
}

void LayerFields::takeFormula() {
    if (!layer_.grade) return;
    RegionGrade grade = *layer_.grade;
    if (kind() == Kind::table)
        grade.table = tableOf(formula_->text());
    else
        grade.formula = formula_->text().trimmed().toStdString();
    if (grade == *layer_.grade) return;
    if (kind() == Kind::formula && grade.formula.empty()) { // an empty formula would mean a table
        formula_->setText(QString::fromStdString(layer_.grade->formula));
        return;
    }
    layer_.grade = grade;
    emit edited(layer_);
}

void LayerFields::offerValues(const std::vector<Property>& materials) {
    QStringList names, ids;
    const auto material = std::ranges::find(materials, layer_.material, &Property::id);
    if (material != materials.end())
        for (const auto& [name, value] : material->values) {
            names.append(valueNameText(name));
            ids.append(QString::fromStdString(name));
        }
    value_->offer(names, ids, layer_.grade ? QString::fromStdString(layer_.grade->value) : QString());
}

void LayerFields::showLayer(const MaterialRegion& layer, const std::vector<Property>& materials, const Box& within,
                            bool locked) {
    layer_ = layer;
    within_ = within;
    if (!name_->hasFocus() || !name_->isModified()) name_->setText(QString::fromStdString(layer.name));
    QStringList names, ids;
    for (const Property& material : materials) {
        names.append(materialName(material));
        ids.append(QString::fromStdString(material.id));
    }
    material_->offer(names, ids, QString::fromStdString(layer.material));
    axis_->setCurrentIndex(layer.axis);
    from_->showValue(std::isfinite(layer.from) ? layer.from : within.low[layer.axis]);
    to_->showValue(std::isfinite(layer.to) ? layer.to : within.high[layer.axis]);
    kind_->setCurrentIndex(static_cast<int>(kind()));
    offerValues(materials);
    if (layer.grade) {
        gradeAxis_->setCurrentIndex(layer.grade->axis);
        const QString text =
            kind() == Kind::table ? textOf(layer.grade->table) : QString::fromStdString(layer.grade->formula);
        if (!formula_->hasFocus() || !formula_->isModified()) formula_->setText(text);
        bands_->showValue(layer.grade->entries);
    }
    for (FieldRow* row : {valueRow_, formulaRow_, bandsRow_}) row->setVisible(layer.grade.has_value());
    gradeAxisRow_->setVisible(kind() == Kind::table);
    for (QWidget* field : std::initializer_list<QWidget*>{name_, material_, axis_, from_, to_, kind_, value_,
                                                          gradeAxis_, formula_, bands_})
        setEnabledKeepingFocus(field, !locked);
}

void LayerFields::setUnit(LengthUnit unit) {
    from_->setLengthUnit(unit);
    to_->setLengthUnit(unit);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/stock_shape_fields.h"

#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/role_labels.h"

#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double farthestCorner = 10'000.0, smallestSize = 0.01; // mm
constexpr int aslant = 3;                                        // index in the axis choice: none of x, y, z

} // namespace

StockShapeFields::StockShapeFields(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    form_ = new ChoiceBox(this);
    form_->setObjectName(QStringLiteral("stockForm"));
    for (const StockForm form : stockForms) form_->addItem(stockFormText(form));
    column->addWidget(new FieldRow(
        tr("Shape"), form_, tr("A box, a round bar, the bodies of the model whose role is stock, or what a file holds"),
        this, FieldRow::choiceWidth));
    connect(form_, &QComboBox::activated, this,
            [this](int index) { chooseForm(stockForms[static_cast<std::size_t>(index)]); });
    addFileRow();
    axis_ = new ChoiceBox(this);
    axis_->setObjectName(QStringLiteral("stockAxis"));
    for (int axis = 0; axis < 3; ++axis) axis_->addItem(axisLetter(axis));
    axisRow_ = new FieldRow(tr("Axis"), axis_, tr("Direction that the axis of the cylinder lies in"), this,
                            FieldRow::choiceWidth);
    column->addWidget(axisRow_);
    connect(axis_, &QComboBox::activated, this, &StockShapeFields::chooseAxis);
    stated_ =
        new NamedSwitch(QStringLiteral("stockStated"),
                        tr("On: the stock is where it is stated, whatever the part. Off: it lies around the part, "
                           "with margins"),
                        this);
    column->addWidget(stated_);
    connect(stated_, &NamedSwitch::switched, this, [this](bool on) {
        setup_.stated = on;
        emit edited(setup_);
    });
    addBoxFields();
    addCylinderFields();
    freeCarving_ = new NamedSwitch(QStringLiteral("freeCarving"),
                                   tr("On: no part is needed. Where there is none nothing pushes the tool back"), this);
    column->addWidget(freeCarving_);
    connect(freeCarving_, &NamedSwitch::switched, this, [this](bool on) {
        setup_.freeCarving = on;
        emit edited(setup_);
    });
}

void StockShapeFields::addFileRow() {
    file_ = new QPushButton(this);
    file_->setObjectName(QStringLiteral("stockFile"));
    fileRow_ =
        new FieldRow(tr("File"), file_, tr("Read the stock from another volume file, voxel array (a scan) or model"),
                     this, FieldRow::choiceWidth);
    layout()->addWidget(fileRow_);
    connect(file_, &QPushButton::clicked, this, &StockShapeFields::fileRequested);
}

void StockShapeFields::chooseForm(StockForm form) {
    if (form == StockForm::file && !setup_.volume) {
        form_->setCurrentIndex(static_cast<int>(setup_.form)); // until a file has been read
        emit fileRequested();
        return;
    }
    setup_.form = form;
    if (form == StockForm::solids || form == StockForm::file) setup_.stated = false;
    emit edited(setup_);
}

void StockShapeFields::addField(StockForm form, const QString& label, const char* name, double least, Get get,
                                Set set) {
    auto* field = new LengthField(this);
    field->setObjectName(QLatin1String(name));
    field->limit(least, farthestCorner);
    auto* row = new FieldRow(label, field, tr("In the model's frame"), this);
    layout()->addWidget(row);
    connect(field, &LengthField::valueEdited, this, [this, set = std::move(set)](double value) {
        set(setup_, value);
        emit edited(setup_);
    });
    fields_.push_back({field, row, form, std::move(get)});
}

void StockShapeFields::addBoxFields() {
    static constexpr std::array names{"stockLowX", "stockLowY", "stockLowZ", "stockHighX", "stockHighY", "stockHighZ"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int axis = static_cast<int>(i % 3);
        const bool high = i >= 3;
        addField(
            StockForm::box, (high ? tr("To %1") : tr("From %1")).arg(axisLetter(axis)), names[i], -farthestCorner,
            [axis, high](const Setup& setup) { return (high ? setup.stock.high : setup.stock.low)[axis]; },
            [axis, high](Setup& setup, double value) { (high ? setup.stock.high : setup.stock.low)[axis] = value; });
    }
}

void StockShapeFields::addCylinderFields() {
    static constexpr std::array names{"stockBaseX", "stockBaseY", "stockBaseZ"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int axis = static_cast<int>(i);
        addField(
            StockForm::cylinder, tr("Middle of its end, %1").arg(axisLetter(axis)), names[i], -farthestCorner,
            [axis](const Setup& setup) { return setup.cylinder.base[axis]; },
            [axis](Setup& setup, double value) { setup.cylinder.base[axis] = value; });
    }
    addField(
        StockForm::cylinder, tr("Radius"), "stockRadius", smallestSize,
        [](const Setup& setup) { return setup.cylinder.radius; },
        [](Setup& setup, double value) { setup.cylinder.radius = value; });
    addField(
        StockForm::cylinder, tr("Length"), "stockLength", smallestSize,
        [](const Setup& setup) { return setup.cylinder.height; },
        [](Setup& setup, double value) { setup.cylinder.height = value; });
}

void StockShapeFields::chooseAxis(int axis) {
    if (axis == aslant) return;
    setup_.cylinder.axis = glm::dvec3(0.0);
    setup_.cylinder.axis[axis] = 1.0;
    emit edited(setup_);
}

/// The axis may be none of x, y, z, because the command line accepts any direction.
int StockShapeFields::axisChosen() const {
    for (int axis = 0; axis < 3; ++axis)
        if (setup_.cylinder.axis[axis] == 1.0) return axis;
    return aslant;
}

void StockShapeFields::showSetup(const Setup& setup, bool locked) {
    setup_ = setup;
    const bool cylinder = setup.form == StockForm::cylinder;
    form_->setCurrentIndex(static_cast<int>(setup.form));
    const int axis = axisChosen();
    while (axis_->count() > aslant && axis != aslant) axis_->removeItem(aslant);
    if (axis == aslant && axis_->count() == aslant) axis_->addItem(tr("Another direction"));
    axis_->setCurrentIndex(axis);
    axisRow_->setVisible(cylinder);
    stated_->show(tr("At a stated place"), setup.stated, {});
    stated_->setVisible(setup.form == StockForm::box || cylinder);
    const bool file = setup.form == StockForm::file && setup.volume;
    fileRow_->setVisible(file);
    if (file) {
        constexpr int frame = 28; // of the button, px
        const QString name = QString::fromStdString(setup.volume->name());
        file_->setText(file_->fontMetrics().elidedText(name, Qt::ElideMiddle, FieldRow::choiceWidth - frame));
        file_->setAccessibleName(name);
    }
    freeCarving_->show(tr("Free carving"), setup.freeCarving, {});
    for (const Field& each : fields_) {
        each.row->setVisible(setup.stated && each.form == setup.form);
        each.field->showValue(each.get(setup));
        setEnabledKeepingFocus(each.field, !locked);
    }
    for (QWidget* widget : {static_cast<QWidget*>(form_), static_cast<QWidget*>(axis_), static_cast<QWidget*>(stated_),
                            static_cast<QWidget*>(freeCarving_), static_cast<QWidget*>(file_)})
        setEnabledKeepingFocus(widget, !locked);
}

void StockShapeFields::setUnit(LengthUnit unit) {
    for (const Field& each : fields_) each.field->setLengthUnit(unit);
}

} // namespace burin

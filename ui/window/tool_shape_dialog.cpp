// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/tool_shape_dialog.h"

#include "core/base/units.h"
#include "core/tool/tool_ranges.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/count_field.h"
#include "ui/panels/field_row.h"
#include "ui/panels/file_units.h"
#include "ui/panels/length_field.h"
#include "ui/panels/quantity_field.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>

namespace burin {

namespace {

constexpr int dialogWidth = 520; // pixels

} // namespace

ToolShapeDialog::ToolShapeDialog(const Tool& like, const QString& folder, LengthUnit unit, QWidget* parent)
    : QDialog(parent), like_(like), folder_(folder) {
    setObjectName(QStringLiteral("toolShapeDialog"));
    setWindowTitle(tr("Tool from models"));
    layOut(unit);
    setFixedWidth(dialogWidth);
    update();
    flutes_.button->setFocus();
}

void ToolShapeDialog::layOut(LengthUnit unit) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    auto* about = new QLabel(
        tr("A tool that turns cuts what its flutes sweep with the spindle; one that doesn't turn cuts what its "
           "models sweep. Models have their axis along +Z, through the origin, towards the holder; their "
           "lowest point becomes the tip. Teeth, limits and holder are those of “%1”.")
            .arg(QCoreApplication::translate("Resource", like_.name.c_str())),
        this);
    about->setWordWrap(true);
    column->addWidget(about);
    flutes_ = addFile(tr("Flutes"), tr("One or more closed bodies: STEP, IGES, BREP, or a mesh"),
                      QStringLiteral("flutesFileButton"));
    shank_ = addFile(tr("Shank"), tr("The same of the shank; without it the new tool has the shank of the other"),
                     QStringLiteral("shankFileButton"));
    unit_ = new ChoiceBox(this);
    unit_->setObjectName(QStringLiteral("toolUnit"));
    addFileUnits(*unit_);
    layout()->addWidget(
        new FieldRow(tr("Unit of the files"), unit_, tr("An STL file states no unit"), this, FieldRow::choiceWidth));
    name_ = new QLineEdit(this);
    name_->setObjectName(QStringLiteral("toolName"));
    column->addWidget(new FieldRow(tr("Name"), name_, tr("What the tool is called"), this, FieldRow::choiceWidth));
    number_ = new CountField(1, tool_range::highestNumber, like_.number, this);
    number_->setObjectName(QStringLiteral("toolNumber"));
    column->addWidget(new FieldRow(tr("Number"), number_, tr("T in programs"), this));
    motion_ = new ChoiceBox(this);
    motion_->setObjectName(QStringLiteral("toolMotion"));
    motion_->addItems({tr("Turns with the spindle"), tr("Doesn't turn: scraper, planing blade")});
    column->addWidget(new FieldRow(
        tr("Motion"), motion_,
        tr("A tool that doesn't turn cuts what its models sweep; their profile only keeps them out of the part"), this,
        FieldRow::choiceWidth));
    direction_ = new QuantityField(Quantity::angle, this);
    direction_->setObjectName(QStringLiteral("toolDirection"));
    direction_->limit(-2.0 * pi, 2.0 * pi);
    direction_->showValue(0.0);
    column->addWidget(new FieldRow(tr("Direction"), direction_,
                                   tr("About the axis: from X of the setup to X of the models, counterclockwise seen "
                                      "from above"),
                                   this));
    tolerance_ = new LengthField(this);
    tolerance_->setObjectName(QStringLiteral("profileTolerance"));
    tolerance_->setLengthUnit(unit);
    tolerance_->limit(1e-4, 1.0);
    tolerance_->showValue(ToolShapeRequest{}.tolerance);
    column->addWidget(
        new FieldRow(tr("Tolerance"), tolerance_,
                     tr("How much wider than the model the profile of the tool may be; it is never narrower"), this));
    make_ = makePrimaryButton(tr("Make the tool"), QStringLiteral("makeToolButton"), this);
    auto* cancel = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelToolButton"), this);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(make_);
    row->addWidget(cancel);
    column->addLayout(row);
    connect(flutes_.button, &QPushButton::clicked, this, [this] { choose(flutes_, tr("Flutes")); });
    connect(shank_.button, &QPushButton::clicked, this, [this] { choose(shank_, tr("Shank")); });
    connect(name_, &QLineEdit::textChanged, this, &ToolShapeDialog::update);
    connect(motion_, &QComboBox::currentIndexChanged, this, &ToolShapeDialog::update);
    connect(make_, &QPushButton::clicked, this, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

ToolShapeDialog::FileChoice ToolShapeDialog::addFile(const QString& label, const QString& toolTip,
                                                     const QString& objectName) {
    auto* button = makeButton(tr("Choose a file…"), QStringLiteral("import"), objectName, this);
    layout()->addWidget(new FieldRow(label, button, toolTip, this, FieldRow::choiceWidth));
    return {button, {}};
}

void ToolShapeDialog::choose(FileChoice& choice, const QString& title) {
    const QString file = askToolModel(this, folder_, title);
    if (file.isEmpty()) return;
    choice.file = file;
    folder_ = QFileInfo(file).absolutePath();
    constexpr int frame = 60; // of the button, with its icon, px
    choice.button->setText(choice.button->fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle,
                                                                   FieldRow::choiceWidth - frame));
    if (&choice == &flutes_ && name_->text().isEmpty()) name_->setText(QFileInfo(file).completeBaseName());
    update();
}

void ToolShapeDialog::update() {
    const auto isStl = [](const FileChoice& choice) {
        return choice.file.endsWith(QLatin1String(".stl"), Qt::CaseInsensitive);
    };
    direction_->setEnabled(motion_->currentIndex() == 1);
    unit_->setEnabled(isStl(flutes_) || isStl(shank_)); // other formats state their unit
    enableUnless(make_,
                 flutes_.file.isEmpty()              ? tr("Choose a model of the flutes first.")
                 : name_->text().trimmed().isEmpty() ? tr("Give the tool a name first.")
                                                     : QString(),
                 tr("Add the tool to your own and load it into the spindle; Undo takes it back"));
}

ToolShapeRequest ToolShapeDialog::request() const {
    ToolShapeRequest request;
    request.flutes = flutes_.file.toStdString();
    request.shank = shank_.file.toStdString();
    request.like = like_;
    request.like.number = number_->value();
    request.name = name_->text().trimmed().toStdString();
    request.tolerance = tolerance_->value();
    request.turns = motion_->currentIndex() == 0;
    request.angle = request.turns ? 0.0 : direction_->value();
    request.import.fileUnit = unit_->currentData().toDouble();
    return request;
}

} // namespace burin

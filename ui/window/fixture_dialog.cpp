// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/fixture_dialog.h"

#include "core/base/units.h"
#include "core/setup/fixture_library.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/fixture_drawing.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"

#include <QBoxLayout>
#include <QLabel>
#include <QScrollArea>

#include <cmath>

namespace burin {

namespace {

constexpr int fixtureDialogWidth = 400, sizesHeight = 160; // pixels
constexpr QSize kindPicture(40, 24);                       // pixels
constexpr double farthestPlace = 1e4;                      // mm
constexpr int smallAngle = 15, largeAngle = 90;            // degrees

} // namespace

FixtureDialog::FixtureDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("fixtureDialog"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    addKind(*column);
    addSizes(*column);
    addPosition(*column);
    addTurns(*column);
    auto* hint = new QLabel(tr("Click the stock or the table in the view, or drag, to place it. In the view, the arrow "
                               "keys move it by 1 mm (Shift: 0.1 mm, Ctrl: 10 mm), R rotates it by 15° (Shift: 90°), "
                               "Enter accepts it."),
                            this);
    hint->setProperty("look", "small");
    hint->setWordWrap(true);
    column->addWidget(hint);
    auto* notices = new NoticePlace(this);
    notice_ = notices->add("fixtureNotice");
    column->addWidget(notices);
    addButtons(*column);
    setFixedWidth(fixtureDialogWidth);
    installEventFilter(this);
}

void FixtureDialog::addKind(QVBoxLayout& column) {
    kind_ = new ChoiceBox(this);
    kind_->setObjectName(QStringLiteral("fixtureKind"));
    for (const FixtureKindRow& row : fixtureKinds) {
        kind_->addItem(Messages::text(row.title));
        kind_->setItemData(kind_->count() - 1, Messages::text(row.toolTip), Qt::ToolTipRole);
    }
    kind_->setIconSize(kindPicture);
    paintKinds();
    column.addWidget(
        new FieldRow(tr("Kind"), kind_, tr("Kind of fixture of the library"), this, FieldRow::choiceWidth));
    connect(kind_, &QComboBox::activated, this,
            [this](int index) { emit kindChosen(fixtureKinds[static_cast<std::size_t>(index)].kind); });
    about_ = new QLabel(this);
    about_->setProperty("look", "quiet");
    about_->setWordWrap(true);
    column.addWidget(about_);
    drawing_ = new FixtureDrawing(this);
    drawing_->setObjectName(QStringLiteral("fixtureDrawing"));
    column.addWidget(drawing_);
}

void FixtureDialog::paintKinds() {
    for (int i = 0; i < kind_->count(); ++i)
        kind_->setItemIcon(
            i, fixturePicture(fixtureKinds[static_cast<std::size_t>(i)].kind, kindPicture, devicePixelRatioF()));
}

/// The drawing marks the size whose field has the focus; after a change of theme, the list shows the new colours.
bool FixtureDialog::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        for (std::size_t i = 0; i < values_.size(); ++i)
            if (watched == values_[i])
                drawing_->mark(event->type() == QEvent::FocusIn ? std::optional(i) : std::nullopt);
    if (watched == this && event->type() == QEvent::PaletteChange) paintKinds();
    return QDialog::eventFilter(watched, event);
}

void FixtureDialog::addSizes(QVBoxLayout& column) {
    auto* area = new QScrollArea(this);
    area->setObjectName(QStringLiteral("fixtureSizes"));
    area->setAccessibleName(tr("Sizes of the fixture"));
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFixedHeight(sizesHeight);
    sizes_ = new QWidget(area);
    new QVBoxLayout(sizes_);
    area->setWidget(sizes_);
    column.addWidget(area);
}

void FixtureDialog::addPosition(QVBoxLayout& column) {
    placeTitle_ = new QLabel(this);
    placeTitle_->setProperty("look", "quiet");
    column.addWidget(placeTitle_);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new LengthField(this);
        field->setObjectName(QStringLiteral("fixturePlace") + axisLetter(axis));
        field->setAccessibleName(tr("Position") + QLatin1Char(' ') + axisLetter(axis));
        field->setToolTip(tr("Origin of the fixture, from program zero"));
        field->limit(-farthestPlace, farthestPlace);
        field->setMinimumWidth(40);
        row->addWidget(field, 1);
        place_[static_cast<std::size_t>(axis)] = field;
        connect(field, &QuantityField::valueEdited, this, [this, axis](double value) {
            glm::dvec3 place = state_.design.place;
            place[axis] = value + state_.zero[axis];
            emit placeEdited(place);
        });
    }
    column.addLayout(row);
}

void FixtureDialog::addTurns(QVBoxLayout& column) {
    turn_ = new QuantityField(Quantity::angle, this);
    turn_->setObjectName(QStringLiteral("fixtureTurn"));
    turn_->limit(-pi, pi);
    column.addWidget(new FieldRow(tr("Rotation"), turn_, tr("About Z, through its origin"), this));
    connect(turn_, &QuantityField::valueEdited, this, &FixtureDialog::turnEdited);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (const int angle : {-largeAngle, -smallAngle, smallAngle, largeAngle}) {
        QPushButton* button =
            makeButton(QStringLiteral("%1%2°").arg(angle > 0 ? QStringLiteral("+") : QStringLiteral("−"),
                                                   QString::number(std::abs(angle))),
                       {}, QStringLiteral("fixtureTurn%1").arg(angle), this);
        button->setToolTip(tr("Rotate it about Z"));
        button->setAutoDefault(false);
        row->addWidget(button, 1);
        connect(button, &QPushButton::clicked, this,
                [this, angle] { emit turnedBy(glm::radians(static_cast<double>(angle))); });
    }
    column.addLayout(row);
}

void FixtureDialog::addButtons(QVBoxLayout& column) {
    accept_ = makePrimaryButton({}, QStringLiteral("acceptFixtureButton"), this);
    QPushButton* cancel =
        makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelFixtureButton"), this);
    cancel->setToolTip(tr("Change nothing"));
    for (QPushButton* button : {accept_, cancel}) button->setAutoDefault(false); // Enter is the fields'
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(accept_);
    row->addWidget(cancel);
    column.addLayout(row);
    connect(accept_, &QPushButton::clicked, this, &FixtureDialog::acceptRequested);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

void FixtureDialog::rebuildSizes(FixtureKind kind) {
    values_.clear();
    drawing_->mark({});
    auto* column = static_cast<QVBoxLayout*>(sizes_->layout());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    while (QLayoutItem* item = column->takeAt(0)) {
        if (QWidget* row = item->widget()) {
            row->hide();
            row->deleteLater(); // one of its fields may be emitting
        }
        delete item;
    }
    for (const FixtureParameter& parameter : rowOf(kind).parameters) {
        auto* field = new LengthField(sizes_);
        field->setObjectName(QStringLiteral("fixture-") + QLatin1String(parameter.key));
        field->limit(parameter.range.low, parameter.range.high);
        const std::size_t index = values_.size();
        connect(field, &QuantityField::valueEdited, this,
                [this, index](double value) { emit valueEdited(index, value); });
        field->installEventFilter(this);
        column->addWidget(
            new FieldRow(QStringLiteral("%1  %2").arg(measureLetter(index), Messages::text(parameter.label)), field,
                         Messages::text(parameter.toolTip), sizes_));
        values_.push_back(field);
    }
    column->addStretch(1);
    built_ = kind;
}

void FixtureDialog::setState(const FixtureDialogState& state) {
    state_ = state;
    const FixtureDesign& design = state.design;
    if (built_ != design.kind) rebuildSizes(design.kind);
    setWindowTitle(state.changing ? tr("Change a fixture") : tr("Add a fixture"));
    kind_->setCurrentIndex(static_cast<int>(design.kind));
    kind_->setEnabled(!state.changing);
    about_->setText(Messages::text(rowOf(design.kind).toolTip));
    for (std::size_t i = 0; i < values_.size(); ++i) {
        values_[i]->setLengthUnit(state.unit);
        values_[i]->showValue(design.values[i]);
    }
    drawing_->setUnit(state.unit);
    drawing_->setDesign(checkFixture(design) ? std::optional(design) : std::nullopt);
    placeTitle_->setText(tr("%1 X, Y, Z, in %2").arg(tr("Position"), unitText(state.unit)));
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto axis = static_cast<int>(i);
        place_[i]->setLengthUnit(state.unit);
        place_[i]->setSuffix({}); // three fields side by side have no room for it
        place_[i]->showValue(design.place[axis] - state.zero[axis]);
    }
    turn_->showValue(design.turn);
    accept_->setText(state.changing ? tr("Change") : tr("Add"));
    enableUnless(accept_, state.problem,
                 state.changing ? tr("Change the fixture of the setup") : tr("Add the fixture to the setup"));
    if (state.problem.isEmpty() && state.gap > 0.0)
        notice_->tell(Notice::Kind::warning, std::isinf(state.gap)
                                                 ? tr("There is no stock where the fixture clamps.")
                                                 : tr("The fixture doesn't touch the stock: a gap of %1 remains.")
                                                       .arg(lengthText(state.gap, state.unit)));
    else
        notice_->tell(Notice::Kind::error, state.problem);
    if (isVisible()) fit(); // what is said about a kind takes one line or two
}

/// adjustSize would stop at two thirds of the screen.
void FixtureDialog::fit() {
    resize(width(), layout()->totalHeightForWidth(width()));
}

} // namespace burin

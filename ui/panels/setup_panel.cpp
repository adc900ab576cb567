// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/setup_panel.h"

#include "core/base/units.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/placement_labels.h"

#include <QLineEdit>

#include <array>
#include <utility>

namespace burin {

namespace {

constexpr std::array axisNames{"X", "Y", "Z"};
constexpr double farthestPlacement = 1e6; // mm

QString axisText(std::size_t axis) {
    return QString::fromLatin1(axisNames[axis]);
}

} // namespace

class SetupPanel::Fields : public QObject {
public:
    explicit Fields(SetupPanel* panel);
    void refresh();
    void setUnit(LengthUnit unit);

    SetupState state;

private:
    void makeSetups();
    void makeFaces();
    void makeTurns();
    void makePosition();
    QHBoxLayout* makeRow();
    void refreshSetups();
    void refreshPlacement();
    QString reasonAgainstPlacing() const;

    SetupPanel* panel_;
    QVBoxLayout* column_;
    ChoiceBox* setups_;
    QLineEdit* name_;
    QPushButton *add_, *remove_, *stock_;
    Notice *outOfDate_, *asked_;
    QLabel* lies_;
    std::array<QPushButton*, 4> aims_{}; ///< in the order of FaceAim, without `none`
    std::array<QPushButton*, 3> turns_{}, mirrors_{};
    ChoiceBox* turnAxis_;
    QuantityField* angle_;
    std::array<LengthField*, 3> position_{};
    LengthUnit unit_ = LengthUnit::millimetre;
};

SetupPanel::Fields::Fields(SetupPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    makeSetups();
    column_->addWidget(makeSectionTitle(SetupPanel::tr("Placement"), panel));
    lies_ = makeWrappedLabel(panel);
    lies_->setObjectName(QStringLiteral("placementText"));
    lies_->setProperty("look", "quiet");
    column_->addWidget(lies_);
    makeFaces();
    makeTurns();
    makePosition();
    column_->addStretch(1);
}

QHBoxLayout* SetupPanel::Fields::makeRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    column_->addLayout(row);
    return row;
}

void SetupPanel::Fields::makeSetups() {
    column_->addWidget(makeSectionTitle(SetupPanel::tr("Setup"), panel_));
    setups_ = new ChoiceBox(panel_);
    setups_->setObjectName(QStringLiteral("setupChoice"));
    setups_->setAccessibleName(SetupPanel::tr("Setup"));
    setups_->setToolTip(
        SetupPanel::tr("The current setup. Each setup has its own stock, fixtures, recordings, paths and programs"));
    column_->addWidget(setups_);
    connect(setups_, &QComboBox::activated, this, [this](int index) {
        if (index < 0 || static_cast<std::size_t>(index) >= state.setups.size()) return;
        emit panel_->setupChosen(numberOf(state.setups[static_cast<std::size_t>(index)].id));
    });
    name_ = new QLineEdit(panel_);
    name_->setObjectName(QStringLiteral("setupName"));
    name_->setMaxLength(60);
    column_->addWidget(
        new FieldRow(SetupPanel::tr("Name"), name_,
                     SetupPanel::tr("Name of this setup, shown in lists and in the file name of its program"), panel_,
                     FieldRow::choiceWidth));
    connect(name_, &QLineEdit::editingFinished, this, [this] { emit panel_->named(name_->text().trimmed()); });
    QHBoxLayout* row = makeRow();
    add_ = makeButton(SetupPanel::tr("Add…"), QStringLiteral("add"), QStringLiteral("addSetupButton"), panel_);
    remove_ =
        makeButton(SetupPanel::tr("Delete"), QStringLiteral("remove"), QStringLiteral("removeSetupButton"), panel_);
    row->addWidget(add_);
    row->addWidget(remove_);
    row->addStretch(1);
    connect(add_, &QPushButton::clicked, panel_, &SetupPanel::additionRequested);
    connect(remove_, &QPushButton::clicked, panel_, &SetupPanel::removalRequested);
    outOfDate_ = new Notice(panel_);
    outOfDate_->setObjectName(QStringLiteral("stockOutOfDate"));
    column_->addWidget(outOfDate_);
    stock_ = makeButton(SetupPanel::tr("Update the stock"), QStringLiteral("refresh"),
                        QStringLiteral("takeStockButton"), panel_);
    column_->addWidget(stock_);
    connect(stock_, &QPushButton::clicked, panel_, &SetupPanel::stockRequested);
}

void SetupPanel::Fields::makeFaces() {
    const std::array texts{std::pair(SetupPanel::tr("Face down"), "faceDownButton"),
                           std::pair(SetupPanel::tr("Face up"), "faceUpButton"),
                           std::pair(SetupPanel::tr("Along X"), "faceAlongXButton"),
                           std::pair(SetupPanel::tr("Along Y"), "faceAlongYButton")};
    for (std::size_t first : {0U, 2U}) {
        QHBoxLayout* row = makeRow();
        for (std::size_t i = first; i < first + 2; ++i) {
            const auto aim = static_cast<FaceAim>(i + 1);
            aims_[i] = makeChoiceButton(texts[i].first, {}, QString::fromLatin1(texts[i].second), panel_);
            row->addWidget(aims_[i], 1);
            connect(aims_[i], &QPushButton::clicked, this,
                    [this, aim](bool on) { emit panel_->facePickRequested(on ? aim : FaceAim::none); });
        }
    }
    asked_ = new Notice(panel_);
    asked_->setObjectName(QStringLiteral("facePickNotice"));
    column_->addWidget(asked_);
}

void SetupPanel::Fields::makeTurns() {
    QHBoxLayout* row = makeRow();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        turns_[axis] = makeButton(SetupPanel::tr("90° %1").arg(axisText(axis)), {},
                                  QStringLiteral("turn%1Button").arg(axisText(axis)), panel_);
        row->addWidget(turns_[axis], 1);
        connect(turns_[axis], &QPushButton::clicked, this,
                [this, axis] { emit panel_->turned(static_cast<int>(axis), 0.5 * pi); });
    }
    turnAxis_ = new ChoiceBox(panel_);
    turnAxis_->setObjectName(QStringLiteral("turnAxis"));
    turnAxis_->addItems({axisText(0), axisText(1), axisText(2)});
    turnAxis_->setCurrentIndex(2);
    column_->addWidget(
        new FieldRow(SetupPanel::tr("Rotation axis"), turnAxis_,
                     SetupPanel::tr("Axis of the rotation below; it passes through the centre of the part"), panel_,
                     FieldRow::choiceWidth));
    angle_ = new QuantityField(Quantity::angle, panel_);
    angle_->setObjectName(QStringLiteral("turnAngle"));
    angle_->limit(-pi, pi);
    column_->addWidget(new FieldRow(
        SetupPanel::tr("Rotate by"), angle_,
        SetupPanel::tr("Rotates the part by this angle. Positive: counter-clockwise, seen from the tip of the axis"),
        panel_));
    connect(angle_, &QuantityField::valueEdited, this, [this](double angle) {
        angle_->showValue(0.0); // it is a step, not a state
        if (angle != 0.0) emit panel_->turned(turnAxis_->currentIndex(), angle);
    });
}

void SetupPanel::Fields::makePosition() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        position_[axis] = new LengthField(panel_);
        position_[axis]->setObjectName(QStringLiteral("position%1").arg(axisText(axis)));
        position_[axis]->limit(-farthestPlacement, farthestPlacement);
        column_->addWidget(new FieldRow(
            SetupPanel::tr("Lower corner %1").arg(axisText(axis)), position_[axis],
            SetupPanel::tr("Lower corner of the part's bounding box. A new value moves the part"), panel_));
        connect(position_[axis], &QuantityField::valueEdited, this,
                [this, axis](double place) { emit panel_->positioned(static_cast<int>(axis), place); });
    }
    QHBoxLayout* row = makeRow();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        mirrors_[axis] = makeButton(SetupPanel::tr("Mirror %1").arg(axisText(axis)), {},
                                    QStringLiteral("mirror%1Button").arg(axisText(axis)), panel_);
        row->addWidget(mirrors_[axis], 1);
        connect(mirrors_[axis], &QPushButton::clicked, this,
                [this, axis] { emit panel_->mirrored(static_cast<int>(axis)); });
    }
}

void SetupPanel::Fields::refreshSetups() {
    QStringList texts, ids;
    QString chosen;
    for (const SetupRow& setup : state.setups) {
        ids.append(QString::number(numberOf(setup.id)));
        texts.append(setup.title);
        if (setup.id != state.used) continue;
        chosen = ids.back();
        if (!name_->hasFocus()) name_->setText(setup.name);
    }
    setups_->offer(texts, ids, chosen);
    setEnabledKeepingFocus(setups_, !state.busy);
    setEnabledKeepingFocus(name_, !state.busy && state.part != nullptr);
    enableUnless(
        add_,
        !state.part  ? SetupPanel::tr("Import a part first.")
        : state.busy ? SetupPanel::tr("Work is under way.")
        : !state.embedded
            ? SetupPanel::tr("Embed the part first: the next setup starts with the workpiece of this one.")
            : QString(),
        SetupPanel::tr("Add a setup for another side of the part. Its stock is the workpiece that this setup leaves"));
    enableUnless(
        remove_,
        state.setups.size() < 2 ? SetupPanel::tr("A job needs at least one setup.")
        : state.busy            ? SetupPanel::tr("Work is under way.")
                                : QString(),
        SetupPanel::tr("Delete this setup. Only a setup without recordings, paths and programs can be deleted"));
    outOfDate_->tell(
        Notice::Kind::warning,
        state.stockOutOfDate
            ? SetupPanel::tr("The setup that this stock comes from has changed. The stock is not up to date.")
            : QString());
    stock_->setVisible(state.stockOutOfDate);
    enableUnless(stock_,
                 state.locked ? SetupPanel::tr("Delete the recordings of this setup first.")
                 : state.busy ? SetupPanel::tr("Work is under way.")
                              : QString(),
                 SetupPanel::tr("Replay the setup that this stock comes from, and use its workpiece"));
}

QString SetupPanel::Fields::reasonAgainstPlacing() const {
    return !state.part    ? SetupPanel::tr("Import a part first.")
           : state.locked ? SetupPanel::tr("This setup has recordings. Add a setup to rotate the part.")
           : state.busy   ? SetupPanel::tr("Work is under way.")
                          : QString();
}

void SetupPanel::Fields::refreshPlacement() {
    setWrappedText(lies_, state.part ? placementText(state.placement, unit_) : QString());
    const QString reason = reasonAgainstPlacing();
    const std::array tips{
        SetupPanel::tr("Click a face: the part is rotated so that it points down. A cylinder or cone: so that its axis "
                       "is vertical"),
        SetupPanel::tr(
            "Click a face: the part is rotated so that it points up. A cylinder or cone: so that its axis is vertical"),
        SetupPanel::tr("Click a face: the part is rotated so that it points along X. A cylinder or cone: so that its "
                       "axis is parallel to X"),
        SetupPanel::tr("Click a face: the part is rotated so that it points along Y. A cylinder or cone: so that its "
                       "axis is parallel to Y")};
    for (std::size_t i = 0; i < aims_.size(); ++i) {
        enableUnless(aims_[i], reason, tips[i]);
        aims_[i]->setChecked(state.aim == static_cast<FaceAim>(i + 1));
    }
    asked_->tell(Notice::Kind::information,
                 state.aim == FaceAim::none ? QString() : SetupPanel::tr("Click a face of the part in the view."));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        enableUnless(turns_[axis], reason,
                     SetupPanel::tr("Rotate the part by 90° about %1, through its centre").arg(axisText(axis)));
        enableUnless(mirrors_[axis],
                     !reason.isEmpty()         ? reason
                     : state.setups.size() > 1 ? SetupPanel::tr("A part with several setups can't be mirrored.")
                                               : QString(),
                     SetupPanel::tr("Mirror the part across %1. It is then another part than the one in the file")
                         .arg(axisText(axis)));
        setEnabledKeepingFocus(position_[axis], reason.isEmpty());
        if (state.part && !state.part->box().empty())
            position_[axis]->showValue(state.part->box().low[static_cast<int>(axis)]);
    }
    setEnabledKeepingFocus(turnAxis_, reason.isEmpty());
    setEnabledKeepingFocus(angle_, reason.isEmpty());
}

void SetupPanel::Fields::refresh() {
    panel_->setVisible(state.part != nullptr);
    refreshSetups();
    refreshPlacement();
}

void SetupPanel::Fields::setUnit(LengthUnit unit) {
    unit_ = unit;
    for (LengthField* field : position_) field->setLengthUnit(unit);
    refresh();
}

SetupPanel::SetupPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("setupPanel"));
    fields_->refresh();
}

void SetupPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void SetupPanel::setState(const SetupState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

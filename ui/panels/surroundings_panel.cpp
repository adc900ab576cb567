// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/surroundings_panel.h"

#include "core/base/units.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/obstacle_card.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/quantity_field.h"

#include <QCheckBox>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

enum AxisChoice : int { fixedAxis, chosenAxis, freeAxis };
const glm::dvec3 upright(0.0, 0.0, 1.0);

double leanOf(const glm::dvec3& axis) {
    return std::acos(std::clamp(axis.z, -1.0, 1.0));
}

double headingOf(const glm::dvec3& axis) {
    return std::hypot(axis.x, axis.y) > 1e-9 ? std::atan2(axis.y, axis.x) : 0.0;
}

} // namespace

class SurroundingsPanel::Fields : public QObject {
public:
    explicit Fields(SurroundingsPanel* panel);
    void refresh();
    void setUnit(LengthUnit wanted);

    SurroundingsState state;

private:
    void addAddition();
    void addAxis();
    void rebuildCards();
    void refreshAxis();
    void leanTo(double lean, double heading);

    SurroundingsPanel* panel_;
    QVBoxLayout *column_, *list_;
    ChoiceBox *addition_, *axis_;
    QPushButton *add_, *ofView_;
    QLabel* none_;
    QCheckBox* travel_;
    QuantityField *lean_, *heading_;
    std::vector<ObstacleCard*> cards_;
    bool choosing_ = false; ///< whether the user is choosing an axis that is still upright
    LengthUnit unit_ = LengthUnit::millimetre;
};

SurroundingsPanel::Fields::Fields(SurroundingsPanel* panel)
    : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(SurroundingsPanel::tr("Fixtures and keep-out volumes"), panel));
    addAddition();
    none_ = makeWrappedLabel(panel);
    none_->setProperty("look", "quiet");
    setWrappedText(none_, SurroundingsPanel::tr("There is no fixture yet. The tool keeps clear of fixtures and "
                                                "keep-out volumes, and the hand feels them."));
    column_->addWidget(none_);
    list_ = new QVBoxLayout;
    list_->setSpacing(8);
    column_->addLayout(list_);
    travel_ = new QCheckBox(SurroundingsPanel::tr("Machine's travel"), panel);
    travel_->setObjectName(QStringLiteral("travelSwitch"));
    column_->addWidget(travel_);
    connect(travel_, &QCheckBox::clicked, panel, &SurroundingsPanel::travelSwitched);
    addAxis();
    column_->addStretch(1);
}

void SurroundingsPanel::Fields::addAddition() {
    addition_ = new ChoiceBox(panel_);
    addition_->setObjectName(QStringLiteral("obstacleAddition"));
    addition_->setAccessibleName(SurroundingsPanel::tr("Kind to add"));
    addition_->setToolTip(SurroundingsPanel::tr("Kind of fixture or keep-out volume to add"));
    addition_->addItems({SurroundingsPanel::tr("Fixture: box"), SurroundingsPanel::tr("Fixture: cylinder"),
                         SurroundingsPanel::tr("Fixture from a file…"), SurroundingsPanel::tr("Keep out: box"),
                         SurroundingsPanel::tr("Keep out: cylinder"),
                         SurroundingsPanel::tr("Fixture from the library…")}); // in the order of Addition
    add_ = makeButton(SurroundingsPanel::tr("Add"), QStringLiteral("add"), QStringLiteral("addObstacleButton"), panel_);
    connect(add_, &QPushButton::clicked, this,
            [this] { emit panel_->additionRequested(static_cast<Addition>(addition_->currentIndex())); });
    auto* both = new QHBoxLayout;
    both->setSpacing(8);
    both->addWidget(addition_, 1);
    both->addWidget(add_);
    column_->addLayout(both);
}

void SurroundingsPanel::Fields::addAxis() {
    column_->addWidget(makeSectionTitle(SurroundingsPanel::tr("Tool axis"), panel_));
    axis_ = new ChoiceBox(panel_);
    axis_->setObjectName(QStringLiteral("axisChoice"));
    axis_->addItems({SurroundingsPanel::tr("fixed, Z"), SurroundingsPanel::tr("chosen, 3+2"),
                     SurroundingsPanel::tr("free, with the hand")}); // in the order of AxisChoice
    column_->addWidget(new FieldRow(SurroundingsPanel::tr("Axis"), axis_,
                                    SurroundingsPanel::tr("Whether the tool axis is fixed, chosen or free"), panel_,
                                    FieldRow::choiceWidth));
    connect(axis_, &QComboBox::activated, this, [this](int choice) {
        choosing_ = choice == chosenAxis;
        if (choice != chosenAxis)
            emit panel_->axisChosen({choice == freeAxis, upright});
        else if (state.axis.free)
            emit panel_->axisChosen({false, upright});
        refreshAxis();
    });
    lean_ = new QuantityField(Quantity::angle, panel_);
    lean_->setObjectName(QStringLiteral("axisLeanField"));
    lean_->limit(0.0, 0.5 * pi);
    column_->addWidget(new FieldRow(SurroundingsPanel::tr("Lean"), lean_,
                                    SurroundingsPanel::tr("Angle between the tool axis and Z"), panel_));
    heading_ = new QuantityField(Quantity::angle, panel_);
    heading_->setObjectName(QStringLiteral("axisHeadingField"));
    heading_->limit(-pi, pi);
    column_->addWidget(new FieldRow(SurroundingsPanel::tr("Towards"), heading_,
                                    SurroundingsPanel::tr("Where the holder leans to: 0° is X, 90° is Y"), panel_));
    connect(lean_, &QuantityField::valueEdited, this,
            [this](double lean) { leanTo(lean, headingOf(state.axis.direction)); });
    connect(heading_, &QuantityField::valueEdited, this,
            [this](double heading) { leanTo(leanOf(state.axis.direction), heading); });
    ofView_ = makeButton(SurroundingsPanel::tr("Along the view"), {}, QStringLiteral("axisOfViewButton"), panel_);
    column_->addWidget(ofView_);
    connect(ofView_, &QPushButton::clicked, panel_, &SurroundingsPanel::axisOfViewRequested);
}

void SurroundingsPanel::Fields::leanTo(double lean, double heading) {
    emit panel_->axisChosen(
        {false, {std::sin(lean) * std::cos(heading), std::sin(lean) * std::sin(heading), std::cos(lean)}});
}

void SurroundingsPanel::Fields::rebuildCards() {
    for (ObstacleCard* card : cards_) {
        list_->removeWidget(card);
        card->hide();
        card->deleteLater(); // one of them may be emitting its own removal request
    }
    cards_.clear();
    for (std::size_t i = 0; i < state.obstacles.size(); ++i) {
        auto* card = new ObstacleCard(i, *state.obstacles[i].obstacle, panel_);
        card->setUnit(unit_);
        addCard(list_, card);
        connect(card, &ObstacleCard::edited, this,
                [this, i](const Obstacle& obstacle) { emit panel_->obstacleEdited(i, obstacle); });
        connect(card, &ObstacleCard::switched, this, [this, i](bool on) { emit panel_->obstacleSwitched(i, on); });
        connect(card, &ObstacleCard::changeRequested, this, [this, i] { emit panel_->obstacleChangeRequested(i); });
        connect(card, &ObstacleCard::removalRequested, this, [this, i] { emit panel_->obstacleRemovalRequested(i); });
        cards_.push_back(card);
    }
}

void SurroundingsPanel::Fields::refreshAxis() {
    const bool tilted = state.axis.direction != upright;
    if (tilted || state.axis.free) choosing_ = choosing_ && !state.axis.free;
    const int choice = state.axis.free ? freeAxis : tilted || choosing_ ? chosenAxis : fixedAxis;
    axis_->setCurrentIndex(choice);
    for (QWidget* widget : {lean_->parentWidget(), heading_->parentWidget(), static_cast<QWidget*>(ofView_)})
        widget->setVisible(choice == chosenAxis);
    lean_->showValue(leanOf(state.axis.direction));
    heading_->showValue(headingOf(state.axis.direction));
    const QString locked = state.locked ? SurroundingsPanel::tr("Stop the recording first.") : QString();
    enableUnless(axis_, locked, SurroundingsPanel::tr("Whether the tool axis is fixed, chosen or free"));
    enableUnless(ofView_, locked, SurroundingsPanel::tr("Sets the tool axis to the view direction (3+2 milling)"));
    for (QuantityField* field : {lean_, heading_}) setEnabledKeepingFocus(field, !state.locked);
}

void SurroundingsPanel::Fields::refresh() {
    const bool same = std::equal(cards_.begin(), cards_.end(), state.obstacles.begin(), state.obstacles.end(),
                                 [](const ObstacleCard* card, const ObstacleRow& row) {
                                     return card->shape() == row.obstacle->shape.index() &&
                                            card->title() == QString::fromStdString(row.obstacle->name);
                                 });
    if (!same) rebuildCards();
    for (std::size_t i = 0; i < cards_.size(); ++i) cards_[i]->showRow(state.obstacles[i], state.zero, state.locked);
    none_->setVisible(state.obstacles.empty());
    enableUnless(add_,
                 !state.hasPart ? SurroundingsPanel::tr("Import a part first.")
                 : state.locked ? SurroundingsPanel::tr("Stop the recording first.")
                 : state.busy   ? SurroundingsPanel::tr("Work is under way.")
                                : QString(),
                 SurroundingsPanel::tr("Puts it next to the stock, or at the coordinates of its file. An STL file has "
                                       "the unit of the part's STL file, else mm."));
    travel_->setChecked(state.travelOn);
    const bool stands = !state.axis.free && state.axis.direction == upright;
    enableUnless(travel_,
                 stands ? QString() : SurroundingsPanel::tr("The machine's travel limits a vertical tool only."),
                 SurroundingsPanel::tr("The tool tip stays within the travel of the machine's axes"));
    refreshAxis();
}

void SurroundingsPanel::Fields::setUnit(LengthUnit wanted) {
    unit_ = wanted;
    for (ObstacleCard* card : cards_) card->setUnit(wanted);
}

SurroundingsPanel::SurroundingsPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("surroundingsPanel"));
    fields_->refresh();
}

void SurroundingsPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void SurroundingsPanel::setState(const SurroundingsState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

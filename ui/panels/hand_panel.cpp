// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/hand_panel.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"

namespace burin {
namespace {

constexpr double smallestScale = 0.05, largestScale = 50.0;
constexpr int spindleButton = 1;

} // namespace

class HandPanel::Fields : public QObject {
public:
    explicit Fields(HandPanel* panel);
    void refresh();

    HandState state;

private:
    void addMovement();
    void addControl();
    ChoiceBox* addButtonChoice(const QString& label, const QString& toolTip, const char* name,
                               void (HandPanel::*chosen)(int));
    void refreshMovement(const QString& noDevice);
    void refreshControl();
    void refreshButtons();
    static void showButton(ChoiceBox* choice, const QString& none, int first, int last, int chosen);
    void refreshHealth();

    HandPanel* panel_;
    QVBoxLayout* column_;
    QPushButton *clutch_, *recentre_, *align_, *place_, *speed_;
    QWidget* control_;
    QuantityField* scale_;
    ChoiceBox *clutchButton_, *levelButton_, *forceButton_;
    ValueRow *battery_, *heat_;
    Notice* mouse_;
};

HandPanel::Fields::Fields(HandPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(HandPanel::tr("Hand and tool"), panel));
    addMovement();
    addControl();
    clutchButton_ = addButtonChoice(HandPanel::tr("Clutch button"),
                                    HandPanel::tr("The tool does not move while this button of the stylus is held"),
                                    "clutchButtonChoice", &HandPanel::clutchButtonChosen);
    levelButton_ =
        addButtonChoice(HandPanel::tr("Level button"),
                        HandPanel::tr("This button of the stylus requests the next lower level, or ends a pass"),
                        "levelButtonChoice", &HandPanel::levelButtonChosen);
    forceButton_ =
        addButtonChoice(HandPanel::tr("Forces"),
                        HandPanel::tr("Dead man's switch: the stylus has forces only while this button is held"),
                        "forceButtonChoice", &HandPanel::forceButtonChosen);
    battery_ = new ValueRow(HandPanel::tr("Battery"), panel);
    battery_->setObjectName(QStringLiteral("batteryRow"));
    heat_ = new ValueRow(HandPanel::tr("Heat of the motors"), panel);
    heat_->setObjectName(QStringLiteral("heatRow"));
    heat_->setToolTip(HandPanel::tr("Share of the motors' limit, as the device reports it"));
    column_->addWidget(battery_);
    column_->addWidget(heat_);
    mouse_ = new Notice(panel);
    mouse_->setObjectName(QStringLiteral("workspaceNotice"));
    column_->addWidget(mouse_);
    column_->addStretch(1);
}

void HandPanel::Fields::addMovement() {
    scale_ = new QuantityField(Quantity::ratio, panel_);
    scale_->setObjectName(QStringLiteral("workspaceScaleField"));
    scale_->limit(smallestScale, largestScale);
    column_->addWidget(
        new FieldRow(HandPanel::tr("Scale"), scale_, HandPanel::tr("Tool movement divided by hand movement"), panel_));
    connect(scale_, &QuantityField::valueEdited, panel_, &HandPanel::scaleEdited);
    clutch_ = makeButton(HandPanel::tr("Clutch"), {}, QStringLiteral("clutchButton"), panel_);
    clutch_->setCheckable(true);
    recentre_ = makeButton(HandPanel::tr("Recentre"), {}, QStringLiteral("recentreButton"), panel_);
    // The state decides what is on; a click is only a request.
    connect(clutch_, &QPushButton::clicked, this, [this] {
        clutch_->setChecked(state.clutched);
        emit panel_->clutchToggled(!state.clutched);
    });
    connect(recentre_, &QPushButton::clicked, panel_, &HandPanel::recentreRequested);
    align_ = makeButton(HandPanel::tr("Align with the view"), {}, QStringLiteral("alignHandButton"), panel_);
    connect(align_, &QPushButton::clicked, panel_, &HandPanel::alignmentRequested);
    auto* both = new QHBoxLayout;
    both->setSpacing(8);
    both->addWidget(clutch_, 1);
    both->addWidget(recentre_, 1);
    column_->addLayout(both);
    column_->addWidget(align_);
}

void HandPanel::Fields::addControl() {
    control_ = new QWidget(panel_);
    auto* row = new QHBoxLayout(control_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    place_ = makeChoiceButton(HandPanel::tr("By position"), HandPanel::tr("The tool follows the position of the hand"),
                              QStringLiteral("placeControlButton"), control_);
    speed_ = makeChoiceButton(HandPanel::tr("By speed"),
                              HandPanel::tr("The farther the stylus is from its centre, the faster the tool moves"),
                              QStringLiteral("rateControlButton"), control_);
    row->addWidget(place_, 1);
    row->addWidget(speed_, 1);
    column_->addWidget(control_);
    const auto choose = [this](bool rate) {
        refreshControl();
        if (rate != state.rate) emit panel_->rateToggled(rate);
    };
    connect(place_, &QPushButton::clicked, this, [choose] { choose(false); });
    connect(speed_, &QPushButton::clicked, this, [choose] { choose(true); });
}

ChoiceBox* HandPanel::Fields::addButtonChoice(const QString& label, const QString& toolTip, const char* name,
                                              void (HandPanel::*chosen)(int)) {
    auto* choice = new ChoiceBox(panel_);
    choice->setObjectName(QLatin1String(name));
    column_->addWidget(new FieldRow(label, choice, toolTip, panel_, FieldRow::choiceWidth));
    connect(choice, &QComboBox::activated, this,
            [this, choice, chosen](int index) { emit(panel_->*chosen)(choice->itemData(index).toInt()); });
    return choice;
}

void HandPanel::Fields::showButton(ChoiceBox* choice, const QString& none, int first, int last, int chosen) {
    const int wanted = 1 + std::max(0, last - first + 1);
    if (choice->count() != wanted) {
        choice->clear();
        choice->addItem(none, 0);
        for (int button = first; button <= last; ++button)
            choice->addItem(button == spindleButton ? HandPanel::tr("while button %1 is held (spindle)").arg(button)
                                                    : HandPanel::tr("button %1").arg(button),
                            button);
    }
    choice->setItemText(0, none);
    choice->setCurrentIndex(std::max(0, choice->findData(chosen)));
}

void HandPanel::Fields::refreshMovement(const QString& noDevice) {
    setEnabledKeepingFocus(scale_, state.hasDevice);
    scale_->showValue(state.hasDevice ? state.scale : 1.0); // the mouse points directly at the workpiece
    clutch_->setChecked(state.clutched);
    enableUnless(clutch_, noDevice, HandPanel::tr("The hand moves, the tool stays"));
    enableUnless(align_, noDevice,
                 HandPanel::tr("A hand movement to the right moves the tool to the right in the view"));
    enableUnless(recentre_, noDevice,
                 HandPanel::tr("Brings the hand back to the centre of the device's workspace while you work"));
}

void HandPanel::Fields::refreshControl() {
    control_->setVisible(state.canRate);
    place_->setChecked(!state.rate);
    speed_->setChecked(state.rate);
}

void HandPanel::Fields::refreshButtons() {
    const bool more = state.hasDevice && state.buttons > spindleButton; // the first one turns the spindle
    for (ChoiceBox* choice : {clutchButton_, levelButton_}) choice->parentWidget()->setVisible(more);
    forceButton_->parentWidget()->setVisible(state.hasDevice && state.motors && state.buttons > 0);
    showButton(clutchButton_, HandPanel::tr("none"), spindleButton + 1, state.buttons, state.clutchButton);
    showButton(levelButton_, HandPanel::tr("none"), spindleButton + 1, state.buttons, state.levelButton);
    showButton(forceButton_, state.pushesOnButton ? HandPanel::tr("with button 1") : HandPanel::tr("always"),
               spindleButton, state.buttons, state.forceButton);
    enableUnless(forceButton_, state.recording ? HandPanel::tr("Stop the recording first.") : QString(),
                 HandPanel::tr("Dead man's switch: the stylus has forces only while this button is held"));
}

void HandPanel::Fields::refreshHealth() {
    battery_->setVisible(state.battery.has_value());
    heat_->setVisible(state.heat.has_value());
    if (state.battery)
        battery_->setValue(state.charging ? HandPanel::tr("%1, charging").arg(shareText(*state.battery))
                                          : shareText(*state.battery));
    if (state.heat) heat_->setValue(shareText(*state.heat));
}

void HandPanel::Fields::refresh() {
    const QString noDevice =
        state.hasDevice
            ? QString()
            : HandPanel::tr("The mouse points into the view directly. The movements of a device are scaled here.");
    refreshMovement(noDevice);
    refreshControl();
    refreshButtons();
    refreshHealth();
    mouse_->tell(Notice::Kind::information, noDevice);
}

HandPanel::HandPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("handPanel"));
    fields_->refresh();
}

void HandPanel::setState(const HandState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/mill_panel.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/key_lines.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/take_list.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <array>

namespace burin {

class MillPanel::Fields : public QObject {
public:
    explicit Fields(MillPanel* panel);
    void refresh();
    void setUnit(LengthUnit unit);

    MillState state;

private:
    void addButtons();
    void addStylus();
    void addDepth();
    void addPen();
    void addDrag();
    void addRepetitions();
    QuantityField* addField(QuantityField* field, const QString& label, const QString& toolTip, const char* name,
                            double low, double high, void (MillPanel::*edited)(double));
    void chooseRule(DepthChoice rule);
    void choosePenRule(PenChoice rule);
    void chooseRaster(bool on);
    void refreshButtons();
    QString reasonAgainstUndo() const;
    QString undoText() const;
    void refreshStylus();
    void refreshDepth();
    void refreshPen();

    MillPanel* panel_;
    QVBoxLayout* column_;
    QPushButton *mill_, *undo_, *redo_, *level_, *part_, *stroke_, *raster_, *show_, *penDepth_, *penSink_;
    std::array<QPushButton*, 3> repeat_;
    QWidget *repeatRow_, *penRow_;
    ChoiceBox* stylus_;
    QWidget *pointerTitle_, *keysTitle_, *keys_; ///< for controls that only the pointer needs
    QuantityField *depthOfCut_, *press_, *speed_, *stepOver_, *sinkSpeed_;
    Notice *missing_, *alarm_, *hint_, *lock_, *how_;
    TakeList* takes_;
};

MillPanel::Fields::Fields(MillPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(MillPanel::tr("Mill"), panel));
    addButtons();
    addStylus();
    auto* notices = new NoticePlace(panel);
    alarm_ = notices->add("millAlarm");
    hint_ = notices->add("millHint");
    missing_ = notices->add("millMissing");
    lock_ = notices->add("millLock");
    how_ = notices->add("millHow");
    column_->addWidget(notices);
    pointerTitle_ = makeSectionTitle(MillPanel::tr("How the tool follows the hand"), panel);
    column_->addWidget(pointerTitle_);
    addDepth();
    addPen();
    addDrag();
    addRepetitions();
    column_->addWidget(makeSectionTitle(MillPanel::tr("Takes"), panel));
    takes_ = new TakeList(
        MillPanel::tr("Nothing is recorded yet. Everything that you mill will be; Show me demonstrates it."), panel);
    takes_->setObjectName(QStringLiteral("takeList"));
    takes_->setAccessibleName(MillPanel::tr("Takes"));
    column_->addWidget(takes_);
    connect(takes_, &TakeList::removalRequested, panel, &MillPanel::takeRemovalRequested);
    show_ = makeButton(MillPanel::tr("Show me"), QStringLiteral("play"), QStringLiteral("showMeButton"), panel);
    connect(show_, &QPushButton::clicked, panel, &MillPanel::showMeRequested);
    column_->addWidget(show_);
    keysTitle_ = makeSectionTitle(MillPanel::tr("Mouse and keys"), panel);
    column_->addWidget(keysTitle_);
    keys_ = new KeyLines(HandKeys::inMillMode(), panel);
    column_->addWidget(keys_);
    column_->addStretch(1);
}

void MillPanel::Fields::addButtons() {
    mill_ = makeButton({}, QStringLiteral("mill"), QStringLiteral("millButton"), panel_);
    mill_->setCheckable(true);
    mill_->setFont(numberFont(mill_->font()));
    undo_ = makeButton(MillPanel::tr("Undo"), QStringLiteral("undo"), QStringLiteral("undoStrokeButton"), panel_);
    redo_ = makeButton(MillPanel::tr("Redo"), QStringLiteral("redo"), QStringLiteral("redoStrokeButton"), panel_);
    redo_->setToolTip(MillPanel::tr("Redo the stroke that was undone last"));
    auto* second = new QHBoxLayout;
    second->setSpacing(8);
    second->addWidget(undo_, 1);
    second->addWidget(redo_, 1);
    column_->addWidget(mill_);
    column_->addLayout(second);
    // The state decides what is on; a click is only a request.
    connect(mill_, &QPushButton::clicked, this, [this] {
        mill_->setChecked(state.active);
        emit panel_->millModeToggled(!state.active);
    });
    connect(undo_, &QPushButton::clicked, panel_, &MillPanel::undoStrokeRequested);
    connect(redo_, &QPushButton::clicked, panel_, &MillPanel::redoStrokeRequested);
}

void MillPanel::Fields::addStylus() {
    stylus_ = new ChoiceBox(panel_);
    stylus_->setObjectName(QStringLiteral("stylusChoice"));
    column_->addWidget(new FieldRow(MillPanel::tr("Stylus"), stylus_, MillPanel::tr("Stylus that moves the tool"),
                                    panel_, FieldRow::choiceWidth));
    connect(stylus_, &QComboBox::activated, panel_, &MillPanel::stylusChosen);
}

void MillPanel::Fields::addDepth() {
    level_ = makeChoiceButton(MillPanel::tr("Level"),
                              MillPanel::tr("A stroke stays at the height of its first point, less the depth of cut"),
                              QStringLiteral("levelButton"), panel_);
    part_ = makeChoiceButton(
        MillPanel::tr("Along the part"),
        MillPanel::tr("A stroke presses onto the part; its push-back guides the tool along the surface"),
        QStringLiteral("alongPartButton"), panel_);
    auto* choice = new QHBoxLayout;
    choice->setSpacing(4);
    choice->addWidget(level_, 1);
    choice->addWidget(part_, 1);
    column_->addLayout(choice);
    connect(level_, &QPushButton::clicked, this, [this] { chooseRule(DepthChoice::level); });
    connect(part_, &QPushButton::clicked, this, [this] { chooseRule(DepthChoice::part); });
    depthOfCut_ = addField(new LengthField(panel_), MillPanel::tr("Depth of cut"),
                           MillPanel::tr("Depth of the tip below the surface under the pointer"), "depthOfCutField",
                           0.0, 100.0, &MillPanel::depthOfCutEdited);
    press_ = addField(new LengthField(panel_), MillPanel::tr("Press"),
                      MillPanel::tr("Depth of the hand in the part, against its push-back"), "pressField", 0.0, 20.0,
                      &MillPanel::pressEdited);
    speed_ = addField(new QuantityField(Quantity::speed, panel_), MillPanel::tr("Speed"),
                      MillPanel::tr("The tool follows the pointer no faster than this while it cuts"), "speedField",
                      1.0, 400.0, &MillPanel::speedEdited);
}

void MillPanel::Fields::addPen() {
    penRow_ = new QWidget(panel_);
    penDepth_ = makeChoiceButton(
        MillPanel::tr("Depth"),
        MillPanel::tr(
            "The pressure sets the depth; at full pressure it is the depth of cut, or the press into the part"),
        QStringLiteral("penDepthButton"), penRow_);
    penSink_ = makeChoiceButton(
        MillPanel::tr("Sinking"),
        MillPanel::tr(
            "The tool sinks from the surface to the depth of cut; it sinks faster the harder the pen presses"),
        QStringLiteral("penSinkButton"), penRow_);
    auto* choice = new QHBoxLayout(penRow_);
    choice->setContentsMargins(0, 0, 0, 0);
    choice->setSpacing(4);
    choice->addWidget(new QLabel(MillPanel::tr("Pen"), penRow_));
    choice->addWidget(penDepth_, 1);
    choice->addWidget(penSink_, 1);
    column_->addWidget(penRow_);
    connect(penDepth_, &QPushButton::clicked, this, [this] { choosePenRule(PenChoice::depth); });
    connect(penSink_, &QPushButton::clicked, this, [this] { choosePenRule(PenChoice::sink); });
    sinkSpeed_ = addField(new QuantityField(Quantity::speed, panel_), MillPanel::tr("Sinking speed"),
                          MillPanel::tr("Speed at which the tool sinks at full pressure of the pen"), "sinkSpeedField",
                          0.1, 50.0, &MillPanel::sinkSpeedEdited);
}

void MillPanel::Fields::addDrag() {
    stroke_ = makeChoiceButton(MillPanel::tr("Stroke"), MillPanel::tr("Dragging cuts along the pointer's trail"),
                               QStringLiteral("strokeButton"), panel_);
    raster_ = makeChoiceButton(MillPanel::tr("Raster"),
                               MillPanel::tr("Drag a rectangle; it is milled in rows at the step-over (T)"),
                               QStringLiteral("rasterButton"), panel_);
    auto* choice = new QHBoxLayout;
    choice->setSpacing(4);
    choice->addWidget(stroke_, 1);
    choice->addWidget(raster_, 1);
    column_->addLayout(choice);
    connect(stroke_, &QPushButton::clicked, this, [this] { chooseRaster(false); });
    connect(raster_, &QPushButton::clicked, this, [this] { chooseRaster(true); });
    stepOver_ =
        addField(new LengthField(panel_), MillPanel::tr("Step-over"),
                 MillPanel::tr("Distance between the rows of a raster, and to a stroke repeated beside the last one"),
                 "stepOverField", 0.01, 100.0, &MillPanel::stepOverEdited);
}

void MillPanel::Fields::addRepetitions() {
    struct Offer {
        RepeatChoice how;
        QString text, toolTip;
        const char* name;
    };
    const std::array offers{
        Offer{RepeatChoice::lower, MillPanel::tr("Lower"),
              MillPanel::tr("Repeat the last stroke, lower by the depth of cut (L)"), "repeatLowerButton"},
        Offer{RepeatChoice::left, MillPanel::tr("Left"),
              MillPanel::tr("Repeat the last stroke one step-over to the left of its direction (B)"),
              "repeatLeftButton"},
        Offer{RepeatChoice::right, MillPanel::tr("Right"),
              MillPanel::tr("Repeat the last stroke one step-over to the right of its direction (Shift+B)"),
              "repeatRightButton"}};
    repeatRow_ = new QWidget(panel_);
    auto* row = new QHBoxLayout(repeatRow_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(new QLabel(MillPanel::tr("Repeat"), repeatRow_));
    for (std::size_t i = 0; i < offers.size(); ++i) {
        repeat_[i] = makeButton(offers[i].text, {}, QLatin1String(offers[i].name), repeatRow_);
        repeat_[i]->setToolTip(offers[i].toolTip);
        row->addWidget(repeat_[i], 1);
        connect(repeat_[i], &QPushButton::clicked, panel_,
                [this, how = offers[i].how] { emit panel_->repeatRequested(how); });
    }
    column_->addWidget(repeatRow_);
}

QuantityField* MillPanel::Fields::addField(QuantityField* field, const QString& label, const QString& toolTip,
                                           const char* name, double low, double high,
                                           void (MillPanel::*edited)(double)) {
    field->setObjectName(QLatin1String(name));
    field->limit(low, high);
    column_->addWidget(new FieldRow(label, field, toolTip, panel_));
    connect(field, &QuantityField::valueEdited, panel_, edited);
    return field;
}

void MillPanel::Fields::chooseRule(DepthChoice rule) {
    const bool other = rule != state.depthRule;
    state.depthRule = rule;
    refreshDepth();
    if (other) emit panel_->depthRuleChosen(rule);
}

void MillPanel::Fields::choosePenRule(PenChoice rule) {
    const bool other = rule != state.penRule;
    state.penRule = rule;
    refreshPen();
    if (other) emit panel_->penRuleChosen(rule);
}

void MillPanel::Fields::chooseRaster(bool on) {
    const bool other = on != state.raster;
    state.raster = on;
    refreshDepth();
    if (other) emit panel_->rasterChosen(on);
}

/// The history of strokes belongs to the workpiece, which is recreated when a project is opened.
QString MillPanel::Fields::reasonAgainstUndo() const {
    if (state.cutting) return MillPanel::tr("A stroke is being cut. Wait until it ends, or press Esc to end it.");
    if (state.canUndoStroke) return {};
    if (state.takes.empty() || state.recording || state.showing) return MillPanel::tr("There is no stroke to undo.");
    return MillPanel::tr("Strokes from before the project was opened can't be undone; delete their take instead.");
}

QString MillPanel::Fields::undoText() const {
    return state.undoableStrokes == 1 ? MillPanel::tr("Undo the last stroke; no other one can be undone")
                                      : MillPanel::tr("Undo the last stroke; the last %n strokes can be undone",
                                                      nullptr, static_cast<int>(state.undoableStrokes));
}

void MillPanel::Fields::refreshButtons() {
    const QString missing =
        state.missing.isEmpty() ? MillPanel::tr("Embed the part and choose a tool first.") : state.missing;
    const QString reason = state.ready ? QString() : missing;
    mill_->setChecked(state.active);
    mill_->setText(state.recording ? MillPanel::tr("Stop, recorded %1").arg(durationText(state.recordedSeconds))
                   : state.active  ? MillPanel::tr("Stop milling")
                                   : MillPanel::tr("Mill"));
    setLook(mill_, state.recording ? "record" : state.ready && !state.active ? "primary" : "");
    showIcon(mill_, state.active ? QStringLiteral("stop") : QStringLiteral("mill"),
             state.recording || (state.ready && !state.active) ? &Palette::field : &Palette::text);
    enableUnless(mill_, state.active || state.recording ? QString() : reason,
                 state.active ? MillPanel::tr("Stop milling and end the take")
                              : MillPanel::tr("Start milling. Everything that is cut is recorded"));
    enableUnless(undo_, reasonAgainstUndo(), undoText());
    setEnabledKeepingFocus(redo_, state.canRedoStroke && !state.cutting);
    enableUnless(show_,
                 state.showing     ? QString()
                 : state.recording ? MillPanel::tr("Stop the recording first.")
                                   : reason,
                 state.showing ? MillPanel::tr("Stop the virtual operator")
                               : MillPanel::tr("The virtual operator mills the part before your eyes"));
    show_->setText(state.showing ? MillPanel::tr("Stop showing") : MillPanel::tr("Show me"));
    missing_->tell(Notice::Kind::information, reason);
    alarm_->tell(Notice::Kind::error, state.alarm);
    hint_->tell(Notice::Kind::warning, state.hint);
    lock_->tell(Notice::Kind::information, state.lock);
    how_->tell(Notice::Kind::information,
               state.stylus != 0 || !state.ready ? QString()
               : state.active
                   ? MillPanel::tr("Drag in the view to mill. Shift+click mills a straight line from the last end.")
                   : MillPanel::tr("Press Mill, then drag in the view."));
    for (QPushButton* button : repeat_) setEnabledKeepingFocus(button, state.canRepeat);
}

/// Devices may appear and disappear at any time; an unchanged list isn't refilled, so that it stays open.
void MillPanel::Fields::refreshStylus() {
    QStringList shown;
    for (int i = 0; i < stylus_->count(); ++i) shown << stylus_->itemText(i);
    if (shown != state.styluses) {
        stylus_->clear();
        stylus_->addItems(state.styluses);
    }
    stylus_->setCurrentIndex(state.stylus);
    setEnabledKeepingFocus(stylus_, !state.active && !state.recording && !state.showing);
}

void MillPanel::Fields::refreshDepth() {
    const bool level = state.depthRule == DepthChoice::level, pointer = state.stylus == 0;
    for (QWidget* widget :
         {pointerTitle_, keysTitle_, keys_, static_cast<QWidget*>(level_), static_cast<QWidget*>(part_),
          static_cast<QWidget*>(stroke_), static_cast<QWidget*>(raster_), repeatRow_, stepOver_->parentWidget(),
          speed_->parentWidget()})
        widget->setVisible(pointer);
    level_->setChecked(level);
    part_->setChecked(!level);
    stroke_->setChecked(!state.raster);
    raster_->setChecked(state.raster);
    stepOver_->showValue(state.stepOver);
    depthOfCut_->parentWidget()->setVisible(pointer && level);
    press_->parentWidget()->setVisible(pointer && !level);
    depthOfCut_->showValue(state.depthOfCut);
    press_->showValue(state.press);
    speed_->showValue(state.speed);
}

void MillPanel::Fields::refreshPen() {
    const bool pen = state.pen && state.stylus == 0, sinks = state.penRule == PenChoice::sink;
    penRow_->setVisible(pen);
    penDepth_->setChecked(!sinks);
    penSink_->setChecked(sinks);
    sinkSpeed_->parentWidget()->setVisible(pen && sinks);
    sinkSpeed_->showValue(state.sinkSpeed);
}

void MillPanel::Fields::refresh() {
    refreshButtons();
    refreshStylus();
    refreshDepth();
    refreshPen();
    takes_->setTakes(state.takes);
    takes_->setRemovable(!state.recording && !state.showing);
}

void MillPanel::Fields::setUnit(LengthUnit unit) {
    for (QuantityField* field : {depthOfCut_, press_, speed_, stepOver_, sinkSpeed_}) field->setLengthUnit(unit);
}

MillPanel::MillPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("millPanel"));
    fields_->refresh();
}

void MillPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void MillPanel::setState(const MillState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

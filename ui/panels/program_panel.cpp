// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_panel.h"

#include "core/verify/excess.h"
#include "core/verify/gouge.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/deviation_card.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"
#include "ui/panels/load_chart.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"

#include <QScrollArea>

#include <algorithm>

namespace burin {

namespace {

constexpr double smallestTolerance = 0.001, largestTolerance = 1.0; // mm
constexpr double largestExcessTolerance = 10.0;                     // mm
constexpr int pathRows = 2, rowGap = 4;                             // visible at once; pixels

/// Refills a choice only if its names have changed, so that an open list stays open.
void showChoices(ChoiceBox& box, const std::vector<NamedChoice>& choices, const std::string& chosen) {
    bool same = box.count() == static_cast<int>(choices.size());
    for (int i = 0; same && i < box.count(); ++i) same = box.itemText(i) == choices[static_cast<std::size_t>(i)].name;
    if (!same) {
        box.clear();
        for (const NamedChoice& choice : choices) box.addItem(choice.name);
    }
    const auto found = std::ranges::find(choices, chosen, &NamedChoice::id);
    box.setCurrentIndex(found == choices.end() ? -1 : static_cast<int>(found - choices.begin()));
    setEnabledKeepingFocus(&box, !choices.empty());
}

/// The components of the machining time.
QString timeContents(const VerifyReport& report) {
    const QString atFeeds = durationText(report.secondsWithoutAcceleration);
    const auto count = static_cast<int>(report.toolChanges);
    const QString contents =
        count == 1
            ? ProgramPanel::tr(
                  "With accelerations, corners, dwells and 1 tool change; %1 at the programmed feeds alone")
                  .arg(atFeeds)
            : ProgramPanel::tr("With accelerations, corners, dwells and %n tool changes; %1 at the programmed feeds "
                               "alone",
                               nullptr, count)
                  .arg(atFeeds);
    if (report.untimedMoves == 0) return contents;
    return contents + QLatin1Char('\n') +
           ProgramPanel::tr("Without moves whose start the program does not state (approach, return): %n", nullptr,
                            report.untimedMoves);
}

} // namespace

class ProgramPanel::Fields : public QObject {
public:
    explicit Fields(ProgramPanel* panel);
    void refresh();
    void setUnit(LengthUnit next);
    void takeEditor();

    ProgramState state;
    ProgramEditor* editor;
    DeviationCard* deviation;
    LoadChart* load;

private:
    void addTarget();
    void addMachineFoot();
    QString machineNote() const;
    void addNotices();
    void addPaths();
    void refreshPaths();
    void makeSwitches(std::size_t count);
    void showWithoutPath(NamedSwitch& row, const QString& tool) const;
    QString reasonAgainstPosting() const;
    void addFigures();
    void refreshVerdict();
    void refreshFigures();
    QString reasonAgainstExport() const;
    QString failure() const;

    ProgramPanel* panel_;
    QVBoxLayout* column_;
    LengthUnit unit_ = LengthUnit::millimetre;
    QPushButton *post_, *export_, *override_;
    ChoiceBox *machine_, *dialect_, *units_;
    QLabel* machineNote_;
    QWidget* paths_; ///< the rows of the list
    std::vector<NamedSwitch*> pathSwitches_;
    LengthField *tolerance_, *excessTolerance_;
    NoticePlace* notices_;
    Notice *verdict_, *notice_;
    QWidget* figures_;
    ValueRow *gouge_, *excess_, *onPart_, *removed_, *time_, *blocks_;
    QLabel* onPartText_;
};

ProgramPanel::Fields::Fields(ProgramPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(ProgramPanel::tr("Program"), panel));
    post_ = makePrimaryButton(ProgramPanel::tr("Post and check"), QStringLiteral("postButton"), panel);
    export_ = makeButton(ProgramPanel::tr("Export…"), QStringLiteral("export"), QStringLiteral("exportButton"), panel);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(post_, 1);
    buttons->addWidget(export_, 1);
    column_->addLayout(buttons);
    addPaths();
    addTarget();
    tolerance_ = new LengthField(panel);
    tolerance_->setObjectName(QStringLiteral("gougeToleranceField"));
    tolerance_->limit(smallestTolerance, largestTolerance);
    column_->addWidget(new FieldRow(ProgramPanel::tr("Gouge tolerance"), tolerance_,
                                    ProgramPanel::tr("Deepest gouge that passes the check"), panel));
    excessTolerance_ = new LengthField(panel);
    excessTolerance_->setObjectName(QStringLiteral("excessToleranceField"));
    excessTolerance_->limit(0.0, largestExcessTolerance);
    column_->addWidget(new FieldRow(
        ProgramPanel::tr("Excess tolerance"), excessTolerance_,
        ProgramPanel::tr("Largest difference allowed between the stock left on the part and what the paths "
                         "leave, and largest excess at blended corners; 0: not judged"),
        panel));
    addNotices();
    editor = new ProgramEditor(panel);
    takeEditor();
    addFigures();
    load = new LoadChart(panel);
    load->setObjectName(QStringLiteral("loadChart"));
    column_->addWidget(load);
    deviation = new DeviationCard(panel);
    column_->addWidget(deviation);
    column_->addStretch(); // while there is no text

    connect(post_, &QPushButton::clicked, panel, &ProgramPanel::postRequested);
    connect(export_, &QPushButton::clicked, panel, &ProgramPanel::exportRequested);
    connect(tolerance_, &LengthField::valueEdited, panel, &ProgramPanel::gougeToleranceEdited);
    connect(excessTolerance_, &LengthField::valueEdited, panel, &ProgramPanel::excessToleranceEdited);
    connect(editor, &ProgramEditor::textCheckRequested, panel, &ProgramPanel::textCheckRequested);
    connect(editor, &ProgramEditor::textEdited, panel, &ProgramPanel::textEdited);
    connect(override_, &QPushButton::clicked, panel, &ProgramPanel::overrideRequested);
    connect(editor, &ProgramEditor::lineChosen, panel, &ProgramPanel::lineChosen);
    connect(editor, &ProgramEditor::breakpointToggled, panel, &ProgramPanel::breakpointToggled);
    connect(load, &LoadChart::lineChosen, panel, [panel, this](int line) {
        editor->showLine(line);
        emit panel->lineChosen(line);
    });
}

void ProgramPanel::Fields::addNotices() {
    notices_ = new NoticePlace(panel_);
    notice_ = notices_->add("programNotice");
    verdict_ = notices_->add("verdict");
    override_ = makeButton(ProgramPanel::tr("Override the check…"), QStringLiteral("warning"),
                           QStringLiteral("overrideButton"), panel_);
    override_->setToolTip(
        ProgramPanel::tr("Give a reason that goes into the program's header; then it can be exported"));
    notices_->setFoot(override_);
    column_->addWidget(notices_);
}

/// Places the editor below the result of the check.
void ProgramPanel::Fields::takeEditor() {
    column_->insertWidget(column_->indexOf(notices_) + 1, editor, 1);
    editor->show(); // the previous owner may have hidden it
}

void ProgramPanel::Fields::addTarget() {
    machine_ = new ChoiceBox(panel_);
    machine_->setObjectName(QStringLiteral("machineChoice"));
    column_->addWidget(new FieldRow(ProgramPanel::tr("Machine"), machine_,
                                    ProgramPanel::tr("Its feeds, speeds and travel limit the program"), panel_,
                                    FieldRow::wholeWidth));
    addMachineFoot();
    dialect_ = new ChoiceBox(panel_);
    dialect_->setObjectName(QStringLiteral("dialectChoice"));
    column_->addWidget(new FieldRow(ProgramPanel::tr("Dialect"), dialect_,
                                    ProgramPanel::tr("NC dialect that the machine's control reads"), panel_,
                                    FieldRow::choiceWidth));
    units_ = new ChoiceBox(panel_);
    units_->setObjectName(QStringLiteral("programUnits"));
    units_->addItems({ProgramPanel::tr("mm (G21)"), ProgramPanel::tr("inch (G20)")});
    column_->addWidget(new FieldRow(ProgramPanel::tr("Units"), units_,
                                    ProgramPanel::tr("Lengths and feeds in the program's text"), panel_,
                                    FieldRow::choiceWidth));
    connect(units_, &QComboBox::activated, this,
            [this](int index) { emit panel_->unitsChosen(static_cast<NcUnits>(index)); });
    connect(machine_, &QComboBox::activated, this,
            [this](int index) { emit panel_->machineChosen(state.machines[static_cast<std::size_t>(index)].id); });
    connect(dialect_, &QComboBox::activated, this,
            [this](int index) { emit panel_->dialectChosen(state.dialects[static_cast<std::size_t>(index)].id); });
}

/// A note on the origin of the machine's values, and a button to edit them.
void ProgramPanel::Fields::addMachineFoot() {
    auto* foot = new QHBoxLayout;
    foot->setSpacing(8);
    machineNote_ = makeWrappedLabel(panel_);
    machineNote_->setObjectName(QStringLiteral("machineNote"));
    machineNote_->setProperty("look", "small");
    auto* machines =
        makeButton(ProgramPanel::tr("Machines…"), QStringLiteral("edit"), QStringLiteral("machinesButton"), panel_);
    machines->setToolTip(ProgramPanel::tr("Look at the machines; copy, change and delete your own"));
    foot->addWidget(machineNote_, 1);
    foot->addWidget(machines, 0, Qt::AlignTop);
    column_->addLayout(foot);
    connect(machines, &QPushButton::clicked, panel_, &ProgramPanel::machinesRequested);
}

QString ProgramPanel::Fields::machineNote() const {
    if (!state.missingMachine.isEmpty()) {
        const auto used = std::ranges::find(state.machines, state.machine, &NamedChoice::id);
        return ProgramPanel::tr("The project's machine “%1” is not on this computer; “%2” is used in its place.")
            .arg(state.missingMachine, used == state.machines.end() ? QString() : used->name);
    }
    return state.typicalMachine
               ? ProgramPanel::tr("Typical values, not those of your machine: copy it and enter yours.")
               : ProgramPanel::tr("Your own machine.");
}

/// The height is always that of a few rows, so that nothing below moves when a path is added.
void ProgramPanel::Fields::addPaths() {
    column_->addWidget(makeSectionTitle(ProgramPanel::tr("Tools of the program"), panel_));
    paths_ = new QWidget;
    auto* list = new QVBoxLayout(paths_);
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(rowGap);
    list->setAlignment(Qt::AlignTop);
    makeSwitches(1);
    pathSwitches_.front()->show(QStringLiteral("T1"), true, QStringLiteral("T1")); // as high as a row with texts
    auto* area = makeListArea(paths_, panel_);
    area->setObjectName(QStringLiteral("programPaths"));
    area->setFixedHeight(pathRows * (pathSwitches_.front()->sizeHint().height() + rowGap) - rowGap);
    column_->addWidget(area);
}

void ProgramPanel::Fields::makeSwitches(std::size_t count) {
    while (pathSwitches_.size() < count) {
        const std::size_t place = pathSwitches_.size();
        auto* path = new NamedSwitch(QStringLiteral("programPath%1").arg(place),
                                     ProgramPanel::tr("Whether the program contains the path of this tool"), paths_);
        connect(path, &NamedSwitch::switched, this,
                [this, place](bool on) { emit panel_->pathIncluded(state.paths[place].id, on); });
        paths_->layout()->addWidget(path);
        pathSwitches_.push_back(path);
    }
}

void ProgramPanel::Fields::showWithoutPath(NamedSwitch& row, const QString& tool) const {
    row.show(tool, false, ProgramPanel::tr("no path"));
    row.setToolTip(
        ProgramPanel::tr("The takes of %1 have no path and are not in the program. Make a new path to include them.")
            .arg(tool));
}

/// In the order of milling, followed by the tools that have takes but no path.
void ProgramPanel::Fields::refreshPaths() {
    const std::size_t paths = state.paths.size(), rows = paths + static_cast<std::size_t>(state.withoutPath.size());
    makeSwitches(rows);
    for (std::size_t i = 0; i < pathSwitches_.size(); ++i) {
        NamedSwitch& row = *pathSwitches_[i];
        row.setVisible(i < rows);
        if (i < paths)
            row.show(state.paths[i].name, state.paths[i].included, {});
        else if (i < rows)
            showWithoutPath(row, state.withoutPath[static_cast<qsizetype>(i - paths)]);
        if (i < paths) row.setToolTip({});
        // With a single tool there is nothing to choose.
        setEnabledKeepingFocus(&row, i < paths && (rows > 1 || !state.paths[i].included));
    }
}

QString ProgramPanel::Fields::reasonAgainstPosting() const {
    if (!state.hasPath) return ProgramPanel::tr("Make a path first.");
    if (state.busy) return ProgramPanel::tr("Work is under way.");
    if (!state.upToDate) return ProgramPanel::tr("Takes or edits changed: update the path first.");
    return {};
}

void ProgramPanel::Fields::addFigures() {
    figures_ = new QWidget(panel_);
    auto* rows = new QVBoxLayout(figures_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    for (auto [row, text, name] : {std::tuple{&gouge_, ProgramPanel::tr("Deepest gouge"), "gougeMax"},
                                   {&excess_, ProgramPanel::tr("Excess, mean / max"), "excess"},
                                   {&onPart_, ProgramPanel::tr("On the part"), "onPartShare"},
                                   {&removed_, ProgramPanel::tr("Removed"), "removedVolume"},
                                   {&time_, ProgramPanel::tr("Machining time"), "machiningTime"},
                                   {&blocks_, ProgramPanel::tr("Blocks"), "blockCount"}}) {
        *row = new ValueRow(text, figures_);
        (*row)->setObjectName(QLatin1String(name));
        rows->addWidget(*row);
    }
    onPartText_ = makeWrappedLabel(figures_);
    onPartText_->setObjectName(QStringLiteral("onPartText"));
    onPartText_->setProperty("look", "small");
    rows->addWidget(onPartText_);
    column_->addWidget(figures_);
}

QString ProgramPanel::Fields::reasonAgainstExport() const {
    if (state.text.isEmpty()) return ProgramPanel::tr("Post the path first.");
    if (state.busy) return ProgramPanel::tr("Work is under way.");
    if (state.edited) return ProgramPanel::tr("The text was edited: check it first.");
    if (!state.report) return ProgramPanel::tr("The program is not checked yet: post and check it.");
    if (state.outdated) return ProgramPanel::tr("The path or its check's inputs have changed. Post and check again.");
    if (!state.released) return ProgramPanel::tr("The program did not pass its check.");
    return {};
}

QString ProgramPanel::Fields::failure() const {
    const int count = static_cast<int>(editor->errors());
    return count == 1 ? ProgramPanel::tr("Not passed: 1 finding.")
                      : ProgramPanel::tr("Not passed: %n findings.", nullptr, count);
}

void ProgramPanel::Fields::refreshVerdict() {
    if (state.busy)
        notice_->tell(Notice::Kind::information, ProgramPanel::tr("The program is being posted and checked…"));
    else if (!state.problem.isEmpty())
        notice_->tell(Notice::Kind::error, state.problem);
    else if (!state.hasPath && state.text.isEmpty()) // a program from another system needs no path
        notice_->tell(Notice::Kind::information, ProgramPanel::tr("Make a path first."));
    else if (state.edited)
        notice_->tell(Notice::Kind::warning, ProgramPanel::tr("The text was edited: check it first."));
    else if (!state.text.isEmpty() && !state.report)
        notice_->tell(Notice::Kind::warning, ProgramPanel::tr("The program is not checked yet: post and check it."));
    else
        notice_->clear();
    if (!state.report)
        verdict_->clear();
    else if (state.outdated) // don't report as passed what might fail now
        verdict_->tell(Notice::Kind::warning,
                       (editor->errors() == 0
                            ? ProgramPanel::tr("Out of date: passed its check before the last changes.")
                            : ProgramPanel::tr("Out of date: failed its check before the last changes.")) +
                           QLatin1Char(' ') + ProgramPanel::tr("Post and check again."));
    else if (editor->errors() == 0)
        verdict_->tell(Notice::Kind::passed,
                       ProgramPanel::tr("Passed: gouge %1 (limit %2), no collision, all limits kept.")
                           .arg(lengthText(state.report->gougeMax, unit_), lengthText(state.judgedTolerance, unit_)));
    else if (state.released)
        verdict_->tell(Notice::Kind::warning,
                       failure() + QLatin1Char(' ') +
                           ProgramPanel::tr("The reason for exporting it is stated in its header."));
    else
        verdict_->tell(Notice::Kind::error, failure());
    notices_->setFootRequested(state.report && !state.released && !state.outdated && notice_->sentence().isEmpty());
}

void ProgramPanel::Fields::refreshFigures() {
    figures_->setVisible(state.report || !state.text.isEmpty()); // they stay visible while the text is edited
    if (!state.report) {
        for (ValueRow* row : {gouge_, excess_, onPart_, removed_, time_, blocks_}) row->setValue(QStringLiteral("–"));
        return;
    }
    const VerifyReport& report = *state.report;
    gouge_->setValue(lengthText(report.gougeMax, unit_));
    gouge_->setToolTip(report.exactSamples > 0 ? ProgramPanel::tr("Judged on the exact surfaces at the worst points")
                                               : ProgramPanel::tr("Judged on the fine mesh"));
    // Larger values were not measured.
    const QString atLeast = report.excessMax < longestExcess ? QString() : QStringLiteral("≥ ");
    excess_->setValue(lengthNumber(report.excessMean, unit_) + QStringLiteral(" / ") + atLeast +
                      lengthText(report.excessMax, unit_));
    setWrappedText(onPartText_,
                   ProgramPanel::tr("On the part: the share of the cutting moves over the part in which the cutter is "
                                    "within %1 of its surface. Close to 100 % for finishing, low for roughing.")
                       .arg(shortLength(onPartDistance, unit_)));
    onPart_->setValue(QLocale().toString(100.0 * report.onPartShare, 'f', 1) + QChar(QChar::Nbsp) + QLatin1Char('%'));
    removed_->setValue(volumeText(report.removed, unit_));
    time_->setValue(durationText(report.machiningSeconds));
    time_->setToolTip(timeContents(report));
    blocks_->setValue(countText(state.blocks));
}

void ProgramPanel::Fields::refresh() {
    enableUnless(post_, reasonAgainstPosting(),
                 ProgramPanel::tr("Write the program, read it back and mill it again on a fresh workpiece"));
    enableUnless(export_, reasonAgainstExport(), ProgramPanel::tr("Write the program to a file for the machine"));
    showChoices(*machine_, state.machines, state.machine);
    setWrappedText(machineNote_, machineNote());
    setLook(machineNote_, state.missingMachine.isEmpty() ? "small" : "accent");
    showChoices(*dialect_, state.dialects, state.dialect);
    units_->setCurrentIndex(static_cast<int>(state.units));
    refreshPaths();
    tolerance_->showValue(state.gougeTolerance);
    excessTolerance_->showValue(state.excessTolerance);
    editor->setState(state);
    refreshVerdict();
    refreshFigures();
    load->setVisible(state.report && !state.report->loads.empty());
    load->setReport(state.report);
    deviation->setVisible(state.report && !state.report->deviations.empty());
}

void ProgramPanel::Fields::setUnit(LengthUnit next) {
    unit_ = next;
    tolerance_->setLengthUnit(next);
    deviation->setUnit(next);
    editor->setUnit(next);
    refresh();
}

ProgramPanel::ProgramPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("programPanel"));
    fields_->refresh();
}

void ProgramPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void ProgramPanel::setState(const ProgramState& state) {
    fields_->state = state;
    fields_->refresh();
}

int ProgramPanel::line() const {
    return fields_->editor->line();
}

void ProgramPanel::setBreakpoints(const std::set<int>& lines) {
    fields_->editor->setBreakpoints(lines);
}

void ProgramPanel::showLine(int line) {
    fields_->editor->showLine(line);
}

void ProgramPanel::showMachineState(const QString& state, std::optional<double> seconds) {
    fields_->editor->showMachineState(state);
    fields_->load->showTime(seconds);
}

DeviationCard& ProgramPanel::deviation() const {
    return *fields_->deviation;
}

ProgramEditor& ProgramPanel::editor() const {
    return *fields_->editor;
}

void ProgramPanel::takeEditor() {
    fields_->takeEditor();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/path_panel.h"

#include "core/path/edit_step.h"
#include "ui/messages/messages.h"
#include "ui/panels/area_card.h"
#include "ui/panels/buttons.h"
#include "ui/panels/card_keyboard.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/edit_card.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/notice.h"
#include "ui/panels/omission_labels.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/selection_card.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"

#include <QLabel>
#include <QMenu>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace burin {

class PathPanel::Fields : public QObject {
public:
    explicit Fields(PathPanel* panel);
    void refresh();
    void refreshSelection() { selection_->setState(state, unit); }
    void showStylus(const StylusEditState& stylus, LengthUnit lengths) { selection_->setStylus(stylus, lengths); }

    PathState state;
    LengthUnit unit = LengthUnit::millimetre;
    AreaCard* area;

private:
    void addHead();
    void addToolChoice();
    void refreshTool();
    void refreshButtons();
    void refreshFigures();
    void refreshPasses();
    void addPassText(const QString& text, const QString& name);
    void refreshEdits();
    void makeCards();
    void makeCard(std::size_t place);
    QMenu* editMenu();
    void offer(const Edit& edit, QMenu* menu);
    bool cardsFit() const;
    std::optional<std::size_t> addedPlace() const;
    QString withoutTakes() const;
    void tell();

    PathPanel* panel_;
    QVBoxLayout* column_;
    QPushButton *new_, *update_, *pass_, *refresh_, *measure_, *add_;
    QToolButton* eye_;
    ChoiceBox* tool_;
    Notice* notice_;
    QWidget* content_;
    SelectionCard* selection_;
    ValueRow *takes_, *points_, *length_, *sides_, *budget_;
    QVBoxLayout *list_, *passList_;
    std::vector<PassRow> shownPasses_;
    std::vector<QWidget*> passRows_;
    std::vector<EditCard*> cards_;
    CardKeyboard keyboard_;
    std::string adding_; ///< kind of the edit that the user requested, until its card exists
};

PathPanel::Fields::Fields(PathPanel* panel)
    : QObject(panel)
    , panel_(panel)
    , column_(makePanelLayout(panel))
    , content_(new QWidget(panel))
    , keyboard_(content_, QStringLiteral("edit")) {
    addHead();
    auto* inner = new QVBoxLayout(content_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(8);
    for (auto [row, text, name] : {std::tuple{&takes_, PathPanel::tr("Takes and passes"), "pathTakes"},
                                   {&points_, PathPanel::tr("Points"), "pathPoints"},
                                   {&length_, PathPanel::tr("Cutting length"), "pathLength"},
                                   {&sides_, PathPanel::tr("Climb / conventional"), "pathSides"},
                                   {&budget_, PathPanel::tr("Error of all edits"), "pathErrorBudget"}}) {
        *row = new ValueRow(text, content_);
        (*row)->setObjectName(QLatin1String(name));
        inner->addWidget(*row);
    }
    passList_ = new QVBoxLayout;
    passList_->setSpacing(4);
    inner->addLayout(passList_);
    refresh_ = makeButton(PathPanel::tr("Compute outdated passes again"), QStringLiteral("refresh"),
                          QStringLiteral("refreshPassesButton"), panel_);
    connect(refresh_, &QPushButton::clicked, panel_, &PathPanel::refreshRequested);
    inner->addWidget(refresh_);
    measure_ = makeButton(PathPanel::tr("Measure the passes"), QStringLiteral("information"),
                          QStringLiteral("measurePassesButton"), panel_);
    connect(measure_, &QPushButton::clicked, panel_, &PathPanel::measureRequested);
    inner->addWidget(measure_);
    sides_->setToolTip(
        PathPanel::tr("With a spindle that rotates clockwise; conventional cuts are pink in the view. Other moves cut "
                      "on both sides, or from above. Reverse changes the direction of strokes"));
    budget_->setToolTip(PathPanel::tr("Largest deviation of the path from the recording"));
    selection_ = new SelectionCard(content_);
    connect(selection_, &SelectionCard::dragChosen, panel, &PathPanel::dragChosen);
    connect(selection_, &SelectionCard::drawingRequested, panel, &PathPanel::drawingRequested);
    connect(selection_, &SelectionCard::cleared, panel, &PathPanel::selectionCleared);
    connect(selection_, &SelectionCard::stylusRequested, panel, &PathPanel::stylusRequested);
    connect(selection_, &SelectionCard::stylusReachEdited, panel, &PathPanel::stylusReachEdited);
    inner->addWidget(selection_);
    inner->addWidget(makeSectionTitle(PathPanel::tr("Edits, in order"), content_));
    add_ = makeButton(PathPanel::tr("Add an edit"), QStringLiteral("add"), QStringLiteral("addEditButton"), content_);
    add_->setMenu(editMenu());
    inner->addWidget(add_); // above the list, so that the list doesn't move it
    list_ = new QVBoxLayout;
    list_->setSpacing(4);
    inner->addLayout(list_);
    column_->addWidget(content_);
    column_->addStretch(1);
}

void PathPanel::Fields::addHead() {
    auto* head = new QHBoxLayout;
    head->addWidget(makeSectionTitle(PathPanel::tr("Path"), panel_), 1);
    eye_ = makeIconButton(QStringLiteral("eye"), PathPanel::tr("Show the path in the view"),
                          QStringLiteral("pathVisibleButton"), panel_);
    eye_->setCheckable(true);
    eye_->setChecked(true);
    head->addWidget(eye_);
    column_->addLayout(head);
    addToolChoice();
    new_ = makePrimaryButton(PathPanel::tr("New path from the takes"), QStringLiteral("newPathButton"), panel_);
    update_ = makePrimaryButton(PathPanel::tr("Update path"), QStringLiteral("updatePathButton"), panel_);
    column_->addWidget(new_);
    column_->addWidget(update_);
    pass_ =
        makeButton(PathPanel::tr("Compute a pass…"), QStringLiteral("path"), QStringLiteral("newPassButton"), panel_);
    column_->addWidget(pass_);
    area = new AreaCard(panel_);
    column_->addWidget(area);
    auto* notices = new NoticePlace(panel_);
    notice_ = notices->add("pathNotice");
    column_->addWidget(notices);
    connect(new_, &QPushButton::clicked, panel_, &PathPanel::newPathRequested);
    connect(pass_, &QPushButton::clicked, panel_, &PathPanel::passRequested);
    connect(update_, &QPushButton::clicked, panel_, &PathPanel::evaluateRequested);
    connect(eye_, &QToolButton::clicked, this, [this](bool shown) {
        showIcon(eye_, shown ? QStringLiteral("eye") : QStringLiteral("eye-off"));
        emit panel_->visibilityToggled(shown);
    });
}

void PathPanel::Fields::addToolChoice() {
    tool_ = new ChoiceBox(panel_);
    tool_->setObjectName(QStringLiteral("pathTool"));
    const QString toolTip =
        PathPanel::tr("Loads the tool whose path is shown and edited, one of those that have milled");
    column_->addWidget(new FieldRow(PathPanel::tr("Tool"), tool_, toolTip, panel_, FieldRow::choiceWidth));
    connect(tool_, &ChoiceBox::activated, this,
            [this] { emit panel_->toolChosen(tool_->currentData().toString().toStdString()); });
}

/// Always visible, so that nothing moves when there are other tools to choose than the current one.
void PathPanel::Fields::refreshTool() {
    QStringList names, ids;
    for (const PathState::Tool& tool : state.milled) {
        names.append(tool.name);
        ids.append(QString::fromStdString(tool.id));
    }
    tool_->setPlaceholderText(state.tool.name);
    tool_->offer(names, ids, QString::fromStdString(state.tool.id));
    setEnabledKeepingFocus(tool_, state.milled.size() > 1 || (!state.milled.empty() && !state.hasTakes));
}

void PathPanel::Fields::refreshButtons() {
    const QString busy = state.busy || state.waiting ? PathPanel::tr("Work is under way.") : QString();
    new_->setVisible(!state.exists);
    enableUnless(new_, state.someWithoutPath ? busy : withoutTakes(),
                 PathPanel::tr("Make a path of all takes, one for each tool, with the standard edits"));
    update_->setVisible(state.exists);
    const bool wanted = state.outdated || !state.problem.isEmpty();
    enableUnless(update_,
                 !busy.isEmpty() ? busy
                 : wanted        ? QString()
                                 : PathPanel::tr("The path is up to date."),
                 PathPanel::tr("Apply the edits again"));
    enableUnless(add_, busy, PathPanel::tr("Adds an edit, at the position that the order of edits allows"));
    enableUnless(
        pass_,
        !state.toolTurns     ? PathPanel::tr("The loaded tool doesn't turn: it has no passes.")
        : state.passPossible ? QString()
                             : PathPanel::tr("Wait until the workpiece is ready and no pass is being computed."),
        PathPanel::tr(
            "Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool"));
    refresh_->setVisible(std::ranges::any_of(state.passes, &PassRow::outdated));
    enableUnless(refresh_,
                 state.refreshPossible
                     ? QString()
                     : PathPanel::tr("Wait until the workpiece is ready and no pass is being computed."),
                 PathPanel::tr("Compute those passes again whose strokes have changed; all others stay as they are"));
    measure_->setVisible(!state.passes.empty());
    enableUnless(measure_,
                 state.measurePossible ? QString() : PathPanel::tr("Wait until the path is up to date and measured."),
                 PathPanel::tr("Length, time, share of air and engagement of each pass, and the stock that it leaves"));
    setEnabledKeepingFocus(eye_, state.exists);
}

/// Each pass with its parameters and a button that deletes it.
void PathPanel::Fields::refreshPasses() {
    if (state.passes == shownPasses_) return;
    shownPasses_ = state.passes;
    for (QWidget* row : passRows_) row->deleteLater();
    passRows_.clear();
    for (std::size_t i = 0; i < shownPasses_.size(); ++i) {
        const PassRow& pass = shownPasses_[i];
        auto* row = new QWidget(content_);
        auto* line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        auto* name = new ValueRow(pass.name, row);
        name->setObjectName(QStringLiteral("passRow%1").arg(i));
        name->setValue(pass.figures);
        line->addWidget(name, 1);
        if (i > 0) {
            auto* up = makeIconButton(QStringLiteral("previous"), PathPanel::tr("Mill this pass before the one above"),
                                      QStringLiteral("passUpButton%1").arg(i), row);
            connect(up, &QToolButton::clicked, panel_, [this, id = pass.id] { emit panel_->passMovedUp(id); });
            line->addWidget(up);
        }
        if (pass.computed) {
            auto* change =
                makeIconButton(QStringLiteral("edit"), PathPanel::tr("Change this pass and compute it again"),
                               QStringLiteral("passChangeButton%1").arg(i), row);
            connect(change, &QToolButton::clicked, panel_,
                    [this, id = pass.id] { emit panel_->passChangeRequested(id); });
            line->addWidget(change);
        }
        auto* remove = makeIconButton(QStringLiteral("remove"), PathPanel::tr("Delete this pass"),
                                      QStringLiteral("passRemoveButton%1").arg(i), row);
        connect(remove, &QToolButton::clicked, panel_, [this, id = pass.id] { emit panel_->passRemoved(id); });
        line->addWidget(remove);
        passList_->addWidget(row);
        passRows_.push_back(row);
        if (pass.outdated)
            addPassText(PathPanel::tr("Out of date: hand strokes that this pass depends on have changed."),
                        QStringLiteral("passOutdated%1").arg(i));
        if (!pass.measured.isEmpty()) addPassText(pass.measured, QStringLiteral("passMeasured%1").arg(i));
    }
}

/// A text below the row of a pass.
void PathPanel::Fields::addPassText(const QString& text, const QString& name) {
    auto* label = new QLabel(text, content_);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    passList_->addWidget(label);
    passRows_.push_back(label);
}

QString PathPanel::Fields::withoutTakes() const {
    return state.milled.empty()
               ? PathPanel::tr("Record a take first, or compute a pass.")
               : PathPanel::tr("%1 has not milled yet. Choose a tool that has, record a take, or compute a pass.")
                     .arg(state.tool.name);
}

void PathPanel::Fields::tell() {
    if (state.busy)
        notice_->tell(Notice::Kind::information, PathPanel::tr("The edits are being applied…"));
    else if (!state.problem.isEmpty())
        notice_->tell(Notice::Kind::error, state.problem);
    else if (state.waiting)
        notice_->tell(Notice::Kind::information,
                      PathPanel::tr("The workpiece is being made; then the edits are applied…"));
    else if (!state.hasTakes)
        notice_->tell(Notice::Kind::information, withoutTakes());
    else if (state.exists && state.outdated)
        notice_->tell(Notice::Kind::warning, PathPanel::tr("Takes or edits changed: update the path."));
    else if (!state.missingBefore.isEmpty())
        notice_->tell(Notice::Kind::warning,
                      PathPanel::tr("The path of %1, which is milled before, can't be made. Its stock counts as not "
                                    "removed here; load that tool to see why.")
                          .arg(state.missingBefore));
    else if (state.passLeftOut > 0.0)
        notice_->tell(Notice::Kind::warning,
                      PathPanel::tr("%1 of the pass were skipped: too much stock is in the way of the tool. Rough it "
                                    "first, or use a longer tool.")
                          .arg(lengthText(state.passLeftOut, unit)));
    else if (state.passInTheWay > 0.0)
        notice_->tell(Notice::Kind::warning,
                      PathPanel::tr("%1 of the pass were skipped: fixtures or keep-out volumes are in the way.")
                          .arg(lengthText(state.passInTheWay, unit)));
    else if (state.unreachedHoles > 0)
        notice_->tell(Notice::Kind::warning, unreachedHolesText(state.unreachedHoles, state.holeWork));
    else if (const QString omitted = omissionNotice(state.reports, state.zero, unit); !omitted.isEmpty())
        notice_->tell(Notice::Kind::warning, omitted);
    else
        notice_->clear();
}

void PathPanel::Fields::refreshFigures() {
    const bool evaluated = state.points > 0;
    const QString none = QStringLiteral("–");
    takes_->setValue(countText(state.path.sources.size()));
    points_->setValue(evaluated ? countText(state.points) : none);
    length_->setValue(evaluated ? wayText(state.cuttingLength, unit) : none);
    const double length = std::max(state.cuttingLength, 1e-9);
    sides_->setValue(evaluated ? shareText(state.climbLength / length) + QStringLiteral(" / ") +
                                     shareText(state.conventionalLength / length)
                               : none);
    budget_->setValue(state.errorBudget ? lengthText(*state.errorBudget, unit) : none);
}

bool PathPanel::Fields::cardsFit() const {
    return std::ranges::equal(cards_, state.path.edits, [](const EditCard* card, const Edit& edit) {
        return card->kind() == idOf(edit.parameters);
    });
}

/// The index of the edit that the user just requested; std::nullopt: it doesn't exist yet.
std::optional<std::size_t> PathPanel::Fields::addedPlace() const {
    const std::vector<Edit>& edits = state.path.edits;
    if (adding_.empty() || edits.size() != cards_.size() + 1) return std::nullopt;
    std::size_t place = 0;
    while (place < cards_.size() && cards_[place]->kind() == idOf(edits[place].parameters)) ++place;
    if (idOf(edits[place].parameters) != adding_) return std::nullopt;
    return place;
}

void PathPanel::Fields::makeCards() {
    for (EditCard* card : cards_) {
        card->hide();
        card->deleteLater();
    }
    cards_.clear();
    for (std::size_t i = 0; i < state.path.edits.size(); ++i) makeCard(i);
}

void PathPanel::Fields::makeCard(std::size_t place) {
    auto* card = new EditCard(place, state.path.edits[place], content_);
    connect(card, &EditCard::edited, this, [this, place](const Edit& edit) {
        if (place < state.path.edits.size()) state.path.edits[place] = edit;
        emit panel_->editChanged(place, edit);
    });
    connect(card, &EditCard::moveRequested, this, [this, place](int by) {
        const std::size_t to = by < 0 ? place - 1 : place + 1;
        keyboard_.follow(place, to);
        emit panel_->editMoved(place, to);
    });
    connect(card, &EditCard::placeRequested, panel_, &PathPanel::placeRequested);
    connect(card, &EditCard::removalRequested, this, [this, place] { emit panel_->editRemoved(place); });
    connect(card, &EditCard::drawingRequested, this, [this, place](const QString& key, bool wanted) {
        emit panel_->fieldDrawingRequested({place, key.toStdString()}, wanted);
    });
    card->setMovable(place > 0, place + 1 < state.path.edits.size());
    addCard(list_, card);
    cards_.push_back(card);
}

QMenu* PathPanel::Fields::editMenu() {
    auto* menu = new QMenu(add_);
    menu->setObjectName(QStringLiteral("addEditMenu"));
    struct Group {
        EditGroup group;
        QString title;
    };
    const std::array groups{Group{EditGroup::strokes, PathPanel::tr("Strokes")},
                            Group{EditGroup::arrangement, PathPanel::tr("Order and position")},
                            Group{EditGroup::places, PathPanel::tr("Drawn by hand")},
                            Group{EditGroup::smoothing, PathPanel::tr("Smoother, fewer moves")},
                            Group{EditGroup::surface, PathPanel::tr("Against the part")},
                            Group{EditGroup::links, PathPanel::tr("Leads and links")},
                            Group{EditGroup::feeds, PathPanel::tr("Feeds and speed")}};
    const std::vector<Edit> edits = everyEdit();
    for (const auto& [group, title] : groups) {
        QMenu* part = menu->addMenu(title);
        for (const Edit& edit : edits)
            if (const EditTraits& traits = traitsOf(edit.parameters); traits.group == group && !traits.superseded)
                offer(edit, part);
    }
    return menu;
}

void PathPanel::Fields::offer(const Edit& edit, QMenu* menu) {
    const std::string_view id = idOf(edit.parameters);
    QAction* action = menu->addAction(Messages::text(titleOf(edit.parameters)));
    action->setObjectName(QLatin1String("add-") + QLatin1String(id.data(), static_cast<qsizetype>(id.size())));
    connect(action, &QAction::triggered, this, [this, edit] {
        adding_ = idOf(edit.parameters);
        emit panel_->editAdded(edit);
    });
}

void PathPanel::Fields::refreshEdits() {
    if (!cardsFit() || state.busy) keyboard_.take(cards_);
    const std::optional<std::size_t> added = cardsFit() ? std::nullopt : addedPlace();
    if (!cardsFit()) makeCards();
    std::size_t next = 0;
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        const Edit& edit = state.path.edits[i];
        cards_[i]->setUnit(unit);
        cards_[i]->showEdit(edit, state.zero, state.takes);
        const bool reported =
            edit.enabled && next < state.reports.size() && state.reports[next].edit == cards_[i]->kind();
        cards_[i]->showReport(reported ? &state.reports[next] : nullptr, unit, state.zero);
        next += reported ? 1 : 0;
        const bool drawn = state.drawnField && state.drawnField->edit == i;
        cards_[i]->setDrawing(drawn ? std::string_view(state.drawnField->key) : std::string_view());
        setEnabledKeepingFocus(cards_[i], !state.busy);
    }
    if (added) {
        adding_.clear();
        if (state.drawnField)
            bringIntoView(cards_[*added]); // the keyboard focus belongs to the view, where it is drawn
        else
            keyboard_.await(*added, QStringLiteral("Switch"));
    }
    keyboard_.give(cards_);
}

void PathPanel::Fields::refresh() {
    refreshTool();
    refreshButtons();
    tell();
    content_->setVisible(state.exists);
    refreshPasses();
    refreshFigures();
    refreshSelection();
    refreshEdits();
}

PathPanel::PathPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("pathPanel"));
    fields_->refresh();
}

void PathPanel::setStylusEdit(const StylusEditState& state, LengthUnit unit) {
    fields_->showStylus(state, unit);
}

void PathPanel::setAtTime(const TimelinesPlace& place) {
    fields_->state.atTime = place;
    fields_->refreshSelection();
}

void PathPanel::setUnit(LengthUnit unit) {
    fields_->unit = unit;
    fields_->refresh();
}

AreaCard& PathPanel::area() const {
    return *fields_->area;
}

void PathPanel::setState(const PathState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

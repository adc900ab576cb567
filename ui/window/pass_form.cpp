// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/pass_form.h"

#include "core/base/units.h"
#include "core/recording/generated_moves.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/count_field.h"
#include "ui/panels/field_row.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double widestStep = 1000.0;   // mm
constexpr double rightAngle = 0.5 * pi; // rad

using Kinds = std::vector<PassKind>;
const Kinds clearingKinds{PassKind::levels, PassKind::pocket, PassKind::face};
const Kinds levelKinds{PassKind::levels, PassKind::pocket, PassKind::profile, PassKind::face, PassKind::engrave};
const Kinds rowKinds{PassKind::parallel,  PassKind::radial,  PassKind::spiral, PassKind::flow,
                     PassKind::waterline, PassKind::scallop, PassKind::rest};
const Kinds surfaceKinds{PassKind::parallel,  PassKind::radial,  PassKind::spiral, PassKind::flow,
                         PassKind::waterline, PassKind::scallop, PassKind::rest,   PassKind::pencil};
const Kinds millingKinds{PassKind::levels, PassKind::pocket, PassKind::profile, PassKind::face,      PassKind::parallel,
                         PassKind::radial, PassKind::spiral, PassKind::flow,    PassKind::waterline, PassKind::scallop,
                         PassKind::pencil, PassKind::rest,   PassKind::engrave};

bool contains(const Kinds& kinds, PassKind kind) noexcept {
    return std::ranges::find(kinds, kind) != kinds.end();
}
Kinds without(Kinds kinds, PassKind kind) {
    std::erase(kinds, kind);
    return kinds;
}
Kinds both(Kinds kinds, const Kinds& others) {
    kinds.insert(kinds.end(), others.begin(), others.end());
    return kinds;
}

QString passWords(const TextId& text) {
    return QCoreApplication::translate(text.context, text.text);
}

} // namespace

bool milledInLevels(PassKind kind) noexcept {
    return contains(levelKinds, kind);
}

bool laidOnPart(PassKind kind) noexcept {
    return contains(surfaceKinds, kind);
}

PassForm::PassForm(const PassRequest& last, const PassDefaults& defaults, LengthUnit unit,
                   const std::vector<PassKind>& kinds, QWidget* parent)
    : QWidget(parent), unit_(unit), defaults_(defaults) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    addKinds(kinds, last.kind);
    addThread(last.radialPasses);
    addFigures();
    addHand(last.hand);
    addTabs(last.tabs);
    addSwitches(last);
    showLast(last);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
        for (Figure& figure : figures_) figure.edited = false; // values for roughing do not apply to finishing
        update();
        emit kindChanged();
    });
    update();
    setFocusProxy(kind_);
}

void PassForm::addKinds(const std::vector<PassKind>& kinds, PassKind chosen) {
    kind_ = new ChoiceBox(this);
    kind_->setObjectName(QStringLiteral("passKind"));
    for (const PassKindRow& row : passKinds) {
        if (!contains(kinds, row.kind)) continue;
        kind_->addItem(passWords(row.title), static_cast<int>(row.kind));
        kind_->setItemData(kind_->count() - 1, passWords(row.toolTip), Qt::ToolTipRole);
    }
    kind_->setCurrentIndex(std::max(0, kind_->findData(static_cast<int>(chosen))));
    layout()->addWidget(new FieldRow(tr("Pass"), kind_, tr("What the pass does"), this, FieldRow::choiceWidth));
}

void PassForm::addFigures() {
    const auto figure = [](double PassRequest::*member, const Kinds& kinds) {
        return Figure{nullptr, nullptr, member, nullptr, kinds};
    };
    const auto height = [](std::optional<double> PassRequest::*member, const Kinds& kinds) {
        return Figure{nullptr, nullptr, nullptr, member, kinds};
    };
    addFigure(figure(&PassRequest::allowance, millingKinds), "passAllowance", tr("Allowance"),
              tr("Stock that stays on the part"), Quantity::length, 0.0, largestAllowance);
    addFigure(figure(&PassRequest::stepOver, both(rowKinds, clearingKinds)), "passStepOver", tr("Step-over"),
              tr("Distance between rows or loops, or between the heights of a waterline"), Quantity::length, 0.0,
              widestStep);
    addFigure(figure(&PassRequest::scallop, rowKinds), "passScallop", tr("Scallop height"),
              tr("Largest height of the ridges between rows; replaces the step-over. 0: not used"), Quantity::length,
              0.0, widestStep);
    addFigure(figure(&PassRequest::levelDepth, levelKinds), "passLevelDepth", tr("Depth of a level"),
              tr("Largest depth of a level. Default: what material, tool and spindle can take"), Quantity::length, 0.0,
              widestStep);
    addFigure(figure(&PassRequest::levelDepth, {PassKind::drill}), "passPeck", tr("Depth of a peck"),
              tr("The drill comes up for its chips after each peck. 0: in one go up to three diameters, one diameter "
                 "at a time in deeper holes"),
              Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::stairs, {PassKind::levels}), "passStairs", tr("Steps on slopes"),
              tr("Largest height of the steps that the levels leave on slopes"), Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::depth, {PassKind::engrave}), "passDepth", tr("Depth"),
              tr("Depth of the lines below the top of the stock"), Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::depth, {PassKind::drill}), "passHoleDepth", tr("Depth"),
              tr("Depth of the tip below the top of the stock. 0: to the bottom of each hole of the part"),
              Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::pitch, {PassKind::thread}), "passPitch", tr("Pitch"),
              tr("Distance between neighbouring crests of the thread; 25.4 mm divided by the threads per inch"),
              Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::majorDiameter, {PassKind::thread}), "passMajorDiameter", tr("Major diameter"),
              tr("Of the thread. The part's holes must be modelled with this diameter, its studs with the minor "
                 "diameter that "
                 "the mill cuts. 0: as each picked hole or stud has it"),
              Quantity::length, 0.0, widestStep);
    addFigure(
        figure(&PassRequest::depth, {PassKind::thread}), "passThreadDepth", tr("Depth"),
        tr("Length of the thread below the top of its hole or stud. 0: as far as each hole is open and drilled, or as "
           "the tool has room around the stud"),
        Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::direction, {PassKind::parallel, PassKind::rest}), "passDirection", tr("Direction"),
              tr("Angle between the rows and X"), Quantity::angle, -pi, pi);
    addFigure(figure(&PassRequest::flattest, surfaceKinds), "passFlattest", tr("Steeper than"),
              tr("Only where the part is at least this steep"), Quantity::angle, 0.0, rightAngle);
    addFigure(figure(&PassRequest::steepest, surfaceKinds), "passSteepest", tr("Flatter than"),
              tr("Only where the part is at most this steep"), Quantity::angle, 0.0, rightAngle);
    addFigure(height(&PassRequest::top, levelKinds), "passTop", tr("From height"),
              tr("Height at which the pass begins, in the coordinates of the setup"), Quantity::length, -farthestInPlan,
              farthestInPlan);
    addFigure(height(&PassRequest::bottom, without(millingKinds, PassKind::engrave)), "passBottom",
              tr("Down to height"), tr("Lowest height of the tip, in the coordinates of the setup"), Quantity::length,
              -farthestInPlan, farthestInPlan);
}

/// What the rows do about strokes of the hand, and the values that belong to it.
void PassForm::addHand(HandStrokes chosen) {
    hand_ = new ChoiceBox(this);
    hand_->setObjectName(QStringLiteral("passHand"));
    handRow_ = new FieldRow(
        tr("Hand strokes"), hand_,
        tr("What the rows do where strokes of the hand, earlier in this path, have finished the part. Keep off: cut "
           "nothing there. Blend: go on over the border by the overlap, without a step. Extend: the rows of a flow "
           "continue these strokes sideways"),
        this, FieldRow::choiceWidth);
    layout()->addWidget(handRow_);
    offerHand(chosen);
    const auto figure = [](double PassRequest::*member) {
        return Figure{nullptr, nullptr, member, nullptr, surfaceKinds};
    };
    addFigure(figure(&PassRequest::overlap), "passOverlap", tr("Overlap"),
              tr("How far rows go on over the border of what the hand has finished"), Quantity::length, 0.01, 100.0);
    addFigure(figure(&PassRequest::finishedWithin), "passFinishedWithin", tr("Finished within"),
              tr("Largest height that the hand may have left on what counts as finished"), Quantity::length, 0.001,
              1.0);
    connect(hand_, &QComboBox::activated, this, [this] {
        update();
        emit kindChanged();
    });
}

void PassForm::offerHand(HandStrokes chosen) {
    QStringList texts{tr("ignore"), tr("keep off"), tr("blend")};
    if (kind() == PassKind::flow) texts.append(tr("extend"));
    QStringList ids;
    for (qsizetype i = 0; i < texts.size(); ++i) ids.append(QString::number(i));
    const auto index = static_cast<qsizetype>(chosen);
    hand_->offer(texts, ids, ids[index < ids.size() ? index : 0]);
}

HandStrokes PassForm::hand() const {
    return heedsHandStrokes(kind()) ? static_cast<HandStrokes>(std::max(0, hand_->currentIndex()))
                                    : HandStrokes::ignore;
}

bool PassForm::external() const {
    return kind() == PassKind::thread && std::ranges::any_of(switches_, [](const Switch& one) {
               return one.member == &PassRequest::external && one.box->isChecked();
           });
}

bool PassForm::extendsStrokes() const {
    return hand() == HandStrokes::extend;
}

void PassForm::addTabs(int count) {
    tabs_ = new CountField(0, mostTabs, count, this);
    tabs_->setObjectName(QStringLiteral("passTabs"));
    tabsRow_ = new FieldRow(tr("Holding tabs"), tabs_, tr("How many bridges stay on each outline"), this);
    layout()->addWidget(tabsRow_);
    connect(tabs_, &QSpinBox::valueChanged, this, [this] {
        update();
        emit changed();
    });
    const auto figure = [](double PassRequest::*member) {
        return Figure{nullptr, nullptr, member, nullptr, {PassKind::profile}};
    };
    addFigure(figure(&PassRequest::tabWidth), "passTabWidth", tr("Width of a tab"), tr("Along the outline"),
              Quantity::length, 0.01, widestStep);
    addFigure(figure(&PassRequest::tabHeight), "passTabHeight", tr("Height of a tab"),
              tr("Above the lowest level of the pass"), Quantity::length, 0.01, widestStep);
}

/// Standard sizes, which fill the fields of pitch and diameter, and the number of passes.
void PassForm::addThread(int radialPasses) {
    threadSize_ = new ChoiceBox(this);
    threadSize_->setObjectName(QStringLiteral("passThreadSize"));
    for (const ThreadSize& size : coarseThreads)
        threadSize_->addItem(QString::fromUtf8(size.name.data(), static_cast<qsizetype>(size.name.size())));
    threadSize_->addItem(tr("other thread"));
    threadSizeRow_ = new FieldRow(tr("Thread"), threadSize_, tr("Metric thread of coarse pitch, ISO 261"), this,
                                  FieldRow::choiceWidth);
    layout()->addWidget(threadSizeRow_);
    connect(threadSize_, &QComboBox::activated, this, &PassForm::takeThreadSize);
    radialPasses_ = new CountField(1, mostRadialPasses, radialPasses, this);
    radialPasses_->setObjectName(QStringLiteral("passRadialPasses"));
    radialPassesRow_ = new FieldRow(tr("Passes"), radialPasses_,
                                    tr("Number of passes along the thread, each deeper than the one before"), this);
    layout()->addWidget(radialPassesRow_);
    connect(radialPasses_, &QSpinBox::valueChanged, this, &PassForm::changed);
}

void PassForm::takeThreadSize(int index) {
    const auto size = static_cast<std::size_t>(index);
    if (size >= coarseThreads.size()) return; // the fields are free
    setFigure(&PassRequest::pitch, coarseThreads[size].pitch);
    setFigure(&PassRequest::majorDiameter, coarseThreads[size].diameter);
    emit changed();
}

void PassForm::setFigure(double PassRequest::*member, double value) {
    for (Figure& figure : figures_)
        if (figure.member == member) {
            figure.field->showValue(value);
            figure.edited = true;
        }
}

/// Selects the standard size that the fields state.
void PassForm::showThreadSize() {
    constexpr double same = 1e-6; // mm
    PassRequest stated;
    for (const Figure& figure : figures_)
        if (figure.member == &PassRequest::pitch || figure.member == &PassRequest::majorDiameter)
            stated.*figure.member = figure.field->value();
    const auto size = std::ranges::find_if(coarseThreads, [&](const ThreadSize& each) {
        return std::abs(each.pitch - stated.pitch) < same && std::abs(each.diameter - stated.majorDiameter) < same;
    });
    threadSize_->setCurrentIndex(static_cast<int>(size - coarseThreads.begin()));
}

void PassForm::addSwitches(const PassRequest& last) {
    const auto add = [&](bool PassRequest::*member, const Kinds& kinds, const char* name, const QString& label,
                         const QString& toolTip) {
        addSwitch({nullptr, member, kinds}, name, label, toolTip, last.*member);
    };
    add(&PassRequest::restOnly, without(surfaceKinds, PassKind::rest), "passRest", tr("Only where stock is left"),
        tr("Skips rows that would touch no stock"));
    add(&PassRequest::oneWay, {PassKind::parallel, PassKind::radial, PassKind::spiral, PassKind::flow, PassKind::rest},
        "passOneWay", tr("All rows in one direction"), tr("The tool returns through the air after each row"));
    add(&PassRequest::inside, {PassKind::profile}, "passInside", tr("Inside the outline"),
        tr("The cutter follows the outline of the area on its inside"));
    add(&PassRequest::dogbones, {PassKind::pocket, PassKind::profile}, "passDogbones", tr("Dogbones"),
        tr("Cuts into the inner corners of the area, so that a part with square corners fits"));
    add(&PassRequest::springPass, {PassKind::thread}, "passSpring", tr("Spring pass"),
        tr("Follows the thread once more at full depth"));
    add(&PassRequest::external, {PassKind::thread}, "passExternal", tr("External thread"),
        tr("On round studs of the part instead of in its holes; picking holes or studs in the view sets it"));
    connect(switches_.back().box, &QCheckBox::toggled, this, &PassForm::kindChanged);
    add(&PassRequest::leftHand, {PassKind::thread}, "passLeftHand", tr("Left-handed"),
        tr("Left-handed instead of right-handed thread"));
    add(&PassRequest::conventional, {PassKind::thread}, "passConventional", tr("Conventional milling"),
        tr("Conventional instead of climb milling: internal right-hand threads are cut from the top down, external "
           "ones "
           "from the bottom up"));
}

void PassForm::addFigure(Figure figure, const char* name, const QString& label, const QString& toolTip,
                         Quantity quantity, double low, double high) {
    figure.field = new QuantityField(quantity, this);
    figure.field->setObjectName(QLatin1String(name));
    figure.field->setLengthUnit(unit_);
    figure.field->limit(low, high);
    figure.row = new FieldRow(label, figure.field, toolTip, this);
    layout()->addWidget(figure.row);
    connect(figure.field, &QuantityField::valueEdited, this, [this, place = figures_.size()] {
        figures_[place].edited = true;
        showThreadSize();
        emit changed();
    });
    figures_.push_back(std::move(figure));
}

void PassForm::addSwitch(Switch one, const char* name, const QString& label, const QString& toolTip, bool on) {
    one.box = new QCheckBox(label, this);
    one.box->setObjectName(QLatin1String(name));
    one.box->setToolTip(toolTip);
    one.box->setChecked(on);
    layout()->addWidget(one.box);
    connect(one.box, &QCheckBox::toggled, this, &PassForm::changed);
    switches_.push_back(std::move(one));
}

/// Restores the previous values.
void PassForm::showLast(const PassRequest& last) {
    for (Figure& figure : figures_) {
        std::optional<double> value = figure.member != nullptr ? last.*figure.member : last.*figure.height;
        if (figure.member != nullptr && *value == PassRequest{}.*figure.member) value.reset();
        if (!value) continue;
        figure.field->showValue(*value);
        figure.edited = true;
    }
}

PassKind PassForm::kind() const {
    return static_cast<PassKind>(kind_->currentData().toInt());
}

double PassForm::defaultOf(const Figure& figure) const {
    constexpr double tabWidth = 5.0, tabHeight = 1.0; // mm
    const PassKind chosen = kind();
    if (figure.height == &PassRequest::top) return defaults_.top;
    if (figure.height == &PassRequest::bottom) return chosen == PassKind::face ? defaults_.partTop : defaults_.bottom;
    if (figure.member == &PassRequest::overlap) return usualOverlap;
    if (figure.member == &PassRequest::finishedWithin) return usualFinish;
    if (figure.member == &PassRequest::stepOver)
        return contains(clearingKinds, chosen) ? defaults_.roughStep : defaults_.fineStep;
    if (figure.member == &PassRequest::levelDepth) return chosen == PassKind::drill ? 0.0 : defaults_.levelDepth;
    if (figure.member == &PassRequest::stairs) return defaults_.stairs;
    if (figure.member == &PassRequest::steepest) return rightAngle;
    if (figure.member == &PassRequest::pitch) return defaults_.thread.pitch;
    if (figure.member == &PassRequest::majorDiameter) return defaults_.thread.diameter;
    if (figure.member == &PassRequest::tabWidth) return tabWidth;
    if (figure.member == &PassRequest::tabHeight) return tabHeight;
    return 0.0;
}

void PassForm::update() {
    const PassKind chosen = kind();
    for (const PassKindRow& row : passKinds)
        if (row.kind == chosen) kind_->setToolTip(passWords(row.toolTip));
    offerHand(static_cast<HandStrokes>(std::max(0, hand_->currentIndex())));
    handRow_->setVisible(heedsHandStrokes(chosen));
    tabsRow_->setVisible(chosen == PassKind::profile);
    for (FieldRow* row : {threadSizeRow_, radialPassesRow_}) row->setVisible(chosen == PassKind::thread);
    for (const Figure& figure : figures_) {
        if (!figure.edited) figure.field->showValue(defaultOf(figure));
        const bool ofTab = figure.member == &PassRequest::tabWidth || figure.member == &PassRequest::tabHeight;
        const bool ofHand = (figure.member == &PassRequest::overlap && hand() != HandStrokes::blend) ||
                            (figure.member == &PassRequest::finishedWithin && hand() == HandStrokes::ignore);
        figure.row->setVisible(contains(figure.kinds, chosen) && (!ofTab || tabs_->value() > 0) && !ofHand);
    }
    for (const Switch& one : switches_) one.box->setVisible(contains(one.kinds, chosen));
    showThreadSize();
}

void PassForm::commitTyping() {
    for (Figure& figure : figures_) {
        const double before = figure.field->value();
        figure.field->interpretText();
        figure.edited = figure.edited || figure.field->value() != before;
    }
    tabs_->interpretText();
    radialPasses_->interpretText();
}

void PassForm::writeTo(PassRequest& request) const {
    request.kind = kind();
    for (const Figure& figure : figures_) {
        if (!contains(figure.kinds, request.kind)) continue;
        if (figure.member != nullptr)
            request.*figure.member = figure.field->value();
        else if (figure.edited)
            request.*figure.height = figure.field->value();
    }
    if (request.steepest >= rightAngle) request.steepest = anySlope;
    if (request.scallop > 0.0) request.stepOver = 0.0; // an explicit step-over would take precedence
    request.tabs = request.kind == PassKind::profile ? tabs_->value() : 0;
    request.radialPasses = request.kind == PassKind::thread ? radialPasses_->value() : 1;
    request.hand = hand();
    if (request.hand != HandStrokes::blend) request.overlap = 0.0;
    if (request.hand == HandStrokes::ignore) request.finishedWithin = 0.0;
    if (request.tabs == 0) request.tabWidth = request.tabHeight = 0.0;
    for (const Switch& one : switches_)
        if (contains(one.kinds, request.kind)) request.*one.member = one.box->isChecked();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/meters.h"

#include "core/base/units.h"
#include "ui/panels/announcement.h"
#include "ui/panels/meter_bar.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"
#include "ui/theme/icon.h"

#include <QToolButton>

namespace burin {

namespace {

QString priorityText(SchedulingClass scheduling) {
    switch (scheduling) {
    case SchedulingClass::fifo:
        return Meters::tr("real time");
    case SchedulingClass::roundRobin:
        return Meters::tr("RealtimeKit");
    case SchedulingClass::nice:
        return Meters::tr("raised");
    case SchedulingClass::normal:
        break;
    }
    return Meters::tr("normal");
}

} // namespace

class Meters::Fields : public QObject {
public:
    explicit Fields(Meters* meters);
    void refresh();

    void fold(bool wanted);

    MeterState state;
    bool folded = true;
    LengthUnit unit = LengthUnit::millimetre;

private:
    ValueRow* addRow(const QString& label, const char* name, const QString& toolTip);
    MeterBar* addBar(ColourRole role, const QString& label);
    void addTitle();
    void addPosition();
    void showForce();
    void showFeed();

    Meters* meters_;
    QVBoxLayout* column_;
    ValueRow *stylus_, *force_, *removal_, *feed_, *rate_, *interval_, *work_, *missed_, *late_, *scheduling_, *x_, *y_,
        *z_;
    MeterBar *forceBar_, *removalBar_;
    bool atLimit_ = false; ///< whether the force has been reported to be at its limit
    QToolButton* unfold_;
};

Meters::Fields::Fields(Meters* meters) : QObject(meters), meters_(meters), column_(makePanelLayout(meters)) {
    column_->setSpacing(4);
    addTitle();
    force_ = addRow(Meters::tr("Force"), "forceMeter",
                    Meters::tr("Cutting force, not scaled; next to it the highest so far"));
    forceBar_ = addBar(&Palette::force, force_->accessibleName());
    removal_ = addRow(Meters::tr("Removal"), "removalMeter", Meters::tr("Material removed per second"));
    removalBar_ = addBar(&Palette::accent, removal_->accessibleName());
    feed_ = addRow(Meters::tr("Feed"), "feedMeter", {});
    addPosition();
    rate_ = addRow(Meters::tr("Haptic rate"), "rateMeter", Meters::tr("Ticks per second that are reached"));
    interval_ = addRow(Meters::tr("Interval, p99.9"), "intervalMeter",
                       Meters::tr("Interval between two forces that 999 of 1000 do not exceed"));
    work_ =
        addRow(Meters::tr("Work, p99.9"), "workMeter", Meters::tr("CPU time of a tick that 999 of 1000 do not exceed"));
    missed_ = addRow(Meters::tr("Missed"), "missedMeter", Meters::tr("Ticks that came too late"));
    late_ = addRow(Meters::tr("Withheld"), "lateMeter",
                   Meters::tr("Forces that were ready more than 3 ms after the one before, and not sent"));
    scheduling_ = addRow(
        Meters::tr("Priority"), "schedulingMeter",
        Meters::tr(
            "Scheduling that the system grants the haptic loop; the rtprio limit or RealtimeKit gives real time"));
    stylus_ = addRow(Meters::tr("Stylus"), "stylusName", Meters::tr("Stylus that moves the tool"));
    fold(true);
}

/// The title with the button that unfolds the loop's statistics, which are rarely needed while milling.
void Meters::Fields::addTitle() {
    auto* row = new QHBoxLayout;
    row->addWidget(makeSectionTitle(Meters::tr("Now"), meters_), 1);
    unfold_ = new QToolButton(meters_);
    unfold_->setObjectName(QStringLiteral("unfoldMetersButton"));
    unfold_->setProperty("look", "flat");
    connect(unfold_, &QToolButton::clicked, this, [this] {
        fold(!folded);
        emit meters_->foldedChanged(folded);
    });
    row->addWidget(unfold_);
    column_->addLayout(row);
}

void Meters::Fields::fold(bool wanted) {
    folded = wanted;
    for (ValueRow* row : {rate_, interval_, work_, missed_, late_, scheduling_, stylus_}) row->setVisible(!folded);
    unfold_->setIcon(
        themedIcon(folded ? QStringLiteral("chevron-right") : QStringLiteral("chevron-down"), &Palette::quietText));
    const QString does =
        folded ? Meters::tr("Show the values of the haptic loop") : Meters::tr("Hide the values of the haptic loop");
    unfold_->setToolTip(does);
    unfold_->setAccessibleName(does);
}

/// The three coordinates side by side, each at a fixed position regardless of the digits of the others.
void Meters::Fields::addPosition() {
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    for (auto [field, axis] : {std::pair{&x_, "X"}, {&y_, "Y"}, {&z_, "Z"}}) {
        *field = new ValueRow(QLatin1String(axis), meters_);
        (*field)->setObjectName(QStringLiteral("position") + QLatin1String(axis));
        row->addWidget(*field, 1);
    }
    column_->addLayout(row);
}

ValueRow* Meters::Fields::addRow(const QString& label, const char* name, const QString& toolTip) {
    auto* row = new ValueRow(label, meters_);
    row->setObjectName(QLatin1String(name));
    row->setToolTip(toolTip);
    column_->addWidget(row);
    return row;
}

/// @param label  of the row whose value the bar shows
MeterBar* Meters::Fields::addBar(ColourRole role, const QString& label) {
    auto* bar = new MeterBar(role, meters_);
    bar->setAccessibleName(label);
    column_->addWidget(bar);
    column_->addSpacing(4);
    return bar;
}

/// Shows the force relative to the limit of tool and spindle, red above it; if the limit is not known, relative to the
/// maximum so far.
void Meters::Fields::showForce() {
    const QLocale locale;
    const auto newtons = [&locale](double force) { return locale.toString(force, 'f', 1); };
    const bool limited = state.forceLimit > 0.0;
    const double scale = limited ? state.forceLimit : state.forceScale;
    const QString text = limited ? Meters::tr("%1 N, limit %2 N").arg(newtons(state.force), newtons(scale))
                                 : Meters::tr("%1 N of %2").arg(newtons(state.force), newtons(scale));
    const bool atLimit = state.running && limited && state.force >= scale;
    force_->setValue(state.running ? text : QStringLiteral("–"),
                     atLimit ? Meters::tr("%1, at the limit").arg(text) : QString());
    if (atLimit && !atLimit_) announce(*force_); // the bar shows it by its colour alone
    // A force that swings about its limit is announced once.
    constexpr double clearlyBelow = 0.9;
    atLimit_ = atLimit || (atLimit_ && state.running && limited && state.force > clearlyBelow * scale);
    forceBar_->setShare(state.running && scale > 0.0 ? state.force / scale : 0.0);
    forceBar_->setRole(limited && state.force < scale ? &Palette::accent : &Palette::force);
    force_->setToolTip(limited ? Meters::tr("Cutting force at the speed of the hand, not scaled. At the limit the bar "
                                            "turns red: %1")
                                     .arg(state.forceLimitOf)
                               : Meters::tr("Cutting force, not scaled; next to it the highest so far"));
}

void Meters::Fields::showFeed() {
    const bool proposes = state.running && state.proposed;
    QString toolTip =
        Meters::tr("Feed and spindle speed for the material under the tool and its engagement, from the cutting data. "
                   "Feeds of a path are set by its edits");
    if (proposes) {
        const ProposedFeed& proposed = *state.proposed;
        feed_->setValue(
            Meters::tr("%1 at %2").arg(feedText(proposed.feed, unit), spindleSpeedText(proposed.spindleSpeed)));
        toolTip = Meters::tr("%1, engagement %2°, depth %3. %4")
                      .arg(proposed.material, QLocale().toString(proposed.arc * 180.0 / pi, 'f', 0),
                           lengthText(proposed.depth, unit), proposed.bound);
    } else
        feed_->setValue(QStringLiteral("–"));
    feed_->setToolTip(toolTip);
}

void Meters::Fields::refresh() {
    const QString none = QStringLiteral("–");
    const bool runs = state.running;
    const QLocale locale;
    showForce();
    showFeed();
    removal_->setValue(runs ? rateText(state.removalRate, unit) : none);
    removalBar_->setShare(runs && state.removalScale > 0.0 ? state.removalRate / state.removalScale : 0.0);
    rate_->setValue(runs ? locale.toString(state.rateHz, 'f', 0) + QStringLiteral(" Hz") : none);
    interval_->setValue(runs ? locale.toString(1e-3 * state.intervalP999, 'f', 2) + QStringLiteral(" ms") : none);
    late_->setValue(runs ? countText(static_cast<std::size_t>(state.late)) : none);
    scheduling_->setValue(runs ? priorityText(state.scheduling) : none);
    work_->setValue(runs ? locale.toString(state.workP999, 'f', 0) + QStringLiteral(" µs") : none);
    missed_->setValue(runs ? countText(static_cast<std::size_t>(state.missed)) : none);
    const QString from = Meters::tr("Tip of the tool from program zero, in %1").arg(unitText(unit));
    for (auto [field, place] : {std::pair{x_, state.tip.x}, {y_, state.tip.y}, {z_, state.tip.z}}) {
        field->setValue(runs ? lengthNumber(place, unit) : none, runs ? lengthText(place, unit) : QString());
        field->setToolTip(from);
    }
    stylus_->setValue(state.stylus.isEmpty() ? none : state.stylus);
}

Meters::Meters(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("meters"));
    fields_->refresh();
}

void Meters::setUnit(LengthUnit unit) {
    fields_->unit = unit;
    fields_->refresh();
}

void Meters::setFolded(bool folded) {
    fields_->fold(folded);
}

bool Meters::folded() const {
    return fields_->folded;
}

void Meters::setState(const MeterState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin

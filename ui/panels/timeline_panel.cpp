// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/timeline_panel.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/texts.h"
#include "ui/theme/number_font.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace burin {

namespace {

/// Ids of the curves in settings, in the order of TrackCurve.
constexpr std::array curveIds{"force", "removal", "feed", "engagement", "push_back", "height", "deviation"};
static_assert(curveIds.size() == trackCurves);

constexpr int speedWidth = 76; // pixels

QString curveTip(TrackCurve curve) {
    switch (curve) {
    case TrackCurve::force:
        return TimelinePanel::tr("Cutting force on the tool.");
    case TrackCurve::removal:
        return TimelinePanel::tr("Volume removed per time.");
    case TrackCurve::feed:
        return TimelinePanel::tr("Speed of the tool tip.");
    case TrackCurve::engagement:
        return TimelinePanel::tr("Cross-section of the cut: volume removed per distance moved.");
    case TrackCurve::pushBack:
        return TimelinePanel::tr("Distance by which the part, a fixture or a guide held the hand back.");
    case TrackCurve::height:
        return TimelinePanel::tr("Z of the tip in the setup's coordinates.");
    case TrackCurve::deviation:
        return TimelinePanel::tr(
            "Distance of the tool from the part; negative: the tool is in the part. Distances above "
            "5 mm are drawn as 5 mm.");
    }
    return {};
}

QString speedText(double speed) {
    if (speed < 0.3) return TimelinePanel::tr("¼ ×");
    if (speed < 0.6) return TimelinePanel::tr("½ ×");
    return TimelinePanel::tr("%1 ×").arg(QLocale().toString(speed, 'f', 0));
}

} // namespace

TimelinePanel::TimelinePanel(const Offered& offered, QWidget* parent) : QFrame(parent), bar_(new QWidget(this)) {
    setObjectName(QStringLiteral("timelinePanel"));
    auto* bar = new QHBoxLayout(bar_);
    bar->setContentsMargins(0, 0, 0, 0);
    bar->setSpacing(4);
    view_ = new TimelineView(this);
    auto* curves = new QToolButton(bar_);
    curves->setObjectName(QStringLiteral("curvesButton"));
    curves->setText(tr("Curves"));
    curves->setToolTip(tr("Select the curves to draw."));
    curves->setPopupMode(QToolButton::InstantPopup);
    curves->setMenu(makeCurvesMenu());
    bar->addWidget(curves);
    bar->addStretch(1);
    QToolButton* punchIn = makeActionButton(offered.punchIn, "punch-in", "punchInButton");
    QToolButton* present = makeActionButton(offered.present, "present", "presentButton");
    start_ = makeIconButton(QStringLiteral("to-start"), tr("To the start"), QStringLiteral("timeStartButton"), this);
    play_ = makeActionButton(offered.play, "play", "playButton");
    end_ = makeIconButton(QStringLiteral("to-end"), tr("To the end"), QStringLiteral("timeEndButton"), this);
    speed_ = new ChoiceBox(this);
    speed_->setObjectName(QStringLiteral("playSpeed"));
    speed_->setFixedWidth(speedWidth);
    speed_->setAccessibleName(tr("Playback speed"));
    speed_->setToolTip(tr("Playback speed, as a multiple of real time."));
    for (const double speed : speeds) speed_->addItem(speedText(speed), speed);
    time_ = new QLabel(this);
    time_->setObjectName(QStringLiteral("timeLabel"));
    time_->setFont(numberFont(font()));
    for (QWidget* widget : std::initializer_list<QWidget*>{start_, play_, end_, speed_, time_, present, punchIn})
        bar->addWidget(widget);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(view_, 1);
    connect(start_, &QToolButton::clicked, this, [this] { emit sought(0.0); });
    connect(end_, &QToolButton::clicked, this, [this] { emit sought(all_); });
    connect(speed_, &QComboBox::activated, this,
            [this](int index) { emit speedChosen(speeds[static_cast<std::size_t>(index)]); });
    connect(view_, &TimelineView::sought, this, &TimelinePanel::sought);
    connect(view_, &TimelineView::playToggled, &offered.play, &QAction::trigger);
}

QMenu* TimelinePanel::makeCurvesMenu() {
    auto* menu = new QMenu(bar_);
    menu->setObjectName(QStringLiteral("curvesMenu"));
    menu->setToolTipsVisible(true);
    for (std::size_t i = 0; i < trackCurves; ++i) {
        const auto curve = static_cast<TrackCurve>(i);
        QAction* action = menu->addAction(curveName(curve));
        action->setObjectName(QStringLiteral("curve_%1").arg(QLatin1String(curveIds[i])));
        action->setToolTip(curveTip(curve));
        action->setCheckable(true);
        curves_[i] = action;
        connect(action, &QAction::toggled, this, [this, curve](bool on) {
            view_->showCurve(curve, on);
            emit curveShown(curve, on);
        });
    }
    return menu;
}

QToolButton* TimelinePanel::makeActionButton(QAction& action, const char* icon, const char* name) {
    QToolButton* button = makeIconButton(QLatin1String(icon), action.toolTip(), QLatin1String(name), this);
    const auto follow = [button, &action] { setEnabledKeepingFocus(button, action.isEnabled()); };
    follow();
    connect(&action, &QAction::changed, button, follow);
    connect(button, &QToolButton::clicked, &action, &QAction::trigger);
    return button;
}

void TimelinePanel::setState(const TimelinePanelState& state) {
    view_->setState(state.view);
    all_ = view_->all();
    for (QToolButton* button : {start_, end_}) setEnabledKeepingFocus(button, state.view.enabled);
    showIcon(play_, state.playing ? QStringLiteral("pause") : QStringLiteral("play"));
    const QSignalBlocker quiet(speed_);
    speed_->setCurrentIndex(speed_->findData(state.speed));
    showTime(state);
}

void TimelinePanel::showTime(const TimelinePanelState& state) {
    if (all_ <= 0.0)
        time_->setText(state.reading ? tr("Reading the takes…") : QString());
    else
        time_->setText(QStringLiteral("%1 / %2").arg(clockText(state.view.seconds, 3), clockText(all_, 3)));
    view_->sayTime(time_->text());
}

QStringList TimelinePanel::curves() const {
    QStringList on;
    for (std::size_t i = 0; i < trackCurves; ++i)
        if (curves_[i]->isChecked()) on.append(QLatin1String(curveIds[i]));
    return on;
}

void TimelinePanel::setCurves(const QStringList& curves) {
    for (std::size_t i = 0; i < trackCurves; ++i) curves_[i]->setChecked(curves.contains(QLatin1String(curveIds[i])));
}

} // namespace burin

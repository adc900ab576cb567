// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/excess_presenter.h"

#include "ui/panels/texts.h"
#include "ui/window/deviation_tolerance.h"

#include <QAction>
#include <QHelpEvent>
#include <QToolTip>

namespace burin {

ExcessPresenter::ExcessPresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.workpiece, &workbench.program, &workbench.mill}, parent), viewport_(viewport) {
    viewport.installEventFilter(this);
}

void ExcessPresenter::connectActions(const Actions& actions) {
    action_ = actions[ActionId::excess];
    connect(action_, &QAction::toggled, this, &Presenter::presentSoon);
    presentSoon();
}

std::optional<ExcessColours> ExcessPresenter::wanted() const {
    const std::shared_ptr<MillingContext>& milling = workbench_.workpiece.milling();
    if (action_ == nullptr || !action_->isChecked() || !milling || milling->part.triangles().empty()) return {};
    return ExcessColours{{milling, &milling->part}, deviationTolerance(workbench_)};
}

void ExcessPresenter::present() {
    std::optional<ExcessColours> now = wanted();
    if (now == shown_) return;
    shown_ = now;
    viewport_.setExcess(std::move(now));
}

bool ExcessPresenter::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &viewport_ || event->type() != QEvent::ToolTip || !shown_)
        return Presenter::eventFilter(watched, event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), textAt(help->pos()), &viewport_);
    return true;
}

/// Empty if the pointer is not on the workpiece.
QString ExcessPresenter::textAt(const QPointF& position) const {
    const std::optional<glm::dvec3> place = viewport_.pick(position);
    if (!place) return {};
    const double left = std::max(shown_->part->closest(*place).signedDistance, 0.0);
    return tr("%1 left on the part").arg(lengthText(left, unit()));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/comparison_presenter.h"

#include "ui/messages/messages.h"
#include "ui/panels/texts.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr int dialogMargin = 24;     // pixels between the dialog and the window's edge
constexpr double closestView = 60.0; // mm from the eye to the deviation that the view shows
const QString plus(QStringLiteral("+")), minus(QStringLiteral("−"));

/// @param text returns the text of an amount
template <class Text>
ComparedValue valueOf(double first, double second, const Text& text) {
    const double difference = second - first;
    const QString sign = difference > 0.0 ? plus : difference < 0.0 ? minus : QString();
    return {text(first), text(second), sign + text(std::abs(difference))};
}

void fillTotals(ComparisonState& state, const PathTotals& first, const PathTotals& second) {
    const auto length = [&state](double amount) { return lengthText(amount, state.unit); };
    const auto count = [](double amount) { return countText(static_cast<std::size_t>(amount)); };
    const auto counts = [&](std::size_t a, std::size_t b) {
        return valueOf(static_cast<double>(a), static_cast<double>(b), count);
    };
    state.cutting = valueOf(first.cutting, second.cutting, length);
    state.plunging = valueOf(first.plunging, second.plunging, length);
    state.air = valueOf(first.air, second.air, length);
    state.points = counts(first.points, second.points);
    state.arcs = counts(first.arcs, second.arcs);
    const auto time = [](double amount) { return clockText(amount, 1); };
    if (first.feedTime && second.feedTime) {
        state.time = valueOf(*first.feedTime, *second.feedTime, time);
    } else {
        if (first.feedTime) state.time.first = time(*first.feedTime);
        if (second.feedTime) state.time.second = time(*second.feedTime);
    }
}

void fillDeviations(ComparisonState& state, const PathDeviation& first, const PathDeviation& second) {
    const auto length = [&state](double amount) { return lengthText(amount, state.unit); };
    const auto farther = [&](const PathDeviation& deviation) {
        return QStringLiteral("%1 (%2)").arg(length(deviation.farther), shareText(deviation.fartherShare()));
    };
    state.deviates = true;
    state.largest = {length(first.largest), length(second.largest), {}};
    state.mean = {length(first.mean), length(second.mean), {}};
    state.farther = {farther(first), farther(second), {}};
}

/// Marks the parts that are too far, and with a dot the largest deviation of each path that exceeds the tolerance.
ComparisonMark markOf(const ComparedPaths& compared) {
    ComparisonMark mark{compared.second, {}};
    if (!compared.values.ofFirst || !compared.values.ofSecond) return mark;
    mark.farther = compared.values.ofFirst->fartherParts;
    for (const PathDeviation* each : {&*compared.values.ofFirst, &*compared.values.ofSecond})
        if (each->largest > compared.values.tolerance) mark.farther.push_back({each->largestAt});
    return mark;
}

} // namespace

ComparisonPresenter::ComparisonPresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.pathComparer, &workbench.path, &workbench.tool}, parent), viewport_(viewport) {}

void ComparisonPresenter::connectActions(const Actions& actions) {
    showPath_ = actions[ActionId::showPath];
    connect(actions[ActionId::comparePaths], &QAction::triggered, this, [this] {
        workbench_.pathComparer.open();
        if (workbench_.pathComparer.isOpen()) showDialog();
    });
}

void ComparisonPresenter::showDialog() {
    if (!dialog_) begin();
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

void ComparisonPresenter::begin() {
    PathComparer& comparer = workbench_.pathComparer;
    dialog_ = new ComparisonDialog(viewport_.window());
    connect(dialog_, &QDialog::finished, this, [this] {
        if (before_) viewport_.setCameraView(*std::exchange(before_, std::nullopt));
        workbench_.pathComparer.close();
    });
    connect(dialog_, &ComparisonDialog::toleranceEdited, &comparer, &PathComparer::setTolerance);
    connect(dialog_, &ComparisonDialog::largestRequested, this, &ComparisonPresenter::lookAtLargest);
    connect(dialog_, &ComparisonDialog::versionChosen, &comparer, [&comparer](int place) {
        const std::vector<PathVersion> versions = comparer.versions();
        if (place >= 0 && static_cast<std::size_t>(place) < versions.size())
            comparer.choose(versions[static_cast<std::size_t>(place)]);
    });
    viewport_.setPathVisible(true);
    present();
    // At the edge of the window, so that the paths stay visible.
    dialog_->adjustSize();
    const QRect window = viewport_.window()->geometry();
    dialog_->move(window.right() - dialog_->width() - dialogMargin, window.top() + dialogMargin);
}

/// Called when the user closes the dialog or the project is closed, so that another project is displayed correctly.
void ComparisonPresenter::end() {
    dialog_->disconnect();
    dialog_->hide();
    dialog_->deleteLater();
    dialog_ = nullptr;
    drawn_.reset();
    drawnOther_.reset();
    viewport_.setComparison({});
    viewport_.setPathVisible(showPath_->isChecked());
    before_.reset();
}

void ComparisonPresenter::present() {
    if (!dialog_) return;
    if (!workbench_.pathComparer.isOpen()) return end();
    dialog_->setState(state());
    const std::shared_ptr<const ComparedPaths> compared = workbench_.pathComparer.compared();
    const std::shared_ptr<const EvaluatedPath> other = workbench_.pathComparer.other();
    if (compared == drawn_ && other == drawnOther_) return;
    drawn_ = compared;
    drawnOther_ = other;
    viewport_.setComparison(compared ? markOf(*compared) : ComparisonMark{other, {}});
}

void ComparisonPresenter::lookAtLargest(bool ofSecond) {
    const std::shared_ptr<const ComparedPaths> compared = workbench_.pathComparer.compared();
    if (!compared || !compared->values.ofFirst || !compared->values.ofSecond) return;
    CameraView view = viewport_.cameraView();
    if (!before_) before_ = view;
    view.focus = (ofSecond ? *compared->values.ofSecond : *compared->values.ofFirst).largestAt;
    view.distance = std::min(view.distance, closestView);
    viewport_.setCameraView(view);
}

ComparisonState ComparisonPresenter::state() const {
    const PathComparer& comparer = workbench_.pathComparer;
    ComparisonState state;
    state.unit = unit();
    state.tolerance = comparer.tolerance();
    for (const PathVersion& version : comparer.versions()) {
        if (version == comparer.version()) state.version = static_cast<int>(state.versions.size());
        state.versions << nameOf(version);
    }
    if (const auto compared = comparer.compared()) {
        const PathDifference& values = compared->values;
        state.known = true;
        fillTotals(state, values.first, values.second);
        if (values.ofFirst && values.ofSecond) fillDeviations(state, *values.ofFirst, *values.ofSecond);
    }
    state.problem = comparer.problem() && !comparer.busy();
    if (state.problem)
        state.news = Messages::sentence(*comparer.problem());
    else if (comparer.busy())
        state.news = tr("The paths are being compared.");
    else if (!state.known)
        state.news = tr("Waits until both paths are up to date.");
    else if (!state.deviates)
        state.news = tr("One of the paths has no cuts: there is no deviation.");
    return state;
}

QString ComparisonPresenter::nameOf(const PathVersion& version) const {
    const PathController& path = workbench_.path;
    switch (version.kind) {
    case PathVersion::Kind::recorded:
        return tr("itself without edits, as recorded or computed");
    case PathVersion::Kind::withoutEdit:
        return tr("itself without edit %1: %2")
            .arg(QString::number(version.edit + 1),
                 Messages::text(titleOf(path.stored()->edits[version.edit].parameters)));
    case PathVersion::Kind::path:
        break;
    }
    const auto other = std::ranges::find(path.all(), version.path, &StoredPath::id);
    return tr("path %1, %2: %3")
        .arg(QString::number(other->id), QString::fromStdString(other->name),
             toolName(workbench_.tool.tools(), path.toolOf(other->id)));
}

} // namespace burin

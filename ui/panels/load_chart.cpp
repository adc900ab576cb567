// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/load_chart.h"

#include "ui/theme/colour.h"
#include "ui/theme/theme.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int chartHeight = 64, textHeight = 16; // pixels
constexpr double fillShare = 0.35;               // share of the force's colour below its line

constexpr double shortestPause = 1e-3; // s between two motions

} // namespace

LoadChart::LoadChart(QWidget* parent) : QWidget(parent) {
    setFixedHeight(chartHeight);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Cutting force over the machining time without tool changes, which are dotted lines; click to go to "
                  "the line that is cut at that time"));
    setAccessibleName(tr("Cutting force over the machining time"));
}

void LoadChart::setReport(std::shared_ptr<const VerifyReport> report) {
    if (report == report_) return;
    report_ = std::move(report);
    pauses_.clear();
    double end = 0.0;
    if (report_)
        for (const MotionTime& motion : report_->times) {
            if (motion.start - end > shortestPause) pauses_.push_back({end, motion.start - end});
            end = motion.start + motion.duration;
        }
    peak_ = 0.0;
    for (const LoadStep& load : loads()) peak_ = std::max(peak_, static_cast<double>(load.force));
    setAccessibleDescription(tr("Peak %1 N").arg(QLocale().toString(peak_, 'f', 1)));
    update();
}

void LoadChart::showTime(std::optional<double> seconds) {
    if (seconds == time_) return;
    time_ = seconds;
    update();
}

QSize LoadChart::sizeHint() const {
    return {200, chartHeight};
}

std::span<const LoadStep> LoadChart::loads() const {
    if (!report_) return {};
    return report_->loadSteps;
}

double LoadChart::seconds() const {
    return report_ ? shownAt(report_->machiningSeconds) : 0.0;
}

double LoadChart::shownAt(double time) const {
    double shown = time;
    for (const Pause& pause : pauses_) shown -= std::clamp(time - pause.start, 0.0, pause.length);
    return shown;
}

double LoadChart::timeAt(double shown) const {
    double time = shown;
    for (const Pause& pause : pauses_)
        if (time >= pause.start) time += pause.length;
    return time;
}

std::vector<double> LoadChart::columns(int count) const {
    std::vector<double> greatest(static_cast<std::size_t>(std::max(0, count)), 0.0);
    if (seconds() <= 0.0 || count <= 0) return greatest;
    const auto columnOf = [&](double time) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(time / seconds() * count), 0, count - 1));
    };
    for (const LoadStep& load : loads())
        for (std::size_t i = columnOf(shownAt(load.start)); i <= columnOf(shownAt(load.start + load.duration)); ++i)
            greatest[i] = std::max(greatest[i], static_cast<double>(load.force));
    return greatest;
}

void LoadChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& palette = activePalette();
    painter.fillRect(rect(), palette.field);
    const int bottom = height();
    const double high = bottom - textHeight;
    const std::vector<double> forces = columns(width());
    const QColor fill = mixed(palette.field, palette.force, fillShare);
    for (int x = 0; x < width(); ++x) {
        const double share = peak_ > 0.0 ? forces[static_cast<std::size_t>(x)] / peak_ : 0.0;
        const int top = bottom - static_cast<int>(std::lround(share * high));
        if (top >= bottom) continue;
        painter.fillRect(x, top, 1, bottom - top, fill);
        painter.fillRect(x, top, 1, 1, palette.force);
    }
    const auto lineAt = [&](double time) {
        const int x = static_cast<int>(std::lround(shownAt(time) / seconds() * (width() - 1)));
        painter.drawLine(x, 0, x, bottom);
    };
    if (seconds() > 0.0) {
        painter.setPen(QPen(palette.quietText, 1, Qt::DotLine));
        for (const Pause& pause : pauses_)
            if (pause.start > 0.0) lineAt(pause.start); // the first tool's change is at the beginning of the chart
        painter.setPen(palette.text);
        if (time_) lineAt(*time_);
    }
    painter.setPen(palette.quietText);
    painter.drawText(QRect(6, 1, width() - 12, textHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("Force, peak %1 N").arg(QLocale().toString(peak_, 'f', 1)));
}

const MotionLoad* LoadChart::at(double seconds) const {
    if (!report_) return nullptr;
    const std::vector<MotionLoad>& all = report_->loads;
    const auto behind = std::ranges::upper_bound(all, seconds, {}, &MotionLoad::start);
    return behind == all.begin() ? nullptr : &*std::prev(behind);
}

void LoadChart::choose(double x) {
    const MotionLoad* load = at(timeAt(std::clamp(x / std::max(1, width()), 0.0, 1.0) * seconds()));
    if (load != nullptr) emit lineChosen(static_cast<int>(load->line));
}

void LoadChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) choose(event->position().x());
}

void LoadChart::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) choose(event->position().x());
}

} // namespace burin

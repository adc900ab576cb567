// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/timeline_view.h"

#include "ui/panels/texts.h"
#include "ui/theme/colour.h"
#include "ui/theme/number_font.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr int labelWidth = 132, rulerHeight = 18, clipHeight = 26, laneGap = 4, edge = 8; // pixels
constexpr int leastLane = 20, usualLane = 34;
constexpr double shortestSeen = 0.2; // s: below that, individual samples would be visible
constexpr double zoomStep = 1.25;

/// The step of a ruler, s: the smallest round one that is not below `least`; an hour at most.
double niceStep(double least) {
    for (const double step :
         {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0})
        if (step >= least) return step;
    return 3600.0;
}

/// The number of decimals needed to label a ruler's step.
int decimalsOf(double step) {
    return step < 0.1 ? 2 : step < 1.0 ? 1 : 0;
}

/// Draws a line without gaps between adjacent columns that have values. @param topOf returns the pixel row of a value
template <class TopOf>
void paintLine(QPainter& painter, const std::vector<double>& values, const TopOf& topOf, const QColor& colour) {
    std::optional<int> before;
    for (std::size_t x = 0; x < values.size(); ++x) {
        if (std::isnan(values[x])) {
            before.reset();
            continue;
        }
        const int top = topOf(values[x]), from = before.value_or(top);
        painter.fillRect(labelWidth + static_cast<int>(x), std::min(from, top), 1, std::abs(from - top) + 1, colour);
        before = top;
    }
}

/// Whether two readings have the same takes, so that the visible interval stays meaningful.
bool haveSameTakes(const RecordedTime* one, const RecordedTime* other) {
    const auto same = [](const TakeTrack& track, const TakeTrack& second) {
        return track.info.id == second.info.id && track.info.sampleCount == second.info.sampleCount;
    };
    return one != nullptr && other != nullptr && std::ranges::equal(one->tracks, other->tracks, same);
}

} // namespace

TimelineView::TimelineView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("timelineView"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Timeline of the takes"));
    sayTime({});
    setMouseTracking(false);
}

void TimelineView::sayTime(const QString& time) {
    const QString keys = tr("Left and right arrow keys move through the time, Space plays, plus and minus zoom.");
    const QString said = time.isEmpty() ? keys : time + QStringLiteral(". ") + keys;
    if (said != accessibleDescription()) setAccessibleDescription(said);
}

void TimelineView::setState(const TimelineState& state) {
    const bool other = state.recorded != state_.recorded;
    if (other && !haveSameTakes(state.recorded.get(), state_.recorded.get())) begin_ = length_ = 0.0;
    if (!state.growing.empty()) begin_ = length_ = 0.0; // all of it, while it grows
    state_ = state;
    if (other) curves_.setRecorded(state_.recorded);
    curves_.setReference(state_.scored, state_.reference);
    if (length_ > 0.0 && (state_.seconds < begin_ || state_.seconds > begin_ + length_))
        moveTo(state_.seconds - 0.1 * length_); // playback continues beyond the visible interval
    update();
}

void TimelineView::setUnit(LengthUnit unit) {
    unit_ = unit;
    update();
}

void TimelineView::showCurve(TrackCurve curve, bool shown) {
    if (shown)
        shown_.insert(curve);
    else
        shown_.erase(curve);
    updateGeometry();
    update();
}

QSize TimelineView::sizeHint() const {
    return {600, rulerHeight + clipHeight + 2 * laneGap + static_cast<int>(shown_.size()) * (usualLane + laneGap)};
}

QSize TimelineView::minimumSizeHint() const {
    return {320, rulerHeight + clipHeight + 2 * laneGap + static_cast<int>(shown_.size()) * (leastLane + laneGap)};
}

double TimelineView::all() const {
    double all = state_.recorded ? state_.recorded->seconds() : 0.0;
    for (const GrowingClip& clip : state_.growing) all += clip.seconds;
    return all;
}

double TimelineView::secondsAt(double x) const {
    const double share = (x - labelWidth) / std::max(1, width() - labelWidth - edge);
    const double length = length_ > 0.0 ? length_ : all();
    return std::clamp(begin_ + share * length, 0.0, all());
}

double TimelineView::placeOf(double seconds) const {
    const double length = length_ > 0.0 ? length_ : all();
    if (!(length > 0.0)) return labelWidth;
    return labelWidth + (seconds - begin_) / length * std::max(1, width() - labelWidth - edge);
}

double TimelineView::startOf(std::size_t track) const {
    double start = 0.0;
    for (std::size_t i = 0; i < track; ++i) start += state_.recorded->tracks[i].seconds();
    return start;
}

std::optional<std::size_t> TimelineView::trackAt(double seconds) const {
    if (!state_.recorded) return std::nullopt;
    double start = 0.0;
    for (std::size_t i = 0; i < state_.recorded->tracks.size(); ++i) {
        start += state_.recorded->tracks[i].seconds();
        if (seconds < start) return i;
    }
    return std::nullopt;
}

std::vector<TimelineView::Lane> TimelineView::lanes() const {
    std::vector<Lane> lanes;
    if (shown_.empty()) return lanes;
    const int room = height() - rulerHeight - clipHeight - 2 * laneGap;
    const int each = room / static_cast<int>(shown_.size());
    int top = rulerHeight;
    for (const TrackCurve curve : shown_) {
        lanes.push_back({curve, QRect(0, top, width(), std::max(1, each - laneGap))});
        top += each;
    }
    return lanes;
}

QRect TimelineView::clipRow() const {
    return {labelWidth, height() - clipHeight - laneGap, std::max(1, width() - labelWidth - edge), clipHeight};
}

void TimelineView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& palette = activePalette();
    painter.fillRect(rect(), palette.panel);
    if (!state_.recorded || (state_.recorded->tracks.empty() && state_.growing.empty())) {
        painter.setPen(palette.quietText);
        painter.drawText(rect(), Qt::AlignCenter,
                         state_.program ? tr("The program's time is being read.")
                                        : tr("Takes appear here once something was milled."));
        return;
    }
    paintRuler(painter);
    for (const Lane& lane : lanes()) paintLane(painter, lane);
    paintClips(painter);
    paintGrowing(painter);
    paintPointed(painter);
    paintMarkers(painter);
    paintCursor(painter);
    if (hasFocus()) {
        painter.setPen(palette.accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void TimelineView::paintRuler(QPainter& painter) const {
    const Palette& palette = activePalette();
    const double length = length_ > 0.0 ? length_ : all();
    const double pixels = std::max(1, width() - labelWidth - edge);
    const double step = niceStep(70.0 * length / pixels);
    painter.setFont(numberFont(font()));
    for (double at = std::ceil(begin_ / step) * step; at <= begin_ + length + 1e-9; at += step) {
        const int x = static_cast<int>(std::lround(placeOf(at)));
        painter.setPen(palette.border);
        painter.drawLine(x, rulerHeight - 4, x, height() - laneGap);
        painter.setPen(palette.quietText);
        const QString text = clockText(at, decimalsOf(step));
        const int wide = painter.fontMetrics().horizontalAdvance(text);
        if (x + 4 + wide <= width()) painter.drawText(x + 4, rulerHeight - 5, text);
    }
    painter.setFont(font());
}

void TimelineView::paintLane(QPainter& painter, const Lane& lane) {
    const Palette& palette = activePalette();
    const QColor colour = palette.*curveColour(lane.curve);
    const TimelineCurves::Range& range = curves_.range(lane.curve);
    const int count = width() - labelWidth - edge;
    const QRect& area = lane.area;
    painter.setPen(palette.border);
    painter.drawLine(labelWidth, area.bottom(), width() - edge, area.bottom());
    const TimelineCurves::Window window{begin_, length_ > 0.0 ? length_ : all(), std::max(0, count)};
    const double scale = range.high > range.low ? (area.height() - 2) / (range.high - range.low) : 0.0;
    const auto topOf = [&](double value) {
        return area.bottom() - static_cast<int>(std::lround((std::min(value, range.high) - range.low) * scale));
    };
    const std::vector<double>& values = curves_.columns(lane.curve, window);
    const QColor fill = mixed(palette.panel, colour, 0.3);
    const int base = lane.curve == TrackCurve::deviation ? topOf(0.0) : area.bottom();
    for (int x = 0; x < count; ++x)
        if (const double value = values[static_cast<std::size_t>(x)]; !std::isnan(value))
            painter.fillRect(labelWidth + x, std::min(topOf(value), base), 1, std::abs(base - topOf(value)), fill);
    if (curves_.hasReference()) paintLine(painter, curves_.referenceColumns(lane.curve, window), topOf, palette.text);
    paintLine(painter, values, topOf, colour);
    const QRect label(edge, area.top(), labelWidth - 2 * edge, area.height());
    painter.setPen(palette.text);
    const bool twoLines = area.height() >= 2 * painter.fontMetrics().height() - 2;
    const Qt::Alignment place = Qt::AlignLeft | (twoLines ? Qt::AlignTop : Qt::AlignVCenter);
    painter.drawText(label, static_cast<int>(place),
                     painter.fontMetrics().elidedText(curveName(lane.curve), Qt::ElideRight, label.width()));
    if (!twoLines) return;
    painter.setPen(palette.quietText);
    const QString high = curveText(lane.curve, range.high, unit_);
    const QString text =
        lane.curve == TrackCurve::deviation && range.low < 0.0
            ? tr("%1 to %2", "lowest and highest value").arg(curveText(lane.curve, range.low, unit_), high)
            : tr("to %1").arg(high);
    painter.drawText(label, Qt::AlignLeft | Qt::AlignBottom,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, label.width()));
}

QString TimelineView::clipText(std::size_t track) const {
    const TakeInfo& info = state_.recorded->tracks[track].info;
    return state_.program ? QCoreApplication::translate("Resource", info.name.c_str()) : takeName(info.name);
}

void TimelineView::paintClips(QPainter& painter) const {
    const Palette& palette = activePalette();
    const QRect row = clipRow();
    painter.setPen(palette.text);
    painter.drawText(QRect(edge, row.top(), labelWidth - 2 * edge, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     state_.program ? tr("Tools") : tr("Takes"));
    painter.save();
    painter.setClipRect(row);
    double start = 0.0;
    for (std::size_t i = 0; i < state_.recorded->tracks.size(); ++i) {
        const TakeTrack& track = state_.recorded->tracks[i];
        const auto placeOfSample = [&](std::uint64_t sample) {
            return placeOf(start + static_cast<double>(sample) * track.info.tickPeriod);
        };
        const QRectF clip(
            QPointF(placeOf(start), row.top()),
            QPointF(std::max(placeOf(start) + 2.0, placeOf(start + track.seconds()) - 1.0), row.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(mixed(palette.panel, palette.part, 0.35));
        painter.drawRoundedRect(clip, 3, 3);
        for (const SampleRange& stroke : track.strokes) {
            const double left = placeOfSample(stroke.first), right = placeOfSample(stroke.first + stroke.count);
            painter.fillRect(QRectF(left, row.bottom() - 7, std::max(1.0, right - left), 5), palette.part);
        }
        for (const SampleRange& undone : track.undone) {
            const double left = placeOfSample(undone.first), right = placeOfSample(undone.first + undone.count);
            const QRectF gone(left, row.top(), std::max(1.0, right - left), row.height());
            painter.fillRect(gone, palette.panel);
            painter.fillRect(gone, QBrush(palette.quietText, Qt::BDiagPattern));
        }
        painter.setPen(QPen(palette.quietText, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        for (const SampleRange& off : track.switchedOff)
            painter.drawRect(QRectF(QPointF(placeOfSample(off.first), row.top()),
                                    QPointF(placeOfSample(off.first + off.count) - 1.0, row.bottom() - 1.0)));
        if (track.info.id == state_.chosen) {
            painter.setPen(QPen(palette.accent, 2));
            painter.drawRoundedRect(clip.adjusted(1, 1, -1, -1), 3, 3);
        }
        painter.setPen(palette.text);
        const QRectF text = clip.intersected(row).adjusted(6, 0, -4, -6);
        if (text.width() > 20)
            painter.drawText(
                text, Qt::AlignLeft | Qt::AlignVCenter,
                painter.fontMetrics().elidedText(clipText(i), Qt::ElideRight, static_cast<int>(text.width())));
        start += track.seconds();
    }
    painter.restore();
}

void TimelineView::paintMarkers(QPainter& painter) const {
    const Palette& palette = activePalette();
    for (const TimeMarker& marker : state_.markers) {
        const double x = std::round(placeOf(state_.recorded->secondsAt(marker.at)));
        if (x < labelWidth - 1 || x > width() - edge + 1) continue;
        painter.fillRect(QRectF(x, 2, 1, height() - 2 * laneGap), palette.guide);
        const QString name = QString::fromStdString(marker.name);
        const QRectF flag(x, 2, std::min(120, painter.fontMetrics().horizontalAdvance(name) + 10), rulerHeight - 4);
        painter.fillRect(flag, palette.guide);
        painter.setPen(palette.panel);
        painter.drawText(flag.adjusted(5, 0, -4, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(flag.width()) - 8));
    }
}

/// The marker whose flag is at a position; the newest is on top.
std::optional<std::size_t> TimelineView::markerAt(const QPointF& place) const {
    if (!state_.recorded || place.y() > rulerHeight) return std::nullopt;
    for (std::size_t i = state_.markers.size(); i-- > 0;) {
        const double x = placeOf(state_.recorded->secondsAt(state_.markers[i].at));
        const int wide = fontMetrics().horizontalAdvance(QString::fromStdString(state_.markers[i].name)) + 10;
        if (place.x() >= x - 3 && place.x() <= x + std::min(120, wide)) return i;
    }
    return std::nullopt;
}

void TimelineView::paintCursor(QPainter& painter) const {
    const Palette& palette = activePalette();
    const double x = placeOf(state_.seconds);
    if (x < labelWidth - 1 || x > width() - edge + 1) return;
    const QColor colour = state_.away ? palette.accent : palette.text;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{{x - 5, rulerHeight - 10.0}, {x + 5, rulerHeight - 10.0}, {x, rulerHeight - 2.0}});
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRectF(std::round(x), rulerHeight - 3, 1, height() - rulerHeight), colour);
}

void TimelineView::seek(double x) {
    if (state_.enabled) emit sought(secondsAt(x));
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const std::optional<std::size_t> marker = markerAt(event->position()); marker && state_.enabled)
        emit sought(state_.recorded->secondsAt(state_.markers[*marker].at));
    else
        seek(event->position().x());
    const std::optional<std::size_t> track = trackAt(secondsAt(event->position().x()));
    if (track && clipRow().contains(event->position().toPoint()))
        emit takeChosen(state_.recorded->tracks[*track].info.id);
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) seek(event->position().x());
}

/// Zooms to a clip so that it fills the view; a second double click shows everything.
void TimelineView::mouseDoubleClickEvent(QMouseEvent* event) {
    const std::optional<std::size_t> track = trackAt(secondsAt(event->position().x()));
    if (!track || !clipRow().contains(event->position().toPoint())) return;
    const double length = state_.recorded->tracks[*track].seconds();
    const bool fills = begin_ == startOf(*track) && length_ == length;
    length_ = fills ? 0.0 : length;
    begin_ = fills ? 0.0 : startOf(*track);
    update();
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QPoint place =
        byKey ? QPoint(static_cast<int>(placeOf(state_.seconds)), clipRow().center().y()) : event->pos();
    if (const std::optional<std::size_t> marker = markerAt(place); marker && state_.enabled)
        return emit markerMenuRequested(static_cast<int>(*marker), mapToGlobal(place));
    const double at = secondsAt(place.x());
    const std::optional<std::size_t> track = place.x() < labelWidth ? std::nullopt : trackAt(at);
    if (!track || !state_.enabled) return;
    const TakeInfo& info = state_.recorded->tracks[*track].info;
    const auto sample = static_cast<quint64>(std::max(0.0, at - startOf(*track)) / info.tickPeriod);
    emit menuRequested(info.id, std::min<quint64>(sample, info.sampleCount - 1), mapToGlobal(place));
}

void TimelineView::zoom(double factor, double at) {
    const double length = length_ > 0.0 ? length_ : all();
    if (!(length > 0.0)) return;
    const double share = (at - begin_) / length;
    length_ = std::clamp(length / factor, std::min(shortestSeen, all()), all());
    moveTo(at - share * length_);
}

void TimelineView::moveTo(double begin) {
    begin_ = std::clamp(begin, 0.0, std::max(0.0, all() - length_));
    update();
}

void TimelineView::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if ((event->modifiers() & Qt::ShiftModifier) != 0 || turned.y() == 0)
        moveTo(begin_ - 0.15 * notches * (length_ > 0.0 ? length_ : all()));
    else
        zoom(std::pow(zoomStep, notches), secondsAt(event->position().x()));
    event->accept();
}

void TimelineView::seekStroke(int direction) {
    constexpr double near = 1e-6; // s
    double best = direction < 0 ? 0.0 : all();
    double start = 0.0;
    for (const TakeTrack& track : state_.recorded->tracks) {
        const auto consider = [&](std::uint64_t sample) {
            const double at = start + static_cast<double>(sample) * track.info.tickPeriod;
            if (direction > 0 && at > state_.seconds + near) best = std::min(best, at);
            if (direction < 0 && at < state_.seconds - near) best = std::max(best, at);
        };
        for (const std::uint64_t step : track.steps) consider(step);
        if (track.steps.empty())
            for (const SampleRange& stroke : track.strokes) consider(stroke.first);
        start += track.seconds();
    }
    emit sought(best);
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    if (!state_.recorded || !state_.enabled) return QWidget::keyPressEvent(event);
    const double seen = length_ > 0.0 ? length_ : all();
    const bool far = (event->modifiers() & Qt::ControlModifier) != 0;
    const double step = seen / ((event->modifiers() & Qt::ShiftModifier) != 0 ? 1000.0 : 100.0);
    switch (event->key()) {
    case Qt::Key_Left:
        return far ? seekStroke(-1) : emit sought(std::max(0.0, state_.seconds - step));
    case Qt::Key_Right:
        return far ? seekStroke(1) : emit sought(std::min(all(), state_.seconds + step));
    case Qt::Key_Home:
        return emit sought(0.0);
    case Qt::Key_End:
        return emit sought(all());
    case Qt::Key_Space:
        return emit playToggled();
    case Qt::Key_Plus:
        return zoom(zoomStep, state_.seconds);
    case Qt::Key_Minus:
        return zoom(1.0 / zoomStep, state_.seconds);
    default:
        QWidget::keyPressEvent(event);
    }
}

/// Returns the value of the take, and of its reference at the same time from the start. Empty if the take has no value.
QString TimelineView::valueText(TrackCurve curve, std::size_t track, std::size_t bin) const {
    const auto place = static_cast<std::size_t>(curve);
    const TakeTrack& own = state_.recorded->tracks[track];
    if (bin >= own.curves[place].size()) return {};
    const QString text = curveText(curve, static_cast<double>(own.curves[place][bin]), unit_);
    const bool scored = state_.reference != 0 && own.info.id == state_.scored;
    const TakeTrack* reference = scored ? state_.recorded->trackOf(state_.reference) : nullptr;
    const double seconds = static_cast<double>(bin) * own.info.tickPeriod;
    const auto same = reference != nullptr ? static_cast<std::size_t>(seconds / reference->info.tickPeriod) : 0;
    if (reference == nullptr || same >= reference->curves[place].size())
        return tr("%1: %2").arg(curveName(curve), text);
    return tr("%1: %2, reference: %3")
        .arg(curveName(curve), text, curveText(curve, static_cast<double>(reference->curves[place][same]), unit_));
}

bool TimelineView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !state_.recorded) return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    if (const std::optional<std::size_t> marker = markerAt(help->pos())) {
        QToolTip::showText(help->globalPos(), QString::fromStdString(state_.markers[*marker].name), this);
        return true;
    }
    const double at = secondsAt(help->pos().x());
    const std::optional<std::size_t> track = help->pos().x() < labelWidth ? std::nullopt : trackAt(at);
    if (!track) {
        QToolTip::showText(help->globalPos(),
                           tr("Click or drag to go to that time. Mouse wheel: zoom; with Shift: scroll."), this);
        return true;
    }
    QStringList lines{tr("%1, %2").arg(clipText(*track), clockText(at, 2))};
    const auto bin =
        static_cast<std::size_t>((at - startOf(*track)) / (static_cast<double>(TakeTrack::samplesPerBin) *
                                                           state_.recorded->tracks[*track].info.tickPeriod));
    for (const TrackCurve curve : shown_)
        if (const QString text = valueText(curve, *track, bin); !text.isEmpty()) lines.append(text);
    QToolTip::showText(help->globalPos(), lines.join(QLatin1Char('\n')), this);
    return true;
}

} // namespace burin

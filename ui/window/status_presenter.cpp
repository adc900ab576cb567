// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/status_presenter.h"

#include "core/volume/operations/fingerprint.h"
#include "ui/panels/texts.h"

#include <QLocale>

#include <chrono>

namespace burin {

StatusPresenter::StatusPresenter(Workbench& workbench, const MeterPresenter& meters, const MillMode& mill,
                                 const Viewport& viewport, StatusLine& line, QObject* parent)
    : Presenter(workbench,
                {&workbench.document, &workbench.workpiece, &workbench.setup, &workbench.session, &workbench.styluses,
                 &workbench.path, &workbench.keeper},
                parent)
    , meters_(meters)
    , viewport_(viewport)
    , line_(line) {
    connect(&meters, &MeterPresenter::presented, this, &StatusPresenter::presentSession);
    connect(&workbench.tasks(), &TaskRunner::changed, this, &StatusPresenter::presentTask);
    connect(&line, &StatusLine::cancelRequested, &workbench.tasks(), &TaskRunner::cancelAll);
    connect(&mill, &MillMode::toolChanged, this, &Presenter::presentSoon);
    connect(&viewport, &Viewport::interactiveToolChanged, this, &Presenter::presentSoon);
    minute_.setInterval(std::chrono::seconds(20)); // for "saved 3 minutes ago"
    connect(&minute_, &QTimer::timeout, this, &Presenter::presentSoon);
    minute_.start();
}

QString StatusPresenter::savedText() const {
    const DocumentController& document = workbench_.document;
    if (!document.isOpen()) return {};
    if (document.readOnly()) return tr("Read only");
    if (document.unsaved()) return document.isUnnamed() ? tr("Not saved yet") : tr("Unsaved changes");
    if (!document.savedAt().isValid()) return document.isUnnamed() ? QString() : tr("Saved");
    const qint64 minutes = document.savedAt().secsTo(QDateTime::currentDateTime()) / 60;
    if (minutes < 1) return tr("Saved just now");
    if (minutes == 1) return tr("Saved 1 minute ago");
    return minutes < 60 ? tr("Saved %n minutes ago", nullptr, static_cast<int>(minutes))
                        : tr("Saved at %1").arg(QLocale().toString(document.savedAt().time(), QLocale::ShortFormat));
}

void StatusPresenter::present() {
    line_.setSaved(savedText());
    const auto& milling = workbench_.workpiece.milling();
    if (!milling) {
        line_.setSize({});
    } else {
        const glm::ivec3 count = milling->embedded.workpiece.grid().count();
        const double megabytes = static_cast<double>(milling->embedded.workpiece.reservedBytes()) / 1e6;
        const QLocale locale;
        QString text = tr("%1 × %2 × %3 voxels · %4 MB")
                           .arg(locale.toString(count.x), locale.toString(count.y), locale.toString(count.z),
                                locale.toString(megabytes, 'f', 0));
        if (const auto& hash = workbench_.keeper.hash())
            text += QStringLiteral(" · ") + tr("hash %1").arg(QString::fromStdString(fingerprintText(*hash)));
        line_.setSize(text);
    }
    presentSession();
}

/// " · battery 42 %", if reported by the device.
QString StatusPresenter::healthText() const {
    if (!workbench_.hand.hasDevice()) return {};
    const DeviceHealth& health = workbench_.hand.health();
    QString text;
    if (health.batteryShare) text += QStringLiteral(" · ") + tr("battery %1").arg(shareText(*health.batteryShare));
    if (health.motorHeat) text += QStringLiteral(" · ") + tr("motors %1").arg(shareText(*health.motorHeat));
    return text;
}

void StatusPresenter::presentStroke() {
    const SessionState& session = workbench_.session.state();
    const bool recording = workbench_.session.running() && session.recording;
    line_.setRecording(recording ? tr("● Recording %1").arg(durationText(session.recordedSeconds)) : QString());
    InteractiveTool* tool = viewport_.interactiveTool();
    InteractiveTool* handles = viewport_.handleTool();
    const QString meaning = handles != nullptr ? handles->escapeMeaning() : QString();
    line_.setEscape(meaning.isEmpty() && tool != nullptr ? tool->escapeMeaning() : meaning);
}

void StatusPresenter::presentSession() {
    presentStroke();
    const MeterState& state = meters_.state();
    if (!workbench_.session.running()) {
        line_.setStylus(workbench_.workpiece.ready() ? workbench_.styluses.chosenName() : QString(), false);
        line_.setRate({});
        line_.setPosition({});
        return;
    }
    const QLocale locale;
    line_.setStylus(state.stylus + healthText(), true);
    line_.setRate(tr("%1 Hz · p99.9 %2 ms, work %3 µs · %4 missed")
                      .arg(locale.toString(state.rateHz, 'f', 0), locale.toString(1e-3 * state.intervalP999, 'f', 2),
                           locale.toString(state.workP999, 'f', 0), locale.toString(state.missed)));
    line_.setPosition(QStringLiteral("X %1  Y %2  Z %3 %4")
                          .arg(lengthNumber(state.tip.x, unit()), lengthNumber(state.tip.y, unit()),
                               lengthNumber(state.tip.z, unit()), unitText(unit())));
}

void StatusPresenter::presentTask() {
    const std::vector<TaskRow> rows = workbench_.tasks().rows();
    if (rows.empty())
        line_.setTask({}, 0.0, false);
    else
        line_.setTask(rows.front().step.isEmpty()
                          ? rows.front().title
                          : QStringLiteral("%1 · %2").arg(rows.front().title, rows.front().step),
                      rows.front().fraction, rows.front().cancelling);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/status_line.h"

#include "ui/panels/elided_label.h"

#include <QFontDatabase>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <cmath>

namespace burin {

StatusLine::StatusLine(QWidget* parent) : QStatusBar(parent) {
    setObjectName(QStringLiteral("statusLine"));
    setSizeGripEnabled(false);
    recording_ = add("recordingStatus", tr("Everything that is cut is recorded in this take."));
    recording_->setProperty("look", "force");
    escape_ = add("escapeStatus", tr("Effect of the Escape key."));
    stylus_ = add("stylusStatus", tr("Stylus that moves the tool."));
    rate_ = add("rateStatus", {}, new ElidedLabel({}, this)); // the first to be elided in a narrow window
    position_ = add("positionStatus", tr("Position of the tool tip, in the coordinates of the program."));
    size_ = add("sizeStatus", tr("Voxels of the workpiece, the memory reserved for it, and a hash of it: the same "
                                 "recordings and settings give the same hash."));
    saved_ = add("savedStatus", tr("Whether all changes are saved in the project file."));
    task_ = new ElidedLabel({}, this);
    task_->setObjectName(QStringLiteral("taskStatus"));
    task_->setToolTip(tr("Work in the background."));
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("taskProgress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedSize(112, 8);
    progress_->setToolTip(tr("Progress of the work in the background."));
    progress_->setAccessibleName(progress_->toolTip());
    cancel_ = new QToolButton(this);
    cancel_->setObjectName(QStringLiteral("cancelTaskButton"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stop the work in the background."));
    cancel_->setAutoRaise(true);
    connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelRequested);
    addPermanentWidget(task_);
    addPermanentWidget(progress_);
    addPermanentWidget(cancel_);
    setTask({}, 0.0, false);
}

QLabel* StatusLine::add(const char* name, const QString& toolTip) {
    return add(name, toolTip, new QLabel(this));
}

QLabel* StatusLine::add(const char* name, const QString& toolTip, QLabel* label) {
    label->setObjectName(QString::fromLatin1(name));
    label->setToolTip(toolTip);
    label->setContentsMargins(8, 0, 8, 0);
    addWidget(label);
    label->hide();
    return label;
}

namespace {

void put(QLabel* label, const QString& text) {
    if (label->text() == text) return;
    label->setText(text);
    label->setVisible(!text.isEmpty());
}

} // namespace

void StatusLine::setStylus(const QString& text, bool running) {
    put(stylus_, text.isEmpty() ? text : (running ? QStringLiteral("● ") : QStringLiteral("○ ")) + text);
}

void StatusLine::setRecording(const QString& text) {
    put(recording_, text);
}

void StatusLine::setEscape(const QString& text) {
    escapeText_ = text;
    showEscape();
}

void StatusLine::setPageEscape(const QString& text, bool counts) {
    pageEscape_ = text;
    pageCounts_ = counts;
    showEscape();
}

void StatusLine::showEscape() {
    put(escape_, pageCounts_ ? pageEscape_ : escapeText_);
}

void StatusLine::setRate(const QString& text) {
    put(rate_, text);
    const QString explanation = tr("Haptic loop: ticks per second; interval between two forces and computing time of a "
                                   "tick, neither of which 999 of 1000 exceed; ticks missed.");
    rate_->setToolTip(text + QLatin1Char('\n') + explanation);
}

void StatusLine::setPosition(const QString& text) {
    put(position_, text);
}

void StatusLine::setSize(const QString& text) {
    put(size_, text);
}

void StatusLine::setSaved(const QString& text) {
    put(saved_, text);
}

void StatusLine::setTask(const QString& title, double fraction, bool cancelling) {
    task_->setText(cancelling ? tr("Stopping") : title);
    if (!title.isEmpty()) task_->setToolTip(title); // the label may be elided
    progress_->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
    for (QWidget* widget : std::initializer_list<QWidget*>{task_, progress_, cancel_})
        widget->setVisible(!title.isEmpty());
    cancel_->setEnabled(!cancelling);
}

} // namespace burin

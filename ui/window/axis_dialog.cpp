// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/axis_dialog.h"

#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/notice.h"
#include "ui/window/axis_rows.h"

#include <QBoxLayout>
#include <QScrollArea>

#include <utility>

namespace burin {

namespace {

constexpr QSize axisDialogSize(980, 620); // pixels

} // namespace

AxisDialog::AxisDialog(AxisTuner& tuner, const StylusController::Choice& device, std::string kept, QWidget* parent)
    : QDialog(parent), tuner_(tuner), kept_(std::move(kept)) {
    setObjectName(QStringLiteral("axisDialog"));
    setWindowTitle(tr("Axes and buttons: %1").arg(device.name));
    layOut();
    resize(axisDialogSize);
    connect(&tuner_, &AxisTuner::connected, this, &AxisDialog::build);
    connect(&tuner_, &AxisTuner::heard, this, &AxisDialog::showState);
    connect(&tuner_, &AxisTuner::changed, this, &AxisDialog::showState);
    connect(&tuner_, &AxisTuner::calibrated, this, &AxisDialog::takeCalibration);
    tuner_.begin(device);
    showState();
}

AxisDialog::~AxisDialog() {
    tuner_.end();
}

void AxisDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    area_ = new QScrollArea(this);
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setAccessibleName(windowTitle());
    column->addWidget(area_, 1);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("axisNotice"));
    column->addWidget(notice_);
    calibrate_ = makeButton(tr("Calibrate"), {}, QStringLiteral("calibrateAxesButton"), this);
    stop_ = makeButton(tr("Stop calibrating"), {}, QStringLiteral("stopCalibratingButton"), this);
    undo_ = makeButton(tr("Undo"), QStringLiteral("undo"), QStringLiteral("undoAxesButton"), this);
    usual_ = makeButton(tr("Usual assignment"), {}, QStringLiteral("usualAxesButton"), this);
    keep_ = makePrimaryButton(tr("Keep"), QStringLiteral("keepAxesButton"), this);
    auto* cancel = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelAxesButton"), this);
    auto* row = new QHBoxLayout;
    for (QWidget* button : {calibrate_, stop_, undo_, usual_}) row->addWidget(button);
    row->addStretch(1);
    row->addWidget(keep_);
    row->addWidget(cancel);
    column->addLayout(row);
    connect(calibrate_, &QPushButton::clicked, this, &AxisDialog::calibrateOrFinish);
    connect(stop_, &QPushButton::clicked, &tuner_, &AxisTuner::cancelCalibration);
    connect(undo_, &QPushButton::clicked, this, &AxisDialog::undo);
    connect(usual_, &QPushButton::clicked, this, [this] {
        if (tuner_.device()) change(tuner_.device()->usual);
    });
    connect(keep_, &QPushButton::clicked, this, &AxisDialog::tryAccept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

/// As soon as the device is connected.
void AxisDialog::build() {
    const MappableDevice& device = *tuner_.device();
    map_ = device.usual;
    if (!kept_.empty())
        if (const Result<AxisMap> kept = axisMapFromJson(kept_, device); kept) map_ = *kept;
    rows_ = new AxisRows(device, area_);
    rows_->showMap(map_);
    area_->setWidget(rows_);
    connect(rows_, &AxisRows::mapEdited, this, &AxisDialog::change);
    showState();
}

void AxisDialog::change(const AxisMap& map) {
    if (map == map_) return;
    earlier_.push_back(std::exchange(map_, map));
    fault_.clear();
    rows_->showMap(map_);
    showState();
}

void AxisDialog::undo() {
    if (earlier_.empty()) return;
    map_ = earlier_.back();
    earlier_.pop_back();
    fault_.clear();
    rows_->showMap(map_);
    showState();
}

void AxisDialog::calibrateOrFinish() {
    if (tuner_.phase() == AxisTuner::Phase::moving)
        tuner_.finish();
    else
        tuner_.calibrate(map_);
    unmeasured_.clear();
}

/// Many devices report an axis only once it was moved; until then it reads exactly 0.
void AxisDialog::noteMotion() {
    if (!tuner_.device() || tuner_.phase() == AxisTuner::Phase::moving) return;
    moved_.resize(tuner_.device()->axes.size());
    for (std::size_t i = 0; i < moved_.size(); ++i)
        if (tuner_.reading().values[i] != 0.0) moved_[i] = true;
}

void AxisDialog::takeCalibration(const AxisMap& map) {
    QStringList still;
    for (std::size_t i = 0; i < moved_.size(); ++i)
        if (const DeviceAxis& axis = tuner_.device()->axes[i]; axis.springs && !moved_[i])
            still << Messages::text({"Device", axis.name.c_str()});
    change(map);
    if (!still.isEmpty())
        unmeasured_ = tr("Axes that were not moved before the measurement keep their rest and dead zone (%1); move "
                         "every axis once first, then calibrate again.")
                          .arg(still.join(QStringLiteral(", ")));
    showState();
}

void AxisDialog::tryAccept() {
    if (!tuner_.device()) return reject(); // nothing was changed
    if (const Result<void> good = checkAxisMap(map_, *tuner_.device()); !good) {
        fault_ = Messages::sentence(good.error());
        return showState();
    }
    kept_ = map_ == tuner_.device()->usual ? std::string() : toJson(map_, *tuner_.device());
    accept();
}

std::string AxisDialog::kept() const {
    return kept_;
}

void AxisDialog::showState() {
    using Phase = AxisTuner::Phase;
    const Phase phase = tuner_.phase();
    const bool connected = rows_ != nullptr, calibrates = phase == Phase::resting || phase == Phase::moving;
    noteMotion();
    if (connected) {
        rows_->showReading(tuner_.reading());
        rows_->setEnabled(!calibrates);
    }
    calibrate_->setText(phase == Phase::moving ? tr("Finish") : tr("Calibrate"));
    enableUnless(calibrate_,
                 phase == Phase::away      ? tr("The device is not connected.")
                 : phase == Phase::resting ? tr("The rest position is being measured.")
                                           : QString(),
                 phase == Phase::moving
                     ? tr("Press this when every axis has been at both of its ends")
                     : tr("Measure rest position, noise and ends of the axes: two seconds at rest, then move them"));
    stop_->setVisible(calibrates);
    undo_->setEnabled(!earlier_.empty() && !calibrates);
    usual_->setEnabled(connected && !calibrates);
    keep_->setEnabled(connected && !calibrates);
    if (tuner_.fault())
        notice_->tell(Notice::Kind::error, Messages::sentence(*tuner_.fault()));
    else if (!fault_.isEmpty())
        notice_->tell(Notice::Kind::error, fault_);
    else if (phase == Phase::resting)
        notice_->tell(Notice::Kind::information, tr("Leave the device at rest for two seconds."));
    else if (phase == Phase::moving)
        notice_->tell(Notice::Kind::information, tr("Move every axis to both of its ends, then press Finish."));
    else if (phase == Phase::away)
        notice_->tell(Notice::Kind::information, tr("Connecting the device…"));
    else if (!unmeasured_.isEmpty())
        notice_->tell(Notice::Kind::warning, unmeasured_);
    else
        notice_->tell(Notice::Kind::information,
                      tr("Move the device: each bar shows its axis, a dot the pressed buttons."));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/calibration_dialog.h"

#include "core/base/numbers.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/details.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/notice.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr QSize firstSize(680, 620);
constexpr std::array laws{ChipLaw::edge, ChipLaw::constant, ChipLaw::kienzle};
constexpr std::array projections{ForceProjection::turningTeeth, ForceProjection::feedAndAxis};

QString textOf(const MaterialCalibration& found) {
    const auto confidence = [](const Confidence& value) { return QString::fromStdString(burin::textOf(value)); };
    const auto fixed = [](double value, int digits) { return QString::fromStdString(formatFixed(value, digits)); };
    QStringList lines{CalibrationDialog::tr("%1: %2 of %3 records, noise %4 N tangential, %5 N radial")
                          .arg(QString::fromStdString(found.material))
                          .arg(found.residuals.size())
                          .arg(found.records)
                          .arg(fixed(found.tangentialNoise, 3), fixed(found.radialNoise, 3)),
                      CalibrationDialog::tr("K = %1 J/mm³ at chips of %2 mm")
                          .arg(confidence(found.specificEnergy), fixed(found.chip, 4)),
                      CalibrationDialog::tr("Kr = %1").arg(confidence(found.radialRatio))};
    if (found.options.law == ChipLaw::kienzle)
        lines << CalibrationDialog::tr("kc1.1 = %1 N/mm², mc = %2")
                     .arg(confidence(found.kienzleForce), confidence(found.kienzleExponent));
    if (found.options.law == ChipLaw::edge)
        lines << CalibrationDialog::tr("Kte = %1 N/mm, Kre = %2 N/mm")
                     .arg(confidence(found.edgeForce), confidence(found.radialEdgeForce));
    for (const LeftOut& record : found.leftOut)
        lines << CalibrationDialog::tr("Line %1 left out: %2").arg(record.line).arg(detailText(record.reason));
    return lines.join(QLatin1Char('\n'));
}

} // namespace

CalibrationDialog::CalibrationDialog(const std::vector<Property>& materials, const std::string& like, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("calibrationDialog"));
    setWindowTitle(tr("Calibrate materials"));
    layOut();
    like_->addItem(tr("No other material"));
    for (const Property& material : materials) {
        ids_.push_back(material.id);
        like_->addItem(QCoreApplication::translate("Resource", material.name.c_str()));
        if (material.id == like) like_->setCurrentIndex(static_cast<int>(ids_.size()));
    }
    resize(firstSize);
    choose_->setFocus();
}

void CalibrationDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    choose_ = makeButton(tr("Choose a file…"), QStringLiteral("import"), QStringLiteral("forceFileButton"), this);
    column->addWidget(new FieldRow(tr("Measured forces"), choose_,
                                   tr("CSV with a row for each cut; `burin calibrate --help` lists the columns"), this,
                                   FieldRow::choiceWidth));
    law_ = new ChoiceBox(this);
    law_->setObjectName(QStringLiteral("chipLaw"));
    law_->addItems({tr("K and the force of the edge"), tr("K alone"), tr("Kienzle: K falls with the chip")});
    column->addWidget(new FieldRow(tr("Law"), law_, tr("How the force depends on the thickness of the chip"), this,
                                   FieldRow::choiceWidth));
    projection_ = new ChoiceBox(this);
    projection_->setObjectName(QStringLiteral("forceProjection"));
    projection_->addItems({tr("Rotating teeth"), tr("Feed and axis")});
    column->addWidget(new FieldRow(tr("Forces resolved for"), projection_,
                                   tr("Rotating teeth: forces of a dynamometer. Feed and axis: the force that the hand "
                                      "feels against its motion"),
                                   this, FieldRow::choiceWidth));
    like_ = new ChoiceBox(this);
    like_->setObjectName(QStringLiteral("likeMaterial"));
    column->addWidget(new FieldRow(tr("New materials are like"), like_,
                                   tr("Whose other values a material takes over that is not in the library"), this,
                                   FieldRow::choiceWidth));
    workpiece_ = new NamedSwitch(QStringLiteral("forcesOnWorkpiece"),
                                 tr("On: the forces act on the workpiece, as a dynamometer below it measures. Off: on "
                                    "the tool"),
                                 this);
    workpiece_->show(tr("Forces on the workpiece"), onWorkpiece_, {});
    column->addWidget(workpiece_);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("calibrationNotice"));
    column->addWidget(notice_);
    result_ = new QLabel;
    result_->setObjectName(QStringLiteral("calibrationResult"));
    result_->setWordWrap(true);
    result_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    result_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* area = new QScrollArea(this);
    area->setWidget(result_);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setAccessibleName(tr("Result of the calibration"));
    column->addWidget(area, 1);
    keep_ = makePrimaryButton(tr("Keep in the library"), QStringLiteral("keepCalibrationButton"), this);
    auto* close = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelCalibrationButton"), this);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(keep_);
    row->addWidget(close);
    column->addLayout(row);
    enableUnless(keep_, tr("Choose a file of measured forces first."), {});
    connect(choose_, &QPushButton::clicked, this, &CalibrationDialog::chooseFile);
    for (ChoiceBox* box : {law_, projection_, like_})
        connect(box, &QComboBox::activated, this, &CalibrationDialog::fit);
    connect(workpiece_, &NamedSwitch::switched, this, [this](bool on) {
        onWorkpiece_ = on;
        workpiece_->show(tr("Forces on the workpiece"), on, {});
        fit();
    });
    connect(keep_, &QPushButton::clicked, this, &QDialog::accept);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void CalibrationDialog::chooseFile() {
    const QString file = askForcesToRead(this, file_.isEmpty() ? QDir::homePath() : QFileInfo(file_).path());
    if (file.isEmpty()) return;
    file_ = file;
    constexpr int frame = 60; // of the button, with its icon, px
    choose_->setText(
        choose_->fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle, FieldRow::choiceWidth - frame));
    fit();
}

CalibrationRequest CalibrationDialog::request() const {
    CalibrationRequest request;
    request.forces = file_.toStdString();
    if (like_->currentIndex() > 0) request.like = ids_[static_cast<std::size_t>(like_->currentIndex() - 1)];
    request.options.law = laws[static_cast<std::size_t>(law_->currentIndex())];
    request.options.projection = projections[static_cast<std::size_t>(projection_->currentIndex())];
    request.options.forcesOnWorkpiece = onWorkpiece_;
    return request;
}

void CalibrationDialog::fit() {
    if (file_.isEmpty()) return;
    calibrated_.clear();
    const Result<std::vector<CalibratedMaterial>> made = calibrateMaterials(request());
    if (!made) {
        result_->clear();
        notice_->tell(Notice::Kind::error, Messages::sentence(made.error()));
        enableUnless(keep_, tr("There is nothing to keep yet."), {});
        return;
    }
    QStringList texts;
    for (const CalibratedMaterial& one : *made) {
        texts << textOf(one.calibration);
        calibrated_.push_back(one.material);
    }
    result_->setText(texts.join(QStringLiteral("\n\n")));
    notice_->tell(Notice::Kind::information,
                  tr("In brackets: the interval that holds the true value in 95 % of such measurements."));
    enableUnless(keep_, {}, tr("Keep these materials as your own; Undo takes each back"));
}

} // namespace burin

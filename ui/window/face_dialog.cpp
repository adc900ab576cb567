// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/face_dialog.h"

#include "ui/panels/buttons.h"
#include "ui/panels/notice.h"
#include "ui/theme/number_font.h"

#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QShortcut>
#include <QTableView>

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr QSize faceDialogSize(1000, 420); // pixels
constexpr int faceProgressSteps = 1000;

} // namespace

FaceDialog::FaceDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("faceDialog"));
    setWindowTitle(tr("Faces of the part"));
    sorted_.setSourceModel(&model_);
    sorted_.setSortRole(Qt::UserRole);
    layOut();
    resize(faceDialogSize);
    setProgress({});
    setFaces({}, {});
}

void FaceDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(8);
    summary_ = new QLabel(this);
    summary_->setObjectName(QStringLiteral("faceSummary"));
    summary_->setWordWrap(true);
    column->addWidget(summary_);
    notice_ = new Notice(this);
    notice_->setObjectName(QStringLiteral("faceNotice"));
    column->addWidget(notice_);
    table_ = new QTableView(this);
    table_->setObjectName(QStringLiteral("faceTable"));
    table_->setAccessibleName(tr("Faces of the part"));
    table_->setModel(&sorted_);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false); // Tab moves to the buttons
    table_->setSortingEnabled(true);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    column->addWidget(table_, 1);
    auto* row = new QHBoxLayout;
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("faceProgress"));
    progress_->setRange(0, faceProgressSteps);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Inspecting the faces"));
    cancel_ = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelFacesButton"), this);
    cancel_->setToolTip(tr("Stop inspecting the faces"));
    copy_ = makeButton(tr("Copy"), {}, QStringLiteral("copyFacesButton"), this);
    copy_->setToolTip(tr("Copy the table in its order, in mm, to paste it into a spreadsheet (Ctrl+C)"));
    export_ = makeButton(tr("Export…"), {}, QStringLiteral("exportFacesButton"), this);
    export_->setToolTip(tr("Write the table in its order, in mm, as a CSV file"));
    row->addWidget(progress_, 1);
    row->addWidget(cancel_);
    row->addStretch(1);
    row->addWidget(copy_);
    row->addWidget(export_);
    row->addWidget(makeCloseRow(*this));
    column->addLayout(row);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false); // Enter is handled by the table
    connect(cancel_, &QPushButton::clicked, this, &FaceDialog::cancelRequested);
    connect(copy_, &QPushButton::clicked, this, &FaceDialog::copy);
    connect(new QShortcut(QKeySequence::Copy, this), &QShortcut::activated, copy_, &QPushButton::click);
    connect(export_, &QPushButton::clicked, this, [this] { emit exportRequested(faceTable(shownFaces(), ',')); });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
        justChosen_ = true;
        QMetaObject::invokeMethod(
            this, [this] { justChosen_ = false; }, Qt::QueuedConnection);
        choose(index);
    });
    connect(table_, &QTableView::pressed, this, [this](const QModelIndex& index) {
        if (!justChosen_) choose(index); // again, in case the view was moved since
    });
}

void FaceDialog::setFaces(const FaceTableModel::Faces& faces, const QString& problem) {
    if (faces != model_.faces()) {
        model_.setFaces(faces);
        sorted_.sort(-1); // in the order given
        table_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    }
    notice_->tell(Notice::Kind::information, problem);
    summary_->setText(summary());
    for (QPushButton* button : {copy_, export_}) button->setEnabled(faces != nullptr && !faces->empty());
}

void FaceDialog::setProgress(std::optional<double> fraction) {
    progress_->setVisible(fraction.has_value());
    cancel_->setVisible(fraction.has_value());
    if (fraction) progress_->setValue(static_cast<int>(std::lround(*fraction * faceProgressSteps)));
}

QString FaceDialog::summary() const {
    if (!model_.faces()) return tr("What the program leaves on each face of the part.");
    const std::vector<FaceQuality>& faces = *model_.faces();
    const auto count = [&](auto is) { return QString::number(std::ranges::count_if(faces, is)); };
    return tr("Faces: %1. With gouges: %2. With too much stock: %3. Select a face to see its worst point.")
        .arg(QString::number(faces.size()), count([](const FaceQuality& face) { return face.shares.gouge > 0.0; }),
             count([](const FaceQuality& face) { return face.shares.excess > 0.0; }));
}

void FaceDialog::choose(const QModelIndex& index) {
    const QModelIndex source = sorted_.mapToSource(index);
    if (source.isValid()) emit faceChosen((*model_.faces())[static_cast<std::size_t>(source.row())]);
}

std::vector<FaceQuality> FaceDialog::shownFaces() const {
    std::vector<FaceQuality> faces;
    for (int row = 0; row < sorted_.rowCount(); ++row)
        faces.push_back((*model_.faces())[static_cast<std::size_t>(sorted_.mapToSource(sorted_.index(row, 0)).row())]);
    return faces;
}

void FaceDialog::copy() {
    QApplication::clipboard()->setText(QString::fromStdString(faceTable(shownFaces(), '\t')));
}

void FaceDialog::done(int result) {
    QDialog::done(result);
    emit closed();
}

} // namespace burin

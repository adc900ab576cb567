// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/face_table_model.h"

#include "ui/panels/measure_labels.h"
#include "ui/panels/texts.h"

#include <utility>

namespace burin {

namespace {

/// Returns the sort value of a column; kinds are sorted by their order in the enumeration, then by radius.
double valueOf(const FaceQuality& face, int column) {
    constexpr double kindsApart = 1e6; // mm: more than any radius
    switch (column) {
    case FaceTableModel::number:
        return static_cast<double>(face.number);
    case FaceTableModel::kind:
        return kindsApart * static_cast<double>(face.kind) + face.radius;
    case FaceTableModel::area:
        return face.area;
    case FaceTableModel::gouge:
        return face.gouge.amount;
    case FaceTableModel::excess:
        return face.excess.amount;
    case FaceTableModel::inTolerance:
        return face.shares.inTolerance;
    case FaceTableModel::gouged:
        return face.shares.gouge;
    case FaceTableModel::tooMuch:
        return face.shares.excess;
    default:
        return face.shares.unreachable;
    }
}

bool isSampled(int column) {
    return column >= FaceTableModel::gouge;
}

} // namespace

void FaceTableModel::setFaces(Faces faces) {
    if (faces == faces_) return;
    beginResetModel();
    faces_ = std::move(faces);
    endResetModel();
}

void FaceTableModel::setUnit(LengthUnit unit) {
    unit_ = unit;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
}

int FaceTableModel::rowCount(const QModelIndex& parent) const {
    return faces_ && !parent.isValid() ? static_cast<int>(faces_->size()) : 0;
}

int FaceTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QString FaceTableModel::textOf(const FaceQuality& face, int column) const {
    if (isSampled(column) && face.samples == 0) return QStringLiteral("–");
    switch (column) {
    case number:
        return QString::number(face.number);
    case kind:
        return kindText(face.kind, face.radius, unit_);
    case area:
        return areaText(face.area, unit_);
    case gouge:
    case excess:
        return lengthText(valueOf(face, column), unit_);
    default:
        return QLocale().toString(100.0 * valueOf(face, column), 'f', 1) + QChar(QChar::Nbsp) + QLatin1Char('%');
    }
}

QVariant FaceTableModel::data(const QModelIndex& index, int role) const {
    if (!faces_ || !index.isValid() || index.row() >= rowCount()) return {};
    const FaceQuality& face = (*faces_)[static_cast<std::size_t>(index.row())];
    const bool known = !isSampled(index.column()) || face.samples > 0;
    switch (role) {
    case Qt::DisplayRole:
        return textOf(face, index.column());
    case Qt::UserRole:
        return known ? valueOf(face, index.column()) : -1.0;
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(index.column() == kind ? Qt::AlignLeft | Qt::AlignVCenter
                                                          : Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
        return known
                   ? QVariant()
                   : QVariant(tr("Too small for the voxels: no point of this face was looked at; use smaller voxels"));
    default:
        return {};
    }
}

QVariant FaceTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const std::pair<QString, QString> titles[columns] = {
        {tr("Face"), tr("Number in the order of the part's file")},
        {tr("Kind"), tr("Shape of the face, with its diameter")},
        {tr("Area"), tr("Area of the whole face")},
        {tr("Worst gouge"), tr("Deepest cut into the part on this face")},
        {tr("Most left"), tr("Most stock beyond the allowance, where a tool of the program could reach it")},
        {tr("In tolerance"), tr("Share of the face that is within tolerance")},
        {tr("Gouged"), tr("Share of the face's points where a gouge deeper than the tolerance is marked. Each position "
                          "of the tool marks "
                          "the point that is nearest to its deepest one, so more of the face may be cut into")},
        {tr("Too much left"), tr("Share of the face with more stock than the tolerance allows")},
        {tr("Out of reach"), tr("Share of the face with stock that no tool of the program can reach")}};
    if (section < 0 || section >= columns) return {};
    if (role == Qt::DisplayRole) return titles[section].first;
    if (role == Qt::ToolTipRole) return titles[section].second;
    return {};
}

} // namespace burin

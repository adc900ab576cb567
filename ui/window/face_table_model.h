// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/face_quality.h"
#include "ui/theme/length_unit.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace burin {

/// The faces of a part as rows: number, kind, area, worst gouge, most stock left, shares by band. `Qt::UserRole` gives
/// the sort value in mm, mm² or as a fraction; unknown values sort below all others.
class FaceTableModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;
    enum Column { number, kind, area, gouge, excess, inTolerance, gouged, tooMuch, unreachable, columns };

    using Faces = std::shared_ptr<const std::vector<FaceQuality>>;
    void setFaces(Faces faces); ///< null: none
    void setUnit(LengthUnit unit);
    const Faces& faces() const noexcept { return faces_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString textOf(const FaceQuality& face, int column) const;

    Faces faces_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

} // namespace burin

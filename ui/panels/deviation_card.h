// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/deviation_map.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace burin {

class DeviationLegend;
class RowList;

/// The legend of the deviation map with each band's share of the part, the switch of the map, and the value under the
/// pointer.
class DeviationCard : public QFrame {
    Q_OBJECT
public:
    explicit DeviationCard(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setShares(const DeviationMap::Shares& shares, const DeviationTolerance& tolerance);
    void showOn(bool on); ///< never emits
    void setFacesPossible(bool possible);
    /// @param sample under the pointer; std::nullopt if there is none
    void showUnderPointer(const std::optional<DeviationSample>& sample);

signals:
    void switched(bool on); ///< by the user
    void facesRequested();  ///< the user requested the table of the part's faces

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void scrollIntoView();

    QCheckBox* switch_;
    QPushButton* faces_;
    DeviationLegend* legend_;
    QLabel* under_;
    RowList* bands_;
    DeviationMap::Shares shares_;
    DeviationTolerance tolerance_;
    std::optional<DeviationSample> sample_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

} // namespace burin

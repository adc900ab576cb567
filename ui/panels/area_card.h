// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/area_shape.h"
#include "ui/theme/length_unit.h"

#include <QFrame>

#include <array>
#include <optional>

class QPushButton;
class QToolButton;

namespace burin {

class ElidedLabel;
class FieldRow;
class QuantityField;

inline constexpr double thinnestBrush = 0.1, widestBrush = 1000.0; // mm

/// The state shown by the card of the painted area.
struct AreaState {
    double area = 0.0;                 ///< mm²; 0 if nothing is painted
    std::optional<AreaShape> painting; ///< the active tool; empty: not painting
    double brush = 10.0;               ///< mm, diameter
    bool possible = false;             ///< whether there is a part to paint on

    friend bool operator==(const AreaState&, const AreaState&) = default;
};

/// The area of the next pass: the painting tool and the size of the area.
class AreaCard : public QFrame {
    Q_OBJECT
public:
    explicit AreaCard(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const AreaState& state); ///< never emits

signals:
    void paintingRequested(burin::AreaShape shape, bool wanted);
    void brushChosen(double diameter); ///< mm
    void cleared();

private:
    void show();

    AreaState state_;
    LengthUnit unit_ = LengthUnit::millimetre;
    ElidedLabel* size_;
    QToolButton* clear_;
    std::array<QPushButton*, 3> shapes_{}; ///< in the order of AreaShape
    QuantityField* brush_;
    FieldRow* brushRow_;
};

} // namespace burin

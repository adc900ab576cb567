// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"

#include <QFrame>

#include <optional>

class QAction;
class QComboBox;
class QSlider;

namespace burin {

class LengthField;

/// The bar below the view with display options. The section controls are visible while there is a section. If there is
/// not enough room for everything, titles are hidden first, then controls that are also available as actions.
class ViewBar final : public QFrame {
    Q_OBJECT
public:
    static constexpr int mostTransparent = 95; ///< %

    /// Actions that are shown as buttons, in this order; they must outlive the bar.
    struct Offered {
        QAction &parallel, &section, &flip;
    };
    /// A section plane, mm along its axis.
    struct Section {
        int axis = 0; ///< 0, 1, 2 for x, y, z
        double position = 0.0;
        double low = 0.0, high = 0.0; ///< the permitted range
    };
    explicit ViewBar(const Offered& offered, QWidget* parent = nullptr);

    void setUnit(LengthUnit unit);
    void setPathColours(const QStringList& names); ///< the quantities by which the path can be coloured
    /// Shows the index of the quantity by which the path is coloured; std::nullopt: there is no path. Never emits.
    void showPathColour(const std::optional<int>& place);
    void showTransparency(int percent);                      ///< never emits
    void showSection(const std::optional<Section>& section); ///< never emits

signals:
    void transparencyChosen(int percent); ///< of the workpiece, 0 … mostTransparent
    void pathColourChosen(int place);     ///< index in the names given to `setPathColours`
    void axisChosen(int axis);            ///< 0, 1, 2
    void positionChosen(double position); ///< mm along the axis

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void followRoom();

    QWidget* transparencyTitle_;
    QSlider* transparency_;
    QWidget *pathColours_, *pathTitle_;
    bool hasPath_ = false; ///< whether there is a path that can be coloured
    QComboBox* pathColour_;
    QWidget* sectionControls_;
    QComboBox* axis_;
    QSlider* position_;
    LengthField* place_;
    double low_ = 0.0, high_ = 0.0; ///< mm: ends of the slider
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The fixtures and limits around the stock, and the orientation of the tool axis.
class SurroundingsPanel : public QWidget {
    Q_OBJECT
public:
    enum class Addition { fixtureBox, fixtureCylinder, fixtureFile, keepOutBox, keepOutCylinder, fixtureOfLibrary };
    Q_ENUM(Addition)

    explicit SurroundingsPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const SurroundingsState& state); ///< never emits

signals:
    void additionRequested(burin::SurroundingsPanel::Addition addition);
    // `place`: index in SurroundingsState::obstacles.
    void obstacleEdited(std::size_t place, const burin::Obstacle& obstacle);
    void obstacleSwitched(std::size_t place, bool on);
    void obstacleRemovalRequested(std::size_t place);
    void obstacleChangeRequested(std::size_t place); ///< of a fixture of the library
    void travelSwitched(bool on);
    void axisChosen(const burin::AxisMode& axis);
    void axisOfViewRequested(); ///< set the tool axis to the view direction

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin

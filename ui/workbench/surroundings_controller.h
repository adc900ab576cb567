// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"
#include "ui/workbench/surroundings.h"

#include <filesystem>

namespace burin {

/// Fixtures, keep-out volumes, the machine's travel, and how the tool's axis is held. Each change is an entry of the
/// undo stack and stored in the project. What is switched while milling reaches the loop at its next tick; anything
/// else makes the bounds anew in the background.
class SurroundingsController final : public Controller {
    Q_OBJECT
public:
    SurroundingsController(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                           SessionRunner& session, QObject* parent);

    const std::vector<PlacedObstacle>& obstacles() const noexcept { return wanted_.obstacles; }
    const AxisMode& axis() const noexcept { return wanted_.axis; }
    bool travelOn() const noexcept { return wanted_.travel.on; }
    const WantedBounds& wanted() const noexcept { return wanted_; }
    bool importing() const { return desk_.tasks.running(TaskKind::fixture); }
    /// Shapes and axis stay as they are: a recording runs.
    bool locked() const noexcept { return mill_.recording(); }
    /// What became of an obstacle; nothing: no loop runs, or its bounds are not made yet.
    std::optional<LayerNews> news(std::size_t place) const;
    std::optional<LayerNews> travelNews() const; ///< likewise, of the machine's travel

    /// What a project holds.
    void load(std::vector<Obstacle> obstacles, const AxisMode& axis, const TravelPlacement& travel);

    // Nothing happens while it is locked.
    void addBox(ObstacleKind kind);      ///< beside the stock
    void addCylinder(ObstacleKind kind); ///< likewise
    /// Bodies of a model as fixtures, as they lie in its frame. @param fileUnit mm per unit of a file that states none
    void importFile(const std::filesystem::path& file, double fileUnit);
    void change(std::size_t place, const Obstacle& obstacle);
    void remove(std::size_t place);
    void setAxis(const AxisMode& axis); ///< @param axis its direction is made unit
    // At any time.
    void setOn(std::size_t place, bool on);
    void setTravelOn(bool on);

private:
    void add(Obstacle obstacle);
    void setObstacles(const QString& title, std::vector<PlacedObstacle> obstacles, int kind = -1);
    void apply(const std::vector<PlacedObstacle>& obstacles);
    void switchLayers();
    QString freeName(ObstacleKind kind) const;
    std::optional<std::size_t> layerOf(std::size_t place) const;
    std::optional<std::size_t> travelLayer() const;
    std::optional<LayerNews> newsOf(std::optional<std::size_t> layer) const;

    WorkpieceController& workpiece_;
    MillController& mill_;
    SessionRunner& session_;
    WantedBounds wanted_;
};

} // namespace burin

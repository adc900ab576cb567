// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"
#include "ui/workbench/surroundings.h"

#include <filesystem>

namespace burin {

/// Fixtures, keep-out volumes, the machine's travel, and the control of the tool axis. Each change is an entry of the
/// undo stack and stored in the project. Switching one on or off while milling reaches the loop at its next tick; any
/// other change recomputes the bounds in the background.
class SurroundingsController final : public Controller {
    Q_OBJECT
public:
    SurroundingsController(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                           SessionRunner& session, QObject* parent);

    const std::vector<PlacedObstacle>& obstacles() const noexcept { return wanted_.obstacles; }
    const AxisMode& axis() const noexcept { return wanted_.axis; }
    bool travelOn() const noexcept { return wanted_.travel.on; }
    const RequestedBounds& wanted() const noexcept { return wanted_; }
    bool importing() const { return desk_.tasks.running(TaskKind::fixture); }
    /// Whether shapes and axis are locked because a recording is running.
    bool locked() const noexcept { return mill_.recording(); }
    /// State of an obstacle's layer in the loop; empty if no loop is running or its bounds are not made yet.
    std::optional<LayerNews> news(std::size_t place) const;
    std::optional<LayerNews> travelNews() const; ///< the same for the machine's travel

    /// Loads the fixtures and limits of a project.
    void load(std::vector<Obstacle> obstacles, const AxisMode& axis, const TravelPlacement& travel);

    static constexpr double fixtureMargin = 1.0; ///< mm, of new fixtures
    /// The pattern if no fixture has this name; otherwise, or if it has a place for one, with a number that is free.
    QString freeName(const QString& pattern) const;

    // These do nothing while it is locked.
    void add(Obstacle obstacle);
    void addBox(ObstacleKind kind);      ///< next to the stock
    void addCylinder(ObstacleKind kind); ///< likewise
    /// Adds the bodies of a model as fixtures, in the coordinates of its file. @param fileUnit mm per unit of a file
    /// that states none
    void importFile(const std::filesystem::path& file, double fileUnit);
    void change(std::size_t place, const Obstacle& obstacle);
    void move(std::size_t place, const Obstacle& obstacle); ///< as `change`, as an entry of its own
    void rename(std::size_t place, const QString& name);    ///< a name that another one has gets a number
    void remove(std::size_t place);
    void setAxis(const AxisMode& axis); ///< @param axis its direction is normalised
    // These are possible at any time.
    void setOn(std::size_t place, bool on);
    void setTravelOn(bool on);

    /// Whether the stock holds the tool in mill mode, so that it can be touched off, until a recording starts. Part of
    /// no project, nor of the undo stack.
    bool stockHolds() const noexcept { return stockHolds_; }
    bool canHoldAtStock() const;
    void holdAtStock(bool hold);
    std::optional<LayerNews> stockNews() const; ///< as `news`
    /// The tool is moved by a session without mill mode, which edits a path, from now on or no longer.
    void setEditing(bool editing);

private:
    void changeTo(std::size_t place, const Obstacle& obstacle, const QString& title, int kind);
    void setObstacles(const QString& title, std::vector<PlacedObstacle> obstacles, int kind = -1);
    void apply(const std::vector<PlacedObstacle>& obstacles);
    void switchLayers();
    bool moves() const { return mill_.active() || editing_; } ///< whether layers of a session can be switched
    void letGoOfStock();
    void bringStock();
    QString nameFor(ObstacleKind kind) const;
    std::optional<std::size_t> layerOf(std::size_t place) const;
    std::optional<std::size_t> layerOfKind(BoundLayer::Kind kind) const;
    std::optional<LayerNews> newsOf(std::optional<std::size_t> layer) const;

    WorkpieceController& workpiece_;
    MillController& mill_;
    SessionRunner& session_;
    RequestedBounds wanted_;
    bool stockHolds_ = false, editing_ = false;
};

} // namespace burin

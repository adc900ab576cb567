// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"
#include "core/setup/fixture_placement.h"
#include "core/setup/obstacle_motion.h"
#include "ui/workbench/stock_solid_controller.h"
#include "ui/workbench/surroundings_controller.h"

#include <memory>
#include <optional>

namespace burin {

/// A fixture or keep-out volume of no library that the user moves in the view. The project keeps it where it was until
/// the move is accepted, as one entry of the undo stack.
class ObstacleMover final : public Controller {
    Q_OBJECT
public:
    ObstacleMover(const Desk& desk, WorkpieceController& workpiece, StockSolidController& stock,
                  SurroundingsController& surroundings, QObject* parent);

    std::optional<std::size_t> place() const noexcept { return place_; } ///< index; empty: none is being moved
    bool moving() const noexcept { return place_.has_value(); }
    // While moving:
    const Placement& motion() const noexcept { return motion_; } ///< since the last entry of the undo stack
    glm::dvec3 centre() const { return motion_.point(middle_); } ///< mm, of the box around it
    bool rotates() const noexcept { return held_ != HeldRotations::quarterTurns; } ///< by any angle
    /// The obstacle where it is shown. Cost: grows with its mesh.
    Obstacle moved() const;
    FixtureSite site() const; ///< without it

    void begin(std::size_t place); ///< accepts the move of another one
    void accept();
    void cancel(); ///< it stays where the undo stack has it
    void setMotion(const Placement& motion);
    void moveBy(const glm::dvec3& shift) { setMotion(combined(motion_, movedBy(shift))); }
    /// About Z through its centre; a box by a quarter turn. @param angle rad
    void turnBy(double angle);
    /// Puts the middle of its lower side on a point. @param point mm, setup frame
    void placeAt(const glm::dvec3& point);

private:
    void follow();
    void take(const std::shared_ptr<const Obstacle>& obstacle);
    void end();

    WorkpieceController& workpiece_;
    StockSolidController& stock_;
    SurroundingsController& surroundings_;
    std::optional<std::size_t> place_;
    std::shared_ptr<const Obstacle> obstacle_; ///< as the undo stack has it
    HeldRotations held_ = HeldRotations::any;
    glm::dvec3 middle_{0.0}; ///< mm, of `obstacle_`
    Placement motion_;
};

} // namespace burin

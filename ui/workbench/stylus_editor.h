// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/simulated_stylus.h"
#include "core/path/inserted_points.h"
#include "core/path/path_search.h"
#include "ui/workbench/hand_controller.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// A point of the path in force that the hand can take, or has taken.
struct PathGrip {
    PlaceOnPath at;
    std::optional<std::size_t> insertedBy; ///< index of the edit that inserted the point; empty: a point of the path
};

/// Edits the path in force with the stylus: a session without a take moves the path's tool, the spindle off, along
/// part, fixtures and travel, so that the hand feels them and cannot enter them. A device's first button takes the
/// point of the path nearest to the tool's tip; letting go moves the point to the tip, by the same edit as a drag with
/// the mouse. With the mouse as stylus, the pointer takes the point and leads the tool there. Ends with its session.
class StylusEditor final : public Controller {
    Q_OBJECT
public:
    StylusEditor(const Desk& desk, WorkpieceController& workpiece, MillController& mill, SessionRunner& session,
                 StylusController& styluses, HandController& hand, PathController& path, QObject* parent);

    static constexpr double smallestReach = 0.1, largestReach = 50.0; ///< mm

    bool active() const noexcept { return active_; }
    /// Whether it can be entered: there is an evaluated path and a workpiece, and no session runs or is about to.
    bool possible() const;
    /// Connects the stylus and begins the session. Does nothing unless possible.
    void enter();
    void leave(std::function<void()> then = {}); ///< a point that is held stays where it was

    double reach() const noexcept { return reach_; } ///< mm, from the tip to a point that a device can take
    void setReach(double millimetres);               ///< within the limits above
    /// How a point moves: across the part's surface, or freely. Points that edits inserted move freely only.
    void setAlong(MovePoints::Along along);

    /// Whether the pointer leads the tool.
    bool usesMouse() const noexcept { return active_ && mouse_ != nullptr; }
    const glm::dvec3& tip() const noexcept { return tip_; }                    ///< mm, of the tool
    const std::optional<PathGrip>& within() const noexcept { return within_; } ///< in reach; nothing is held
    const std::optional<PathGrip>& held() const noexcept { return held_; }
    /// Displacement of the held point, mm.
    glm::dvec3 by() const noexcept { return moves_ && arrived_ ? by_ : glm::dvec3(0.0); }
    /// The path whose points are taken; null if none is active.
    const std::shared_ptr<const EvaluatedPath>& path() const noexcept { return path_; }

    /// The pointer leads the tool to a point of the path and on. @param by mm, of the point
    void lead(const PathGrip& grip, const glm::dvec3& by);
    void letGo();  ///< the pointer does: the point stays where the tool arrives
    void giveUp(); ///< lets go of the point, which stays where it was

signals:
    void entered();
    void left();
    void moved(); ///< the tool, what is in reach or held, or how far
    void refused(const QString& sentence);

private:
    void enterWithDevice();
    void begin(AnyStylus stylus, SimulatedStylus* mouse, const std::optional<HandDevice>& device);
    void noteEnd();
    void takePath();
    void follow();
    void look();
    void take(const PathGrip& grip);
    void drag();
    void drop();
    void steer(const glm::dvec3& tip, bool held, bool finish);

    WorkpieceController& workpiece_;
    MillController& mill_;
    SessionRunner& session_;
    StylusController& styluses_;
    HandController& hand_;
    PathController& paths_;
    double reach_ = 3.0;
    MovePoints::Along along_ = MovePoints::Along::free;

    bool active_ = false;
    SimulatedStylus* mouse_ = nullptr; ///< owned by the session; null: a device
    std::shared_ptr<const EvaluatedPath> path_;
    std::optional<PathSearch> search_;     ///< of `path_`
    std::vector<InsertedPoint> inserted_;  ///< of `path_`
    bool down_ = true;                     ///< the button, as last seen; a press before the session does not count
    glm::dvec3 tip_{0.0}, commanded_{0.0}; ///< mm, of the tool; that the hand commands
    std::optional<PathGrip> within_, held_;
    bool arrived_ = false;                          ///< the tool is at the held point, or was
    bool moves_ = false;                            ///< the hand moved on from there
    bool released_ = false;                         ///< the pointer let go; the tool still follows
    glm::dvec3 takenAt_{0.0}, goal_{0.0}, by_{0.0}; ///< mm: `commanded_` when it took the point; of the pointer; of the
                                                    ///< point
};

} // namespace burin

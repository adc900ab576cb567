// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/nearest_piece.h"
#include "ui/scene/interactive_tool.h"
#include "ui/scene/sight.h"

#include <QObject>

#include <cstdint>
#include <vector>

namespace burin {

/// What a drag does to a place of a path.
enum class DragAlong : std::uint8_t {
    level, ///< it stays on its height
    x,
    y,
    z,      ///< along an axis of the setup; Z is the tool's
    surface ///< across the view; the part's surface leads it
};

/// How far a sight drags a place, mm. Nothing where it does not say: it runs along the plane or the axis.
/// @param from the sight when the drag began, @param to the one now
std::optional<glm::dvec3> dragged(const glm::dvec3& place, const Sight& from, const Sight& to, DragAlong along);

/// A point of a path as the pointer sees it.
struct HandPoint {
    glm::dvec3 place{0.0};    ///< mm, setup frame
    bool usable = false;      ///< it comes from the hand
    std::optional<Arc> arc{}; ///< of the move that leads to it; nothing: straight
};

/// A place on a path: on the piece between two of its points.
struct PathPlace {
    std::size_t piece = 0; ///< from point `piece` to the next
    double share = 0.0;    ///< of an arc, of its sweep: 0 at its beginning, 1 at its end

    std::size_t nearestPoint() const noexcept { return share < 0.5 ? piece : piece + 1; }
};

/// The pointer on a path. A click on it chooses a place, with Shift all from the place chosen before to that one; a
/// drag from it moves the place; while it draws, a drag draws a stroke on the height of `setDrawing`. Esc ends what is
/// under way, then clears what is chosen. Everything else is the camera's. Thread: user interface.
class PathHand final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    explicit PathHand(Appearance appearance, QObject* parent = nullptr);

    void setPoints(std::vector<HandPoint> points); ///< of the path, in order
    void setChosen(bool chosen);                   ///< some of the path is: Esc clears it
    void setAlong(DragAlong along) { along_ = along; }
    /// Draws on a height, mm; nothing: it chooses and drags.
    void setDrawing(std::optional<double> height);

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;
    void leave() override;

signals:
    void chosen(const burin::PathPlace& place, bool extend);
    void dragging(const burin::PathPlace& place, const glm::dvec3& by); ///< mm; while it is dragged
    void dropped(const burin::PathPlace& place, const glm::dvec3& by);  ///< mm; where it was let go
    void drawing(const std::vector<glm::dvec3>& places);                ///< mm; so far
    void drawn(const std::vector<glm::dvec3>& places);                  ///< mm; at least two
    void givenUp();                                                     ///< what was under way is discarded
    void stateChanged();                                                ///< what Esc does may be another
    void cleared(); ///< Esc with nothing under way but what is chosen, or a drawing that is not begun

private:
    enum class Doing : std::uint8_t { nothing, pressed, dragging, drawing };

    std::optional<PathPlace> placeAt(const QPointF& pointer) const;
    PathPiece pieceAt(std::size_t piece) const;
    void draw(const ViewportEvent& event);
    void giveUp();
    Doing become(Doing what);

    Appearance appearance_;
    std::vector<HandPoint> points_;
    bool chosen_ = false;
    DragAlong along_ = DragAlong::level;
    std::optional<double> height_;
    Doing doing_ = Doing::nothing;
    PathPlace place_;
    QPointF pressedAt_;
    Sight pressedSight_;
    glm::dvec3 by_{0.0};
    std::vector<glm::dvec3> drawn_;
};

} // namespace burin

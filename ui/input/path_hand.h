// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/nearest_piece.h"
#include "ui/scene/interactive_tool.h"
#include "ui/scene/sight.h"

#include <QObject>

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// How a drag moves a point of a path.
enum class DragAlong : std::uint8_t {
    level, ///< at constant height
    x,
    y,
    z,      ///< along an axis of the setup; Z is the tool's
    surface ///< across the view direction; projected onto the part's surface
};

/// The displacement of a point by dragging, mm. Empty if undefined: the line of sight is parallel to the plane or axis.
/// @param from line of sight at the start of the drag, @param to the present one
std::optional<glm::dvec3> dragged(const glm::dvec3& place, const Sight& from, const Sight& to, DragAlong along);

/// A point of a path, for picking.
struct HandPoint {
    glm::dvec3 place{0.0};    ///< mm, setup frame
    bool usable = false;      ///< it comes from the hand
    std::optional<Arc> arc{}; ///< of the move that ends at it; empty: straight
};

/// A position on a path: on the piece between two of its points.
struct PathPlace {
    std::size_t piece = 0; ///< from point `piece` to the next
    double share = 0.0;    ///< of an arc: of its sweep; 0 at its start, 1 at its end

    std::size_t nearestPoint() const noexcept { return share < 0.5 ? piece : piece + 1; }
};

/// The pointer on a path. A click selects a point, with Shift everything from the point selected before; a drag moves
/// the point, or the handle under the pointer; while drawing, a drag draws a stroke at the height of `setDrawing`. A
/// right click requests the menu of a point; a right drag turns the camera. Esc cancels the current operation, then
/// clears the selection. All other events are left to the camera. Thread: user interface.
class PathHand final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    explicit PathHand(Appearance appearance, QObject* parent = nullptr);

    void setPoints(std::vector<HandPoint> points); ///< of the path, in order
    /// Points that are dragged by themselves, before the path at the same position; mm, setup frame.
    void setHandles(std::vector<glm::dvec3> handles);
    void setChosen(bool chosen); ///< whether there is a selection, which Esc clears
    /// Esc without an operation ends something else before it clears the selection. @param meaning as `escapeMeaning`;
    /// empty: it does not
    void setEscape(const QString& meaning);
    void setAlong(DragAlong along) { along_ = along; }
    /// Draws at a height, mm; empty: selects and drags.
    void setDrawing(std::optional<double> height);

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;
    void leave() override;

signals:
    void chosen(const burin::PathPlace& place, bool extend);
    void dragging(const burin::PathPlace& place, const glm::dvec3& by); ///< mm; during the drag
    void dropped(const burin::PathPlace& place, const glm::dvec3& by);  ///< mm; at the end of the drag
    /// The same for a handle, by its index. @param place on the path under the pointer; empty: none
    void handleDragging(std::size_t handle, const std::optional<burin::PathPlace>& place, const glm::dvec3& by);
    void handleDropped(std::size_t handle, const glm::dvec3& by);
    void menuRequested(const burin::PathPlace& place, const QPointF& position); ///< position in the viewport
    void drawing(const std::vector<glm::dvec3>& places);                        ///< mm; so far
    void drawn(const std::vector<glm::dvec3>& places);                          ///< mm; at least two
    void givenUp();                                                             ///< the current operation is discarded
    void stateChanged();                                                        ///< the meaning of Esc may have changed
    void cleared(); ///< Esc without an operation, but with a selection or a drawing that has not begun
    void escaped(); ///< Esc without an operation, after `setEscape`

private:
    enum class Doing : std::uint8_t { nothing, pressed, dragging, drawing };

    std::optional<PathPlace> placeAt(const QPointF& pointer) const;
    std::optional<std::size_t> handleAt(const QPointF& pointer) const;
    glm::dvec3 draggedFrom() const;
    void report(Doing done, bool extend);
    PathPiece pieceAt(std::size_t piece) const;
    void draw(const ViewportEvent& event);
    void giveUp();
    Doing become(Doing what);

    Appearance appearance_;
    std::vector<HandPoint> points_;
    bool chosen_ = false;
    QString escape_;
    DragAlong along_ = DragAlong::level;
    std::optional<double> height_;
    Doing doing_ = Doing::nothing;
    std::optional<PathPlace> place_;    ///< that is pressed or dragged; empty: a handle away from the path
    std::optional<std::size_t> handle_; ///< that is pressed or dragged; empty: a point of the path
    std::vector<glm::dvec3> handles_;   ///< mm
    std::optional<PathPlace> menuAt_;   ///< under the pointer when the right button was pressed
    QPointF pressedAt_;
    Sight pressedSight_;
    glm::dvec3 by_{0.0};
    std::vector<glm::dvec3> drawn_;
};

} // namespace burin

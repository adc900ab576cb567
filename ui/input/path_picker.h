// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/nearest_piece.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <utility>
#include <vector>

namespace burin {

/// Selects a move by a click near it; all other clicks and drags are left to the camera. Thread: user interface.
class PathPicker final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    using Move = std::pair<glm::dvec3, glm::dvec3>; ///< its ends, mm, setup frame
    explicit PathPicker(Appearance appearance, QObject* parent = nullptr);

    void setMoves(std::vector<Move> moves) { moves_ = std::move(moves); }

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override; ///< also left to the camera
    bool release(const ViewportEvent& event) override;

signals:
    void hovered(const QPointF& position); ///< no button is pressed
    void chosen(std::size_t move);         ///< its index in the list

private:
    Appearance appearance_;
    std::vector<Move> moves_;
    bool taken_ = false; ///< the current press was on a move
};

} // namespace burin

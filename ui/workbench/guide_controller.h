// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"

#include <memory>

namespace burin {

/// The guides of the hand. Changes made in mill mode reach the loop at its next tick. Guides are entries of the undo
/// stack and stored in the project.
class GuideController final : public Controller {
    Q_OBJECT
public:
    GuideController(const Desk& desk, WorkpieceController& workpiece, MillController& mill, SessionRunner& session,
                    QObject* parent);

    /// Loads the guides of a project.
    void load(const KeptGuides& guides);
    /// Where not all can hold, the earlier one is kept
    const std::vector<Guide>& guides() const noexcept { return guides_; }
    bool on() const noexcept { return on_; } ///< whether guides are enabled, all of them
    bool full() const noexcept { return guides_.size() == GuideSettings::capacity; }
    /// Adds a guide of the given kind that fits the stock, or one along the edge of the part nearest to the tool (found
    /// in the background). Does nothing if `full` or if the part has no edges.
    void add(GuideKind kind);
    /// Whether the part's edges are known or can be found: it was not imported as a mesh.
    bool hasEdges() const;
    void change(std::size_t place, const Guide& guide);
    void remove(std::size_t place);
    void setOn(bool on);
    /// Moves to the next level, or ends a pass. @param levels +1: along the normal
    void stepLevel(int levels);

    /// Sets the device buttons, one bit each, that request the next level below or end a pass.
    void setStepButtons(std::uint32_t buttons);

signals:
    void levelStepped(); ///< the loop was given another level, or the end of a pass

private:
    void addNearestEdge();
    void addEdge();
    void set(const QString& title, std::vector<Guide> guides, int kind = -1);
    void apply();
    void keep();

    WorkpieceController& workpiece_;
    MillController& mill_;
    SessionRunner& session_;
    std::vector<Guide> guides_;
    using Curves = std::vector<std::shared_ptr<const GuideCurve>>;
    std::shared_ptr<const Model> followed_; ///< the model whose edges are known
    Curves edges_;                          ///< of `followed_`
    Curves used_;                           ///< all that a loop or the undo stack may still refer to
    std::uint32_t stepButtons_ = 0;         ///< of the device in hand
    std::uint32_t keptStepButtons_ = 0;     ///< as stored in the project
    bool on_ = true;
};

} // namespace burin

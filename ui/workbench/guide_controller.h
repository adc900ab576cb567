// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"

#include <memory>

namespace burin {

/// The guides of the hand. What changes in mill mode reaches the loop at its next tick. Guides are entries of the undo
/// stack and kept by the project.
class GuideController final : public Controller {
    Q_OBJECT
public:
    GuideController(const Desk& desk, WorkpieceController& workpiece, MillController& mill, SessionRunner& session,
                    QObject* parent);

    /// What a project holds.
    void load(const KeptGuides& guides);
    const std::vector<Guide>& guides() const noexcept { return guides_; } ///< the earlier one stays
    bool on() const noexcept { return on_; }                              ///< all of them, or none
    bool full() const noexcept { return guides_.size() == GuideSettings::capacity; }
    /// A guide of a kind that fits the stock, or along the edge of the part that is nearest to the tool (found in the
    /// background). Nothing happens when there are as many as can be, or the part has no edges.
    void add(GuideKind kind);
    /// The part's edges are known or can be: it was no mesh.
    bool hasEdges() const;
    void change(std::size_t place, const Guide& guide);
    void remove(std::size_t place);
    void setOn(bool on);
    /// The next level, or the end of a pass. @param levels +1: along the normal
    void stepLevel(int levels);

    /// Which of a device's buttons ask for the next level below, or end a pass, by bit.
    void setStepButtons(std::uint32_t buttons);

signals:
    void levelStepped(); ///< the loop was told of another level, or of the end of a pass

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
    std::shared_ptr<const Model> followed_; ///< whose edges are known
    Curves edges_;                          ///< of that
    Curves used_;                           ///< all that a loop or the undo stack may still know of
    std::uint32_t stepButtons_ = 0;         ///< of the device in hand
    std::uint32_t keptStepButtons_ = 0;     ///< as the project has it
    bool on_ = true;
};

} // namespace burin

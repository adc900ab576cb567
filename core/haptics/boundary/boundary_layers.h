// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// All that bounds a tool: the part, grown by the allowance, and further layers (fixtures, the machine's envelope,
/// keep-out volumes), each of which can be switched between two ticks. As a boundary it answers the least clearance of
/// the layers in force, the allowance taken off the part's.
///
/// A layer that is switched on while the tool is inside it waits: it holds nothing until the tool is clear of it, and
/// never throws it out.
///
/// Thread: the loop's, once the layers are there.
class BoundaryLayers final : public PoseBoundary {
public:
    enum class State : std::uint8_t { off, waiting, inForce };

    /// @param part never null; in force
    explicit BoundaryLayers(std::unique_ptr<PoseBoundary> part);

    /// Allocates. @param layer never null @return its number, for `switchTo`; the part's is 0
    std::size_t add(std::unique_ptr<PoseBoundary> layer, bool on = true);
    std::size_t size() const noexcept { return layers_.size(); }
    /// The part alone, without its allowance.
    PoseBoundary& part() noexcept { return *layers_.front().boundary; }

    /// Takes effect with the next `settle`. A number that there is not changes nothing.
    void switchTo(std::size_t layer, bool on) noexcept;
    State state(std::size_t layer) const noexcept { return layers_[layer].state; }
    /// The layers in force that a tool is near, by bit of their number; those beyond the 64th are not told.
    /// @param within mm of clearance
    std::uint64_t touching(const ToolPose& tool, double within) noexcept;
    /// At a tick's edge: layers that waited for a tool which is clear of them now come into force.
    void settle(const ToolPose& tool) noexcept;
    /// Before there is a tool: layers come into force wherever it will be.
    void settle() noexcept;

    /// @param allowance mm, >= 0, that the tool keeps from the part
    void setAllowance(double allowance) noexcept { layers_.front().keeps = allowance; }
    double allowance() const noexcept { return layers_.front().keeps; }
    /// Of the part alone, the allowance not taken off, mm; infinite while its layer is not in force.
    double partClearance(const ToolPose& pose) noexcept;

    PoseSample at(const ToolPose& pose, double enough) noexcept override;
    double errorBound() const noexcept override { return errorBound_; }
    double spacing() const noexcept override { return spacing_; }
    double overlap() const noexcept override { return overlap_; }
    double reach() const noexcept override { return reach_; }
    std::uint64_t work() const noexcept override;

private:
    struct Layer {
        std::unique_ptr<PoseBoundary> boundary;
        double keeps = 0.0; ///< mm
        State state = State::inForce;
    };
    void take(const PoseBoundary& boundary) noexcept;

    std::vector<Layer> layers_;
    double errorBound_ = 0.0, reach_ = 0.0; ///< mm, greatest of all layers
    double spacing_, overlap_;              ///< mm, least of all layers
};

} // namespace burin

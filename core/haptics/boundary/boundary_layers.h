// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/pose_boundary.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// All boundaries of a tool: the part, grown by the allowance, and further layers (fixtures, the machine's envelope,
/// keep-out volumes), each of which can be switched between two ticks. As a boundary it returns the smallest clearance
/// of the layers in force; the allowance is subtracted from the part's clearance.
///
/// A layer that is switched on while the tool is inside it waits: it has no effect until the tool is clear of it, and
/// never pushes the tool out.
///
/// Used on the haptic thread once the layers have been added.
class BoundaryLayers final : public PoseBoundary {
public:
    enum class State : std::uint8_t { off, waiting, inForce };

    /// @param part never null; in force from the start
    explicit BoundaryLayers(std::unique_ptr<PoseBoundary> part);

    /// Adds a layer; allocates. @param layer never null @return its number, for `switchTo`; the part has number 0
    std::size_t add(std::unique_ptr<PoseBoundary> layer, bool on = true);
    std::size_t size() const noexcept { return layers_.size(); }
    /// The part without its allowance.
    PoseBoundary& part() noexcept { return *layers_.front().boundary; }

    /// Takes effect with the next `settle`. An unknown number changes nothing.
    void switchTo(std::size_t layer, bool on) noexcept;
    State state(std::size_t layer) const noexcept { return layers_[layer].state; }
    /// Whether every layer but the part's is off or waits.
    bool partAlone() const noexcept;
    /// Lets a layer in force wait if the tool is inside it, because what it is made of was put back around the tool.
    void waitInside(std::size_t layer, const ToolPose& tool) noexcept;
    /// The layers in force that a tool is near to, as a bit mask of their numbers; layers beyond the 64th are not
    /// included.
    /// @param within mm of clearance
    std::uint64_t touching(const ToolPose& tool, double within) noexcept;
    /// Called at the edge of a tick: layers that waited come into force if the tool is clear of them now.
    void settle(const ToolPose& tool) noexcept;
    /// Called before there is a tool: all waiting layers come into force, wherever the tool will be.
    void settle() noexcept;

    /// @param allowance mm, >= 0, distance that the tool keeps from the part
    void setAllowance(double allowance) noexcept { layers_.front().keeps = allowance; }
    double allowance() const noexcept { return layers_.front().keeps; }
    /// Clearance of the part alone, without subtracting the allowance, mm; infinite while its layer is not in force.
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
        double keeps = 0.0; ///< mm, distance that the tool keeps from it
        State state = State::inForce;
    };
    void take(const PoseBoundary& boundary) noexcept;

    std::vector<Layer> layers_;
    double errorBound_ = 0.0, reach_ = 0.0; ///< mm, maximum over all layers
    double spacing_, overlap_;              ///< mm, minimum over all layers
};

} // namespace burin

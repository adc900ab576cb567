// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/boundary_layers.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace burin {

BoundaryLayers::BoundaryLayers(std::unique_ptr<PoseBoundary> part)
    : spacing_(part->spacing()), overlap_(part->overlap()) {
    take(*part);
    layers_.push_back({std::move(part), 0.0, State::inForce});
}

std::size_t BoundaryLayers::add(std::unique_ptr<PoseBoundary> layer, bool on) {
    take(*layer);
    layers_.push_back({std::move(layer), 0.0, on ? State::inForce : State::off});
    return layers_.size() - 1;
}

void BoundaryLayers::take(const PoseBoundary& boundary) noexcept {
    errorBound_ = std::max(errorBound_, boundary.errorBound());
    spacing_ = std::min(spacing_, boundary.spacing());
    overlap_ = std::min(overlap_, boundary.overlap());
    reach_ = std::max(reach_, boundary.reach());
}

void BoundaryLayers::switchTo(std::size_t layer, bool on) noexcept {
    if (layer >= layers_.size()) return;
    State& state = layers_[layer].state;
    if (!on)
        state = State::off;
    else if (state == State::off)
        state = State::waiting;
}

void BoundaryLayers::settle(const ToolPose& tool) noexcept {
    for (Layer& layer : layers_)
        if (layer.state == State::waiting && layer.boundary->at(tool, layer.keeps).clearance >= layer.keeps)
            layer.state = State::inForce;
}

void BoundaryLayers::settle() noexcept {
    for (Layer& layer : layers_)
        if (layer.state == State::waiting) layer.state = State::inForce;
}

bool BoundaryLayers::partAlone() const noexcept {
    return std::none_of(layers_.begin() + 1, layers_.end(),
                        [](const Layer& layer) { return layer.state == State::inForce; });
}

void BoundaryLayers::waitInside(std::size_t layer, const ToolPose& tool) noexcept {
    constexpr double ofRounding = 1e-9; // mm, as Proxy allows a tool that rests on a boundary
    Layer& one = layers_[layer];
    if (one.state == State::inForce && one.boundary->at(tool, one.keeps).clearance < one.keeps - ofRounding)
        one.state = State::waiting;
}

std::uint64_t BoundaryLayers::touching(const ToolPose& tool, double within) noexcept {
    constexpr std::size_t told = 64;
    std::uint64_t near = 0;
    for (std::size_t i = 0; i < std::min(layers_.size(), told); ++i) {
        Layer& layer = layers_[i];
        if (layer.state != State::inForce) continue;
        const double reach = layer.keeps + within;
        if (layer.boundary->at(tool, reach).clearance < reach) near |= std::uint64_t{1} << i;
    }
    return near;
}

double BoundaryLayers::partClearance(const ToolPose& pose) noexcept {
    Layer& part = layers_.front();
    if (part.state != State::inForce) return std::numeric_limits<double>::infinity();
    return part.boundary->at(pose, part.keeps).clearance;
}

std::uint64_t BoundaryLayers::work() const noexcept {
    std::uint64_t sum = 0;
    for (const Layer& layer : layers_) sum += layer.boundary->work();
    return sum;
}

PoseSample BoundaryLayers::at(const ToolPose& pose, double enough) noexcept {
    PoseSample least{enough, glm::dvec3(0.0), glm::dvec3(0.0), false};
    bool any = false;
    for (Layer& layer : layers_) {
        if (layer.state != State::inForce) continue;
        PoseSample sample = layer.boundary->at(pose, std::min(least.clearance, enough) + layer.keeps);
        sample.clearance -= layer.keeps;
        if (any && !(sample.clearance < least.clearance)) continue;
        least = sample;
        any = true;
    }
    return least;
}

} // namespace burin

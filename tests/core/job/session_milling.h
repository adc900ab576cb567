// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"
#include "core/job/milling_context.h"
#include "tests/core/device/desktop_stylus.h"

#include <atomic>
#include <cstdlib>
#include <vector>

/// A small block to mill, and a hand that mills strokes in it on request.
namespace burin::test {

inline constexpr double top = 10.0, side = 20.0; ///< mm: the block's height, and its length along x and y

inline Tool sessionTool() {
    Tool tool;
    tool.id = "ball-4";
    tool.name = "Ball 4 mm";
    tool.maximumDepthOfCut = 4.0;
    tool.maximumSpindleSpeed = 20000.0;
    tool.source = "made up";
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = 4.0;
    tool.cutter.cornerRadius = 2.0;
    tool.cutter.fluteLength = 12.0;
    tool.cutter.shankDiameter = 4.0;
    tool.cutter.stickOut = 25.0;
    return tool;
}

inline Setup blockSetup() {
    Setup setup;
    setup.voxel = 0.5;
    setup.stockMaterial = "machinable-wax";
    setup.stock = {glm::dvec3(0.0), glm::dvec3(side, side, top)};
    setup.workOffset = {0.5 * side, 0.5 * side, top};
    return setup;
}

/// A block without a part in it.
inline MillingContext blockMilling() {
    Progress progress;
    Result<MillingContext> milling = makeMillingContext(
        {std::make_shared<const Model>(), blockSetup(), sessionTool(), "linuxcnc-mill", {}}, progress);
    if (!milling) std::abort();
    return *std::move(milling);
}

/// A copy of every scanline: the state of the workpiece, independent of later changes.
template <class Volume>
std::vector<std::vector<Segment>> linesOf(const Volume& volume) {
    std::vector<std::vector<Segment>> lines;
    for (std::int32_t v = 0; v < volume.grid().lineCountV(); ++v)
        for (std::int32_t u = 0; u < volume.grid().lineCountU(); ++u) {
            const auto line = volume.line({u, v});
            lines.emplace_back(line.begin(), line.end());
        }
    return lines;
}

/// Mills the requested number of strokes along x with its button down, and returns through the stock with its button
/// up. Device frame: the setup's.
class StrokeHand final : public Stylus {
public:
    static constexpr int strokeTicks = 60, backTicks = 30;

    /// @param finishAfter strokes; 0: never
    explicit StrokeHand(int finishAfter = 0) : finishAfter_(finishAfter) {}
    void mill(int strokes) { wanted_.fetch_add(strokes); } ///< adds this many
    int done() const { return done_.load(); }              ///< strokes completed, including the return
    double largestForce() const { return largestForce_; }
    bool closed() const { return closed_; }

    StylusDescription description() const override {
        StylusDescription stylus = desktopStylus();
        stylus.name = "stroke hand";
        stylus.maximumSpeed = {2000.0, "made up"};
        return stylus;
    }
    Result<void> open() override { return {}; }
    StylusState read(double time) noexcept override {
        const int stroke = done_.load();
        if (tick_ == 0 && stroke < wanted_.load()) tick_ = 1;
        StylusState state;
        state.time = time;
        state.valid = true;
        const double along = tick_ <= strokeTicks ? static_cast<double>(tick_) / strokeTicks
                                                  : 1.0 - static_cast<double>(tick_ - strokeTicks) / backTicks;
        state.pose.position = {-3.0 + (side + 6.0) * along, 2.0 + 1.3 * (stroke % 13), top - 2.0 - 0.2 * (stroke % 7)};
        state.buttons = tick_ > 0 && tick_ <= strokeTicks ? 1u : 0u;
        if (tick_ > 0 && ++tick_ > strokeTicks + backTicks) {
            tick_ = 0;
            done_.store(stroke + 1);
        }
        return state;
    }
    void write(const Wrench& wrench) noexcept override {
        largestForce_ = std::max(largestForce_, glm::length(wrench.force));
    }
    bool finished() const noexcept override { return finishAfter_ > 0 && done_.load() >= finishAfter_; }
    void close() noexcept override { closed_ = true; }

private:
    const int finishAfter_;
    std::atomic<int> wanted_{0}, done_{0};
    int tick_ = 0; ///< of the current stroke; 0: waiting
    double largestForce_ = 0.0;
    bool closed_ = false;
};

} // namespace burin::test

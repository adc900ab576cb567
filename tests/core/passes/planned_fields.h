// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/tool/tool.h"

#include <algorithm>
#include <cmath>

namespace burin::test {

// Clearance of a ball-end cutter with a shank of the same radius from parts whose distance is a closed formula.

inline Tool shankedBallTool(double diameter = 6.0, double flutes = 22.0) {
    Tool tool;
    tool.id = "ball";
    tool.maximumDepthOfCut = flutes;
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = diameter;
    tool.cutter.cornerRadius = 0.5 * diameter;
    tool.cutter.fluteLength = flutes;
    tool.cutter.shankDiameter = diameter - 0.2;
    tool.cutter.stickOut = 50.0;
    tool.cutter.holder = {{28.0, 28.0, 18.0}};
    return tool;
}

class AnalyticField : public ClearanceField {
public:
    explicit AnalyticField(double ballRadius) : ballRadius_(ballRadius) {}
    FieldSample at(const glm::dvec3& tip) const noexcept final {
        FieldSample sample;
        sample.clearance = distance(tip + glm::dvec3(0.0, 0.0, ballRadius_)) - ballRadius_;
        if (gradients_) sample.gradient = gradientAt(tip);
        sample.fine = true;
        return sample;
    }
    /// Planning needs no gradients, which take six more distances; the haptic step does need them.
    void answerGradients() noexcept { gradients_ = true; }
    double errorBound() const noexcept final { return 0.0; }
    double spacing() const noexcept final { return 0.25; }

protected:
    /// Signed distance from the part to the half-line straight up from the ball's centre.
    virtual double distance(const glm::dvec3& centre) const noexcept = 0;
    double ballRadius_;

private:
    glm::dvec3 gradientAt(const glm::dvec3& tip) const noexcept {
        constexpr double h = 1e-5;
        const glm::dvec3 centre = tip + glm::dvec3(0.0, 0.0, ballRadius_);
        glm::dvec3 gradient(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 offset(0.0);
            offset[axis] = h;
            gradient[axis] = (distance(centre + offset) - distance(centre - offset)) / (2.0 * h);
        }
        return gradient;
    }
    bool gradients_ = false;
};

/// A capsule parallel to x, cut off at z = 0: its axis at `height`, as long and wide as a computer mouse.
class LyingCapsule final : public AnalyticField {
public:
    LyingCapsule(double ballRadius, double radius, double halfLength, double height)
        : AnalyticField(ballRadius), radius_(radius), halfLength_(halfLength), height_(height) {}
    /// Height of the ball's tip resting on the part at (x, y), closed formula.
    double restingTip(double x, double y) const {
        const double along = std::max(0.0, std::abs(x) - halfLength_);
        const double reach = radius_ + ballRadius_;
        const double square = reach * reach - along * along - y * y;
        return square < 0.0 ? 0.0 : std::max(0.0, height_ + std::sqrt(square) - ballRadius_);
    }
    /// Top of the part at (x, y), closed formula; 0 outside it.
    double top(double x, double y) const {
        const double along = std::max(0.0, std::abs(x) - halfLength_);
        const double square = radius_ * radius_ - along * along - y * y;
        return square < 0.0 ? 0.0 : height_ + std::sqrt(square);
    }
    Box box() const {
        return {{-halfLength_ - radius_, -radius_, 0.0}, {halfLength_ + radius_, radius_, height_ + radius_}};
    }

protected:
    double distance(const glm::dvec3& c) const noexcept override {
        const double along = std::max(0.0, std::abs(c.x) - halfLength_);
        const double up = std::max(0.0, c.z - height_); // vertical walls below the axis; the shank above
        return std::sqrt(along * along + c.y * c.y + up * up) - radius_;
    }

private:
    double radius_, halfLength_, height_;
};

/// Axis-parallel boxes on the plane z = 0.
class Blocks final : public AnalyticField {
public:
    Blocks(double ballRadius, std::vector<Box> boxes) : AnalyticField(ballRadius), boxes_(std::move(boxes)) {}

protected:
    double distance(const glm::dvec3& c) const noexcept override {
        double least = 1e9;
        for (const Box& box : boxes_) {
            glm::dvec3 outside = glm::max(box.low - c, c - box.high);
            outside.z = c.z - box.high.z; // the shank is above the ball, so nothing is below a box
            const double inside = std::min(0.0, std::max({outside.x, outside.y, outside.z}));
            least = std::min(least, glm::length(glm::max(outside, glm::dvec3(0.0))) + inside);
        }
        return least;
    }

private:
    std::vector<Box> boxes_;
};

} // namespace burin::test

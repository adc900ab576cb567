// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/area_shape.h"
#include "core/geometry/plan_region.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// The pointer as a brush on the part: paints an area in plan, and erases with Shift; Ctrl and the wheel change the
/// brush. Esc cancels the current stroke, then ends painting. All other events are left to the camera.
/// Thread: user interface.
class AreaPainter final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// The point of the part on a line of sight, mm, setup frame; empty if it misses the part.
    using PartOnSight = std::function<std::optional<glm::dvec3>(const Sight&)>;
    explicit AreaPainter(QObject* parent = nullptr) : QObject(parent) {}

    /// @param height mm: height at which a line of sight paints if it misses the part before it has hit it once
    void setPart(PartOnSight part, double height);
    void setShape(AreaShape shape);
    void setBrush(double diameter) { brush_ = diameter; } ///< mm

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool wheel(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;
    void leave() override;

signals:
    void painting(const burin::PlanRegion& region); ///< so far
    void painted(const burin::PlanRegion& region, bool erase);
    void faceChosen(const glm::dvec3& place, bool erase); ///< mm, on the part
    void brushTurned(double notches);                     ///< of the wheel; > 0: wider
    void hovered(const std::optional<glm::dvec3>& place); ///< mm, position of the brush; empty: not on the part
    void givenUp();                                       ///< the current stroke is discarded
    void cancelled();                                     ///< Esc without a current stroke
    void stateChanged();                                  ///< the meaning of Esc may have changed

private:
    std::optional<glm::dvec3> placeOn(const ViewportEvent& event, bool anywhere);
    PlanRegion region() const;
    void add(const ViewportEvent& event);
    void giveUp();

    PartOnSight part_;
    double height_ = 0.0, brush_ = 10.0;
    AreaShape shape_ = AreaShape::brush;
    std::vector<glm::dvec2> line_; ///< of the current stroke
    bool under_ = false, erase_ = false;
};

} // namespace burin

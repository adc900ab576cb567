// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// What a drag or a click paints.
enum class AreaShape {
    brush, ///< what a round brush goes over
    lasso, ///< what a line goes round
    face   ///< the face of the part that is clicked
};

/// The pointer as a brush on the part: paints an area in plan, with Shift takes away from it; the wheel with Ctrl
/// changes the brush. Esc ends what is under way, then the painting. Everything else is the camera's.
/// Thread: user interface.
class AreaPainter final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// The place of the part on a sight, mm, setup frame; nothing: it misses it.
    using PartOnSight = std::function<std::optional<glm::dvec3>(const Sight&)>;
    explicit AreaPainter(QObject* parent = nullptr) : QObject(parent) {}

    /// @param height mm: where a sight that misses the part before it met it is taken to paint
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
    void hovered(const std::optional<glm::dvec3>& place); ///< mm, where the brush is; nothing: beside the part
    void givenUp();                                       ///< what was under way is discarded
    void cancelled();                                     ///< Esc with nothing under way
    void stateChanged();                                  ///< what Esc does may be another

private:
    std::optional<glm::dvec3> placeOn(const ViewportEvent& event, bool anywhere);
    PlanRegion region() const;
    void add(const ViewportEvent& event);
    void giveUp();

    PartOnSight part_;
    double height_ = 0.0, brush_ = 10.0;
    AreaShape shape_ = AreaShape::brush;
    std::vector<glm::dvec2> line_; ///< of what is under way
    bool under_ = false, erase_ = false;
};

} // namespace burin

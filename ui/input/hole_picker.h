// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/geometry/triangle_ray.h"
#include "core/geometry/upright_holes.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Picks round upright holes and studs of a part: a click on the wall of one, or through its mouth (on its top), picks
/// it. Esc or Enter ends picking; all other events are left to the camera. Thread: user interface.
class HolePicker final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    using QObject::QObject;
    /// @param part in the setup frame; null: nothing is picked @param holes of the part, and studs if they may be
    /// picked
    void setPart(std::shared_ptr<const Model> part, std::vector<UprightHole> holes);
    const std::vector<UprightHole>& holes() const noexcept { return holes_; }

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;

signals:
    void chosen(std::size_t hole); ///< index in `holes`
    void missed();                 ///< the part was clicked where it has none of them
    void finished();

private:
    std::shared_ptr<const Model> part_;
    std::vector<UprightHole> holes_;
    bool taken_ = false; ///< the current press was on the part
};

/// What is under a line of sight: a hole, by its index, whose wall is hit first, or through whose upper or lower mouth
/// the line passes before it hits the part (of several holes in one another the narrowest).
/// @param hit distance along the line, mm, at which it hits the part; empty: it does not
std::optional<std::size_t> holeOn(const Ray& ray, std::optional<double> hit, const std::vector<UprightHole>& holes);

} // namespace burin

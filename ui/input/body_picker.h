// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <memory>
#include <optional>
#include <set>

namespace burin {

/// Selects the body of a model that is nearest to the eye at a click, even if stock hides it; all other clicks and
/// drags are left to the camera. Thread: user interface.
class BodyPicker : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    using QObject::QObject;
    void setModel(std::shared_ptr<const Model> model) { model_ = std::move(model); }
    /// Bodies of the model that are ignored
    void setHidden(std::set<std::size_t> bodies) { hidden_ = std::move(bodies); }

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;

signals:
    /// @param body its index in the model @param point on it, mm, setup frame
    void chosen(std::size_t body, const glm::dvec3& point);

private:
    std::shared_ptr<const Model> model_;
    std::set<std::size_t> hidden_;
    bool taken_ = false; ///< the current press was on a body
};

/// The first body on a line of sight.
struct SeenBody {
    std::size_t body = 0;
    glm::dvec3 place{0.0}; ///< mm, setup frame
};
/// Empty if no body is hit. Cost: all triangles of the model. @param hidden bodies that are ignored
std::optional<SeenBody> bodyOn(const Sight& sight, const Model& model, const std::set<std::size_t>& hidden);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <memory>

namespace burin {

/// Asks for a place on a model: the next click on it is that place, Esc takes the question back. Every other click and
/// drag is the camera's. Thread: user interface.
class FacePicker final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    using QObject::QObject;
    void setModel(std::shared_ptr<const Model> model) { model_ = std::move(model); }

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;

signals:
    void picked(const glm::dvec3& place); ///< mm, setup frame
    void cancelled();

private:
    std::shared_ptr<const Model> model_;
    bool taken_ = false; ///< the press that is under way was on the model
};

} // namespace burin

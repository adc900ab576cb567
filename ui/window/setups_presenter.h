// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/face_picker.h"
#include "ui/panels/setup_panel.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// The setups and the placement of the part, with their panel; picks faces in the view.
class SetupsPresenter final : public Presenter {
    Q_OBJECT
public:
    SetupsPresenter(Workbench& workbench, Viewport& viewport, SetupPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void connectActions(const Actions& actions);
    void setHiddenBodies(const std::set<std::size_t>& bodies) { picker_.setHidden(bodies); }
    /// Called when its step is no longer shown: ends picking of a face.
    void leave() { pick(FaceAim::none); }

signals:
    void pickBegins(); ///< the part must be shown
    void refused(const QString& sentence);

private:
    void present() override;
    void add();
    void step(int by);
    void pick(FaceAim aim);
    void turnTo(const glm::dvec3& place);
    void align(FaceAim aim, const PartFace& face);
    void turn(int axis, double angle);

    Viewport& viewport_;
    SetupPanel& panel_;
    FacePicker picker_;
    InteractiveTool* before_ = nullptr; ///< the view's tool before picking
    FaceAim aim_ = FaceAim::none;
};

} // namespace burin

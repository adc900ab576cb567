// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/touched_face.h"
#include "ui/actions/actions.h"
#include "ui/input/zero_picker.h"
#include "ui/panels/job_states.h"
#include "ui/panels/zero_panel.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Program zero: its panel, its mark in the view, and setting it by a click or with the tool.
class ZeroPresenter final : public Presenter {
    Q_OBJECT
public:
    ZeroPresenter(Workbench& workbench, Viewport& viewport, ZeroPanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void connectActions(const Actions& actions);
    void setHiddenBodies(const std::set<std::size_t>& bodies) { picker_.setHidden(bodies); }
    /// The mark is drawn except during milling; picking ends when another step than the stock's is shown.
    void setShown(JobStep step);

signals:
    void pickBegins(); ///< its panel must be shown
    void refused(const QString& sentence);
    void told(const QString& sentence);

private:
    void present() override;
    void pick(bool wanted);
    void end();
    void placeOnStock(const std::array<BoxSide, 3>& sides);
    void placeAt(const glm::dvec3& point);
    void touch();
    void touchStock(const TouchedFace& touched);
    void showHold();

    QAction* hold_ = nullptr; ///< that the stock stops the tool
    Viewport& viewport_;
    ZeroPanel& panel_;
    ZeroPicker picker_;
    InteractiveTool* before_ = nullptr; ///< the view's tool before picking
    bool picking_ = false;
    JobStep step_ = JobStep::part;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/area_painter.h"
#include "ui/panels/area_card.h"
#include "ui/panels/job_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

#include <memory>
#include <optional>

namespace burin {

/// The area of the next pass: its card, its lines on the part, and the pointer that paints it in the path step.
class AreaPresenter final : public Presenter {
    Q_OBJECT
public:
    AreaPresenter(Workbench& workbench, Viewport& viewport, AreaCard& card, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void connectActions(const Actions& actions);
    void setShown(JobStep step); ///< painting ends when another step than the path's is shown

signals:
    void paintingBegins(); ///< the path step must be shown
    void escapeChanged();  ///< the meaning of Esc may have changed
    void refused(const burin::Error& error);

private:
    void present() override;
    void paint(AreaShape shape, bool wanted);
    void toggle(AreaShape shape) { paint(shape, painting_ != shape); }
    void takeFace(const glm::dvec3& place, bool erase);
    void turnBrush(double notches);
    void followPart();
    void showArea();
    void showUnderWay(const PlanRegion& region);

    Viewport& viewport_;
    AreaCard& card_;
    AreaPainter painter_;
    InteractiveTool* before_ = nullptr; ///< the view's tool before painting
    std::shared_ptr<const MillingContext> milling_;
    std::optional<AreaShape> painting_;
    PlaceChains lines_;   ///< of the present area
    PlanRegion drawn_;    ///< the area that `lines_` belong to
    double brush_ = 10.0; // mm
    bool shown_ = false;
};

} // namespace burin

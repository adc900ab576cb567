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

/// The area of the next pass: its card, its lines on the part, and the pointer that paints it in the path's step.
class AreaPresenter final : public Presenter {
    Q_OBJECT
public:
    AreaPresenter(Workbench& workbench, Viewport& viewport, AreaCard& card, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void connectActions(const Actions& actions);
    void setShown(JobStep step); ///< another step than the path's ends the painting

signals:
    void paintingBegins(); ///< the path's step has to be shown
    void escapeChanged();  ///< what Esc does may be another
    void refused(const burin::Error& error);

private:
    void present() override;
    void paint(AreaTool tool, bool wanted);
    void toggle(AreaTool tool) { paint(tool, painting_ != tool); }
    void takeFace(const glm::dvec3& place, bool erase);
    void turnBrush(double notches);
    void followPart();
    void showArea();
    void showUnderWay(const PlanRegion& region);

    Viewport& viewport_;
    AreaCard& card_;
    AreaPainter painter_;
    InteractiveTool* before_ = nullptr; ///< that the view had before the painting
    std::shared_ptr<const MillingContext> milling_;
    std::optional<AreaTool> painting_;
    PlaceChains lines_;   ///< of the area as it is
    PlanRegion drawn_;    ///< what they are of
    double brush_ = 10.0; // mm
    bool shown_ = false;
};

} // namespace burin

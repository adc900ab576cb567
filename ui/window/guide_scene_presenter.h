// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_axis.h"
#include "core/haptics/guides/last_pass.h"
#include "ui/actions/actions.h"
#include "ui/panels/job_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// The guides of the hand in the viewport: while the tool is being moved or in the mill step.
class GuideScenePresenter final : public Presenter {
    Q_OBJECT
public:
    GuideScenePresenter(Workbench& workbench, Viewport& viewport, const Actions& actions, QObject* parent);
    void setShown(JobStep step);

private:
    void present() override;
    void follow(const std::vector<TracePoint>& points);
    void forgetPass();
    void keepPass();
    GuideMark markOf(std::size_t place);
    void lean(GuideMark& mark);

    Viewport& viewport_;
    const Actions& actions_;
    JobStep step_ = JobStep::part;
    LastPass pass_;                ///< as in the loop, at its height
    std::uint32_t passNumber_ = 0; ///< of the one in `lastPass_`
    std::shared_ptr<const std::vector<glm::dvec3>> lastPass_;
    glm::dvec3 passDirection_{0.0};
    GuideAxis leaning_; ///< the axis commanded by lead and tilt
};

} // namespace burin

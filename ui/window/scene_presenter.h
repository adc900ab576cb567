// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/scene/viewport.h"
#include "ui/window/live_strokes.h"
#include "ui/window/presenter.h"

#include <set>

namespace burin {

/// The viewport: part, stock, workpiece, tool and path as the controllers have them; tool and cuts of a session as they
/// come.
class ScenePresenter final : public Presenter {
    Q_OBJECT
public:
    ScenePresenter(Workbench& workbench, Viewport& viewport, const Actions& actions, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// The bare part in the workpiece's stead.
    void showBarePart(bool bare);
    void setHiddenBodies(const std::set<std::size_t>& bodies); ///< of the whole model; all others are drawn
    /// Where a tool stands while no session moves it. @param tip mm, setup frame @param tool null: the one in force
    void showToolAt(const glm::dvec3& tip, const Tool* tool);
    void parkTool(); ///< the one in force, over the stock
    /// What stood there at a moment of the recordings; nothing: the present again.
    void showMoment(const std::optional<MomentView>& moment);

signals:
    void hiddenBodiesChanged(const std::set<std::size_t>& bodies);

private:
    void present() override;
    void presentPart();
    std::vector<bool> hiddenOfPart() const;
    void showTicks();
    void showSample(const Sample& sample, bool cutting);
    void showTrace(const std::vector<TracePoint>& points);
    void showWorkpiece();
    void placeTool();
    void drawTool();

    Viewport& viewport_;
    LiveStrokes live_;
    const Actions& actions_;
    std::shared_ptr<const Model> part_;           ///< that is drawn
    std::shared_ptr<const Model> model_;          ///< that it is of
    std::shared_ptr<const ModelPreview> preview_; ///< that is drawn in its stead
    std::set<std::size_t> hidden_;                ///< of the model's bodies
    bool bare_ = false;
    std::optional<glm::dvec3> toolTip_;
    std::optional<Tool> shownTool_; ///< in the stead of the one in force
    std::string tool_;              ///< id of the one that is drawn
    std::optional<Sample> past_;    ///< a moment's, which is shown in the present's stead
    std::vector<glm::vec3> stroke_; ///< storage
};

} // namespace burin

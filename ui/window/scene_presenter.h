// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/scene/viewport.h"
#include "ui/window/live_strokes.h"
#include "ui/window/presenter.h"

#include <set>

namespace burin {

/// The viewport: part, stock, workpiece, tool and path as held by the controllers; tool and cuts of a session as they
/// arrive.
class ScenePresenter final : public Presenter {
    Q_OBJECT
public:
    ScenePresenter(Workbench& workbench, Viewport& viewport, const Actions& actions, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Shows the part alone instead of the workpiece.
    void showBarePart(bool bare);
    void setHiddenBodies(const std::set<std::size_t>& bodies); ///< of the complete model; all others are drawn
    /// Sets the tool's position while no session moves it. @param tip mm, setup frame @param tool null: the one in
    /// force
    void showToolAt(const glm::dvec3& tip, const Tool* tool);
    void parkTool(); ///< the one in force, over the stock
    /// Shows the state at a moment of the recordings; empty: the present again.
    void showMoment(const std::optional<MomentView>& moment);

signals:
    void hiddenBodiesChanged(const std::set<std::size_t>& bodies);

private:
    void present() override;
    void presentPart();
    std::vector<std::size_t> bodiesOfPart() const; ///< of the model, in the order in which they are drawn
    std::vector<bool> hiddenOfPart() const;
    std::vector<std::optional<QColor>> coloursOfPart() const;
    void showTicks();
    void showSample(const Sample& sample, bool cutting);
    void showTrace(const std::vector<TracePoint>& points);
    void showWorkpiece();
    void placeTool();
    void drawTool();

    Viewport& viewport_;
    LiveStrokes live_;
    const Actions& actions_;
    std::shared_ptr<const Model> part_;           ///< as drawn
    std::shared_ptr<const Model> model_;          ///< that `part_` belongs to
    std::shared_ptr<const ModelPreview> preview_; ///< drawn instead of the part
    std::set<std::size_t> hidden_;                ///< bodies of the model
    bool bare_ = false;
    std::optional<glm::dvec3> toolTip_;
    std::optional<Tool> shownTool_; ///< instead of the one in force
    std::string tool_;              ///< id of the tool drawn
    std::optional<Sample> past_;    ///< of a moment of the past, shown instead of the present
    std::vector<glm::vec3> stroke_; ///< buffer
};

} // namespace burin

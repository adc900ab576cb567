// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/scene_presenter.h"

#include "ui/theme/colour.h"

namespace burin {

ScenePresenter::ScenePresenter(Workbench& workbench, Viewport& viewport, const Actions& actions, QObject* parent)
    : Presenter(workbench,
                {&workbench.model, &workbench.setup, &workbench.tool, &workbench.workpiece, &workbench.session}, parent)
    , viewport_(viewport)
    , live_(viewport)
    , actions_(actions) {
    connect(&workbench.workpiece, &WorkpieceController::workpieceChanged, this, &ScenePresenter::showWorkpiece);
    connect(&workbench.session, &SessionRunner::ended, this, &ScenePresenter::showWorkpiece);
    connect(&workbench.session, &SessionRunner::viewed, this,
            [this](const WorkpieceView& view) { viewport_.setWorkpiece(view.workpiece, view.oldestCut); });
    connect(&workbench.session, &SessionRunner::ticked, this, &ScenePresenter::showTicks);
    connect(&workbench.session, &SessionRunner::traced, this, &ScenePresenter::showTrace);
    connect(&workbench.session, &SessionRunner::recordingStarted, this, [this] { live_.clear(); });
    connect(&workbench.mill, &MillController::strokeTakenBack, this, [this](bool undo) { live_.takeBack(undo); });
    connect(&workbench.path, &PathController::evaluatedAnew, this, [this] {
        const auto& evaluated = workbench_.path.evaluated();
        live_.clear(); // replaced by the edited path
        viewport_.setPath(evaluated ? *evaluated : EvaluatedPath{});
    });
    connect(&workbench.path, &PathController::firstResult, &viewport,
            [&viewport](const std::shared_ptr<const EvaluatedPath>& path) { viewport.setPath(*path); });
    connect(&workbench.path, &PathController::othersChanged, this,
            [this] { viewport_.setOtherPaths(workbench_.path.others()); });
    connect(&workbench.passShow, &PassShow::moved, this, [this] {
        const PassFilm::Picture* picture = workbench_.passShow.picture();
        if (picture != nullptr && picture->tip) showToolAt(*picture->tip, nullptr);
    });
    connect(&workbench.passShow, &PassShow::finished, this, &ScenePresenter::parkTool);
    for (const ActionId id : {ActionId::showPart, ActionId::showWorkpiece, ActionId::showTool})
        connect(actions[id], &QAction::toggled, this, &Presenter::presentSoon);
    const std::pair<ActionId, StandardView> views[] = {
        {ActionId::viewIsometric, StandardView::isometric}, {ActionId::viewTop, StandardView::top},
        {ActionId::viewBottom, StandardView::bottom},       {ActionId::viewFront, StandardView::front},
        {ActionId::viewBack, StandardView::back},           {ActionId::viewLeft, StandardView::left},
        {ActionId::viewRight, StandardView::right}};
    for (const auto& [id, view] : views)
        connect(actions[id], &QAction::triggered, &viewport,
                [&viewport, seen = view] { viewport.setStandardView(seen); });
    connect(actions[ActionId::fit], &QAction::triggered, &viewport, &Viewport::fit);
    connect(actions[ActionId::showPath], &QAction::toggled, &viewport, &Viewport::setPathVisible);
    connect(actions[ActionId::showOtherPaths], &QAction::toggled, &viewport, &Viewport::setOtherPathsVisible);
}

void ScenePresenter::present() {
    const bool embedded = workbench_.workpiece.embedded();
    presentPart();
    viewport_.setHiddenBodies(hiddenOfPart());
    viewport_.setBodyColours(coloursOfPart());
    viewport_.setPartVisible(!embedded || bare_ || actions_[ActionId::showPart]->isChecked());
    viewport_.setWorkpieceVisible(embedded && !bare_ && actions_[ActionId::showWorkpiece]->isChecked());
    const bool outline = workbench_.setup.usable() && !embedded;
    viewport_.setStockOutline(outline ? std::optional(workbench_.setup.setup().stock) : std::nullopt);

    drawTool();
    viewport_.setToolVisible(embedded && actions_[ActionId::showTool]->isChecked());
    placeTool();
}

/// A part replaces its preview, which is drawn only while the tool is not moved, as milling needs the picture.
void ScenePresenter::presentPart() {
    const auto& preview = workbench_.model.preview();
    // With a workpiece, bodies of other roles are within it, around it or absent.
    const auto& model = workbench_.setup.part();
    const auto wanted = workbench_.workpiece.embedded() ? workbench_.workpiece.milling()->partModel : model;
    if (part_ != wanted) {
        const bool same = model_ == model;
        part_ = wanted;
        model_ = model;
        if (same) {
            viewport_.setPart(part_);
        } else if (preview_ && !preview && part_ && part_->sourceFile == preview_->sourceFile) {
            preview_.reset();
            viewport_.setPreviewedPart(part_);
        } else {
            viewport_.setPart(part_);
            viewport_.fit();
        }
    }
    const auto shown = workbench_.session.running() ? nullptr : preview;
    if (shown == preview_) return;
    preview_ = shown;
    viewport_.setPreview(preview_, firstMargin);
}

void ScenePresenter::drawTool() {
    const Tool& inForce =
        workbench_.workpiece.milling() ? workbench_.workpiece.milling()->tool : workbench_.tool.current();
    const Tool& tool = shownTool_ && !workbench_.session.running() ? *shownTool_ : inForce;
    if (tool.id == tool_) return;
    tool_ = tool.id;
    viewport_.setTool(tool);
}

void ScenePresenter::placeTool() {
    if (!workbench_.workpiece.embedded() || workbench_.session.running()) return;
    if (past_) return showSample(*past_, (past_->flags & sampleSpindleOff) == 0);
    const MillingContext& milling = *workbench_.workpiece.milling();
    const glm::dvec3 centre = milling.setup.stock.centre();
    ToolMarks marks;
    const AxisMode& axis = workbench_.workpiece.bound().axis;
    if (!axis.free && !toolTip_) marks.proxy.axis = axis.direction;
    marks.proxy.tip = toolTip_.value_or(glm::dvec3(centre.x, centre.y, milling.safeHeight()));
    viewport_.setToolMarks(marks);
}

void ScenePresenter::setUnit(LengthUnit unit) {
    viewport_.setLengthUnit(unit);
    Presenter::setUnit(unit);
}

void ScenePresenter::showBarePart(bool bare) {
    if (bare == bare_) return;
    bare_ = bare;
    presentSoon();
}

void ScenePresenter::setHiddenBodies(const std::set<std::size_t>& bodies) {
    hidden_ = bodies;
    emit hiddenBodiesChanged(hidden_);
    presentSoon();
}

/// With a workpiece, only the protected bodies of the model are drawn as the part.
std::vector<std::size_t> ScenePresenter::bodiesOfPart() const {
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; model_ && i < model_->bodies.size(); ++i)
        if (part_ == model_ || isProtected(roleOf(workbench_.setup.setup(), i))) bodies.push_back(i);
    return bodies;
}

std::vector<bool> ScenePresenter::hiddenOfPart() const {
    std::vector<bool> hidden;
    if (hidden_.empty()) return hidden;
    for (const std::size_t body : bodiesOfPart()) hidden.push_back(hidden_.contains(body));
    return hidden;
}

std::vector<std::optional<QColor>> ScenePresenter::coloursOfPart() const {
    const std::vector<BodyColour>& colours = workbench_.model.colours();
    std::vector<std::optional<QColor>> drawn;
    for (const std::size_t body : bodiesOfPart()) {
        if (body >= colours.size()) break;
        const QColor colour = colourFrom(colours[body]);
        drawn.push_back(colour.isValid() ? std::optional(colour) : std::nullopt);
    }
    return drawn;
}

void ScenePresenter::showToolAt(const glm::dvec3& tip, const Tool* tool) {
    toolTip_ = tip;
    shownTool_ = tool != nullptr ? std::optional(*tool) : std::nullopt;
    drawTool();
    placeTool();
}

void ScenePresenter::parkTool() {
    toolTip_.reset();
    shownTool_.reset();
    drawTool();
    placeTool();
}

void ScenePresenter::showWorkpiece() {
    const auto& milling = workbench_.workpiece.milling();
    viewport_.setWorkpiece(milling ? milling->embedded.workpiece.snapshot() : VolumeSnapshot());
    presentSoon();
}

void ScenePresenter::showTicks() {
    const SessionState& state = workbench_.session.state();
    showSample(state.sample, state.cutting);
}

void ScenePresenter::showSample(const Sample& sample, bool cutting) {
    ToolMarks marks;
    marks.proxy = sample.proxy;
    marks.stylusTip = sample.stylusTip;
    marks.force = sample.force;
    marks.ghost = workbench_.session.running() || sample.stylusTip != sample.proxy.tip;
    marks.alarm = (sample.flags & sampleShankContact) != 0;
    marks.cutting = cutting;
    viewport_.setToolMarks(marks);
}

void ScenePresenter::showMoment(const std::optional<MomentView>& moment) {
    const bool back = past_.has_value() && !moment;
    past_ = moment ? moment->sample : std::nullopt;
    if (moment) {
        viewport_.setWorkpiece(moment->workpiece);
        shownTool_ = moment->tool;
        drawTool();
        placeTool();
    } else if (back || shownTool_) {
        parkTool();
        if (!workbench_.session.running()) showWorkpiece();
    }
}

void ScenePresenter::showTrace(const std::vector<TracePoint>& points) {
    bool begins = false;
    stroke_.clear();
    const auto draw = [&] {
        if (!stroke_.empty()) live_.append(stroke_, begins);
        if (!stroke_.empty()) begins = false;
        stroke_.clear();
    };
    for (const TracePoint& point : points) {
        if (point.strokeBegins) {
            draw();
            begins = true;
        }
        stroke_.push_back(point.tip);
    }
    draw();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene.h"

#include "core/volume/operations/ray_cast.h"
#include "ui/scene/actors.h"
#include "ui/scene/aim_camera.h"
#include "ui/scene/excess_scale.h"
#include "ui/scene/view_lights.h"

#include <array>

namespace burin {
namespace {

std::array<std::uint8_t, 3> bytes(const QColor& colour) {
    return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
            static_cast<std::uint8_t>(colour.blue())};
}

/// The bounding box of what is drawn, mm, which near and far plane must enclose.
Box drawnBy(vtkRenderer& renderer) {
    std::array<double, 6> b{};
    renderer.ComputeVisiblePropBounds(b.data());
    return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

} // namespace

Scene::Scene(vtkRenderWindow& window, std::function<void()> workpieceReady, GuideActors::SurfaceMaker surfaces,
             ObstacleActors::SurfaceMaker obstacles)
    : preview_(window)
    , part_(*solids_, *marks_)
    , workpiece_(*solids_, *films_, std::move(workpieceReady))
    , tool_(*solids_, *films_)
    , livePath_(*solids_)
    , otherPaths_(*solids_)
    , editedPath_(*solids_)
    , valuedPath_(*solids_)
    , comparedPath_(*solids_, *marks_)
    , deviations_(*solids_)
    , grid_(*solids_)
    , shadow_(*solids_)
    , stock_(*solids_)
    , scaleBar_(*solids_)
    , obstacles_(*solids_, *films_, std::move(obstacles))
    , guides_(*films_, *marks_, std::move(surfaces))
    , section_(*solids_, *marks_)
    , ghost_(*marks_)
    , touch_(*marks_)
    , zero_(*marks_)
    , touchedVoxels_(*marks_)
    , moveMark_(*marks_)
    , outlines_(*marks_)
    , strokePlans_(*marks_)
    , area_(*marks_)
    , passPreview_(*marks_)
    , measure_(*marks_)
    , force_(*marks_)
    , gizmo_(*marks_)
    , cube_(window, 3)
    , excessScale_(*solids_) {
    window.SetNumberOfLayers(4);
    addViewLights(*solids_);
    addViewLights(*marks_);
    addViewLights(*films_);
    films_->SetLayer(1);
    films_->PreserveDepthBufferOn();
    films_->SetActiveCamera(solids_->GetActiveCamera());
    marks_->SetLayer(2);
    marks_->SetActiveCamera(solids_->GetActiveCamera());
    window.AddRenderer(solids_);
    window.AddRenderer(films_);
    window.AddRenderer(marks_);
}

void Scene::setPalette(const Palette& palette) {
    setBackdrop(*solids_, palette.sceneTop, palette.sceneBottom);
    preview_.setPalette(palette);
    partColour_ = palette.part;
    edgeColour_ = palette.pathHalo;
    colourPart();
    workpiece_.setPartColour(bytes(palette.part));
    excessScale_.setPalette(palette);
    tool_.setPalette(palette);
    livePath_.setColours(palette.livePath, palette.pathHalo);
    editedPath_.setPalette(palette);
    valuedPath_.setPalette(palette);
    otherPaths_.setPalette(palette);
    comparedPath_.setPalette(palette);
    grid_.setColour(palette.grid);
    shadow_.setPalette(palette);
    stock_.setColour(palette.quietText);
    scaleBar_.setPalette(palette);
    obstacles_.setPalette(palette);
    guides_.setPalette(palette);
    section_.setPalette(palette);
    ghost_.setPalette(palette);
    touch_.setPalette(palette);
    zero_.setPalette(palette);
    touchedVoxels_.setColours(palette.force, palette.pathHalo);
    moveMark_.setColours(palette.chosenPath, palette.pathHalo);
    outlines_.setColours(palette.rapidPath, palette.pathHalo);
    strokePlans_.setColours(palette.chosenPath, palette.pathHalo);
    area_.setColours(palette.chosenPath, palette.pathHalo);
    passPreview_.setColours(palette.rapidPath, palette.pathHalo);
    measure_.setPalette(palette);
    force_.setPalette(palette);
    gizmo_.setPalette(palette);
    cube_.setPalette(palette);
}

void Scene::setPathValues(std::shared_ptr<const PathValues> values) {
    editedPath_.setFeedsHidden(values != nullptr);
    valuedPath_.setValues(std::move(values));
}

void Scene::setPathVisible(bool visible) {
    editedPath_.setVisible(visible);
    valuedPath_.setVisible(visible);
}

void Scene::setPart(std::vector<ShadedBody> bodies, const Box& box) {
    workpiece_.setPartDrawn(!bodies.empty());
    part_.setBodies(std::move(bodies));
    partBox_ = box;
    announced_ = {};
    movePart(moved_);
    refresh();
}

void Scene::movePart(const Placement& by) {
    moved_ = by;
    part_.setMotion(combined(announced_, moved_));
}

void Scene::announcePart() {
    announced_ = combined(announced_, moved_);
    moved_ = {};
}

void Scene::setPreview(std::vector<ShadedBody> bodies, const Box& content) {
    preview_.set(std::move(bodies), content);
    for (vtkRenderer* layer : {solids_.Get(), films_.Get(), marks_.Get()}) layer->DrawOff();
}

void Scene::clearPreview() {
    preview_.clear();
    solids_->DrawOn(); // the other renderers are enabled at the next paint
    refresh();
}

void Scene::setPartVisible(std::optional<bool> visible) {
    partRequest_ = visible;
    refresh();
}

void Scene::setDeviations(const DeviationSurface& surface) {
    deviations_.set(surface);
    part_.setCovered(!deviations_.empty());
}

void Scene::setStock(const std::optional<Box>& stock) {
    stock_.setBox(stock);
    refresh();
}

void Scene::setWorkpiece(const VolumeSnapshot& workpiece,
                         std::optional<std::chrono::steady_clock::time_point> oldestCut) {
    shown_ = workpiece;
    section_.workpieceChanged();
    workpiece_.show(workpiece, oldestCut);
    refresh();
}

void Scene::setWorkpieceVisible(bool visible) {
    workpieceVisible_ = visible;
    workpiece_.setVisible(visible);
    section_.workpieceChanged();
    refresh();
}

void Scene::setWorkpieceOpacity(double opacity) {
    seenThrough_ = opacity < 1.0;
    workpiece_.setOpacity(opacity);
    refresh();
}

void Scene::setExcess(std::optional<ExcessColours> left) {
    left_ = left;
    workpiece_.setExcess(std::move(left));
    excessScale_.setVisible(left_.has_value());
    colourPart();
    fillExcessScale();
}

/// Bare part has no stock left on it.
void Scene::colourPart() {
    if (!left_) return part_.setColours(partColour_, edgeColour_);
    const DeviationColour bare = left_->scale().colourOf(0.0);
    part_.setColours(QColor(bare[0], bare[1], bare[2]), edgeColour_);
}

void Scene::fillExcessScale() {
    if (left_) excessScale_.set(excessScale(left_->scale(), unit_));
}

void Scene::setSection(const std::optional<SectionPlane>& plane) {
    const bool wasOn = section_.plane().has_value();
    section_.set(plane);
    if (plane.has_value() == wasOn) return;
    vtkPlane* clip = plane ? &section_.clip() : nullptr;
    part_.setClip(clip);
    workpiece_.setClip(clip);
}

void Scene::setTool(const std::optional<Tool>& tool) {
    tool_.setTool(tool);
    ghost_.setTool(tool);
}

void Scene::setToolVisible(bool visible) {
    toolVisible_ = visible;
    tool_.setVisible(visible);
    ghost_.setVisible(visible);
    force_.set(visible ? toolMarks_.force : glm::dvec3(0.0), toolMarks_.proxy.tip);
}

void Scene::setMarks(const ToolMarks& marks, bool flashLit) {
    toolMarks_ = marks;
    tool_.setPose(marks.proxy);
    tool_.setAlarm(marks.alarm, flashLit);
    guides_.setTip(marks.proxy.tip);
    ghost_.set(marks.ghost, marks.stylusTip, marks.proxy);
    force_.set(toolVisible_ ? marks.force : glm::dvec3(0.0), marks.proxy.tip);
}

void Scene::setPressMark(const std::optional<PressMark>& mark) {
    touch_.set(mark);
    part_.setGhost(partSeen_ || mark.has_value());
}

void Scene::setPartSeen(bool seen) {
    partSeen_ = seen;
    part_.setGhost(seen || touch_.visible());
}

void Scene::setObstacles(std::vector<ObstacleMark> marks) {
    obstacles_.set(std::move(marks));
    refresh();
}

Box Scene::contentBox() const {
    if (preview_.shown()) return preview_.content();
    Box content = partBox_;
    if (stock_.box()) content.include(*stock_.box());
    if (!shown_.empty()) content.include(shown_.grid().box());
    content.include(obstacles_.box());
    return content;
}

void Scene::refresh() {
    part_.setInWorkpiece(workpieceSeen());
    part_.setVisible(partRequest_.value_or(!workpieceSeen()) || (seenThrough_ && workpieceSeen()));
    stock_.setFaces(shown_.empty());
    grid_.setContent(contentBox());
    shadow_.setContent(contentBox());
}

std::optional<glm::dvec3> Scene::pick(const Sight& sight) const {
    if (preview_.shown()) return preview_.pick(sight);
    Sight seen = sight;
    if (section_.plane()) seen.origin += burin::seenFrom(*section_.plane(), sight) * sight.direction;
    std::optional<glm::dvec3> nearest = part_.pick(seen);
    if (workpieceSeen()) {
        const std::optional<RayHit> hit = castRay(shown_, seen.origin, seen.direction);
        if (hit && (!nearest || hit->distance < glm::distance(seen.origin, *nearest))) nearest = hit->place;
    }
    return nearest;
}

std::vector<CutPlace> Scene::cuts() const {
    std::vector<CutPlace> places;
    if (const std::optional<CutPlace> cut = tool_.cut()) places.push_back(*cut);
    if (const auto& press = touch_.mark()) places.push_back({{press->tip, press->axis}, press->radius});
    return places;
}

void Scene::setLineWidths(double ratio) {
    if (ratio == lineRatio_) return;
    lineRatio_ = ratio;
    preview_.setLineWidths(ratio);
    livePath_.setLineWidth(pathLine * ratio);
    editedPath_.setLineWidth(pathLine * ratio);
    valuedPath_.setLineWidth(pathLine * ratio);
    otherPaths_.setLineWidth(pathLine * ratio);
    comparedPath_.setLineWidth(ratio);
    section_.setLineWidth(boldLine * ratio);
    ghost_.setLineWidth(boldLine * ratio);
    touch_.setLineWidth(pathLine * ratio);
    zero_.setLineWidth(boldLine * ratio);
    gizmo_.setLineWidth(boldLine * ratio);
    moveMark_.setLineWidth(boldLine * ratio);
    measure_.setLineWidth(boldLine * ratio);
    outlines_.setLineWidth(pathLine * ratio);
    strokePlans_.setLineWidth(pathLine * ratio);
    area_.setLineWidth(pathLine * ratio);
    passPreview_.setLineWidth(thinLine * ratio);
    obstacles_.setLineWidth(ratio);
    guides_.setLineWidth(thinLine * ratio);
    tool_.setLineWidth(edgeLine * ratio);
    part_.setLineWidth(thinLine * ratio);
    stock_.setLineWidth(thinLine * ratio);
    grid_.setLineWidth(thinLine * ratio);
}

std::optional<std::chrono::steady_clock::time_point> Scene::prepare(const CameraView& view, const QSizeF& size,
                                                                    double ratio, bool moving) {
    setLineWidths(ratio);
    cube_.place(view, size, ratio);
    if (preview_.shown()) {
        preview_.place(view, size, ratio);
        aimCamera(preview_.renderer(), drawnBy(preview_.renderer()), view);
        preview_.setDepthCue(depthCue(preview_.renderer()));
        return std::nullopt;
    }
    part_.setDetail(moving, pixelAt(view, size, view.focus) / ratio);
    workpiece_.update(moving, toolMarks_.proxy.tip);
    part_.setBare(workpiece_.bare());
    if (std::exchange(workpieceDrawn_, workpiece_.volume()) != workpiece_.volume()) part_.drawLast();
    stock_.drawLast();
    tool_.place(view);
    obstacles_.place(cuts(), view);
    scaleBar_.place(view, size, ratio);
    excessScale_.place(size, ratio, valuedPath_.scale().place(size, ratio, 0.0));
    force_.place(view, size, ratio);
    guides_.place(view, size, ratio);
    touch_.place(view, size, ratio);
    measure_.place(view, size, ratio);
    zero_.place(view, size, ratio);
    gizmo_.place(view, size, ratio);
    section_.place(workpieceSeen() ? shown_ : VolumeSnapshot(), contentBox(), view, size);
    films_->SetDraw(guides_.visible() || obstacles_.filmsVisible() || tool_.filmsVisible() ||
                    workpiece_.filmsVisible());
    marks_->SetDraw(ghost_.visible() || force_.visible() || guides_.visible() || moveMark_.visible() ||
                    outlines_.visible() || strokePlans_.visible() || area_.visible() || passPreview_.visible() ||
                    touch_.visible() || measure_.visible() || touchedVoxels_.visible() || zero_.visible() ||
                    comparedPath_.marksVisible() || gizmo_.visible() || section_.plane().has_value());

    aimCamera(*solids_, drawnBounds(), view);
    const DepthCue cue = depthCue(*solids_);
    part_.setDepthCue(cue);
    workpiece_.setDepthCue(cue);
    return workpieceSeen() ? workpiece_.takeCutShown() : std::nullopt;
}

Box Scene::drawnBounds() {
    Box bounds = drawnBy(*solids_);
    for (vtkRenderer* layer : {films_.Get(), marks_.Get()})
        if (layer->GetDraw() != 0) bounds.include(drawnBy(*layer));
    return bounds;
}

void Scene::aimCamera(vtkRenderer& renderer, const Box& bounds, const CameraView& view) {
    vtkCamera* camera = renderer.GetActiveCamera();
    if (bounds.empty()) return aim(*camera, view, view.distance);
    aim(*camera, view, glm::distance(view.focus, bounds.centre()) + glm::length(bounds.size()));
    const std::array<double, 6> b{bounds.low.x,  bounds.high.x, bounds.low.y,
                                  bounds.high.y, bounds.low.z,  bounds.high.z};
    renderer.ResetCameraClippingRange(b.data());
}

DepthCue Scene::depthCue(vtkRenderer& renderer) const {
    vtkCamera& camera = *renderer.GetActiveCamera();
    glm::dvec3 eye, along;
    camera.GetPosition(&eye.x);
    camera.GetDirectionOfProjection(&along.x);
    return depthCueOf(contentBox(), eye, along);
}

std::size_t Scene::triangles() const {
    if (preview_.shown()) return preview_.triangles();
    return part_.triangles() + deviations_.triangles() + tool_.triangles() +
           (workpieceSeen() ? workpiece_.triangles() : 0);
}

} // namespace burin

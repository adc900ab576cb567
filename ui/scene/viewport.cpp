// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/viewport.h"

#include "ui/scene/viewport_impl.h"

#include "core/base/background.h"

#include <QOpenGLContext>

#include <utility>

namespace burin {

namespace {

bool same(const ToolMarks& a, const ToolMarks& b) {
    return a.proxy.tip == b.proxy.tip && a.proxy.axis == b.proxy.axis && a.stylusTip == b.stylusTip &&
           a.force == b.force && a.ghost == b.ghost && a.alarm == b.alarm && a.cutting == b.cutting;
}

/// A tetrahedron with edges, drawn like any part.
std::vector<ShadedBody> sampleBodies() {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return {ShadedBody{std::make_shared<const ShadedMesh>(shaded(mesh, creaseAngle)), std::nullopt}};
}

} // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>(*this)) {
    impl_->canvas = Canvas::make(*this, *impl_);
    setObjectName(QStringLiteral("viewport"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    QCoreApplication::instance()->installEventFilter(this);
    setMinimumSize(160, 120);
    connect(&impl_->rest, &QTimer::timeout, this, [this] { impl_->refresh(); });
    connect(&impl_->turn, &QTimer::timeout, this, [this] { impl_->canvas->refresh(); });
    connect(&impl_->breath, &QTimer::timeout, this, [this] {
        if (std::exchange(impl_->waiting, false)) impl_->refresh();
    });
    connect(&impl_->flash, &QTimer::timeout, this, [this] {
        impl_->flashLit = !impl_->flashLit;
        impl_->scene.setMarks(impl_->marks, impl_->flashLit);
        impl_->refresh();
    });
}

Viewport::~Viewport() = default;

void Viewport::setPalette3D(const Palette& palette) {
    impl_->scene.setPalette(palette);
    impl_->refresh();
}

void Viewport::setLengthUnit(LengthUnit unit) {
    impl_->scene.setLengthUnit(unit);
    impl_->refresh();
}

void Viewport::setPart(std::shared_ptr<const Model> model) {
    // The part that was to replace its preview won't arrive any more.
    if (std::exchange(impl_->previewEnds, false)) impl_->endPreview(true);
    impl_->orderPart(std::move(model), [] {});
}

void Viewport::setPreviewedPart(std::shared_ptr<const Model> model) {
    ++impl_->previewOrdered; // discards a preview that isn't drawn yet
    if (!impl_->scene.previewing()) fit();
    impl_->previewEnds = true;
    impl_->orderPart(std::move(model), [this] {
        impl_->previewEnds = false;
        impl_->endPreview(true);
    });
}

void Viewport::setPreview(const std::shared_ptr<const ModelPreview>& preview, double margin) {
    const std::uint64_t order = ++impl_->previewOrdered;
    if (!preview) return impl_->endPreview(false);
    impl_->onPool([preview, margin] { return std::pair(shadedBodies(*preview), boundsOf(*preview, margin)); },
                  [impl = impl_.get(), order](const auto& made) {
                      if (impl->previewOrdered == order) impl->showPreview(made->first, made->second);
                  });
}

bool Viewport::showsPreview() const {
    return impl_->scene.previewing();
}

/// @param drawn called as soon as the part is drawn
void Viewport::Impl::orderPart(std::shared_ptr<const Model> model, std::function<void()> drawn) {
    const std::uint64_t order = ++partOrdered;
    part = model;
    scene.announcePart();
    if (!model) {
        scene.setPart({}, {});
        contentChanged();
        return;
    }
    // Shading takes some tenths of a second for a large part, and the simplified part for moving scenes some more, so
    // both run on a pool thread.
    const QPointer<Viewport> self(&widget);
    QThreadPool::globalInstance()->start([self, model = std::move(model), order, drawn = std::move(drawn)] {
        workInBackground();
        const auto inWindow = [&](auto change) {
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [self, order, change = std::move(change)] {
                    if (!self || self->impl_->partOrdered != order) return;
                    change(self->impl_->scene);
                    self->impl_->contentChanged();
                },
                Qt::QueuedConnection);
        };
        const std::vector<ShadedBody> bodies = shadedBodies(*model);
        const Box box = model->box();
        inWindow([bodies, box, drawn](Scene& of) {
            of.setPart(bodies, box);
            drawn();
        });
        inWindow([coarse = coarseBodies(bodies, glm::length(box.size()))](Scene& of) { of.setCoarsePart(coarse); });
    });
}

void Viewport::movePart(const Placement& by) {
    impl_->scene.movePart(by);
    impl_->moved();
}

void Viewport::setPartVisible(bool visible) {
    impl_->scene.setPartVisible(visible);
    impl_->refresh();
}

void Viewport::setStockOutline(const std::optional<Box>& stock) {
    impl_->scene.setStock(stock);
    impl_->contentChanged();
}

void Viewport::setWorkpiece(const VolumeSnapshot& workpiece,
                            std::optional<std::chrono::steady_clock::time_point> oldestCut) {
    impl_->scene.setWorkpiece(workpiece, oldestCut);
    impl_->motion.setContent(impl_->scene.contentBox());
    if (oldestCut) impl_->moved(); // otherwise the worker calls when there is a new picture
}

void Viewport::setWorkpieceVisible(bool visible) {
    impl_->scene.setWorkpieceVisible(visible);
    impl_->refresh();
}

void Viewport::setWorkpieceOpacity(double opacity) {
    impl_->scene.setWorkpieceOpacity(opacity);
    impl_->refresh();
}

void Viewport::setSection(const std::optional<SectionPlane>& plane) {
    if (plane == impl_->scene.section().plane()) return;
    impl_->scene.setSection(plane);
    if (!plane) impl_->sectionGrip.reset();
    impl_->moved();
}

Box Viewport::contentBox() const {
    return impl_->scene.contentBox();
}

void Viewport::setTool(const std::optional<Tool>& tool) {
    impl_->scene.setTool(tool);
    impl_->refresh();
}

void Viewport::setToolMarks(const ToolMarks& marks) {
    if (same(marks, impl_->marks)) return;
    const bool toolMoved = marks.proxy.tip != impl_->marks.proxy.tip || marks.proxy.axis != impl_->marks.proxy.axis;
    impl_->marks = marks;
    if (marks.alarm != impl_->flash.isActive()) {
        impl_->flashLit = true;
        marks.alarm ? impl_->flash.start() : impl_->flash.stop();
    }
    impl_->scene.setMarks(marks, impl_->flashLit);
    toolMoved || marks.cutting ? impl_->moved() : impl_->refresh();
}

void Viewport::setToolVisible(bool visible) {
    impl_->scene.setToolVisible(visible);
    impl_->refresh();
}

void Viewport::setPressMark(const std::optional<PressMark>& mark) {
    if (mark == impl_->press) return;
    impl_->press = mark;
    impl_->scene.setPressMark(mark);
    impl_->refresh();
}

void Viewport::setPartSeen(bool seen) {
    impl_->scene.setPartSeen(seen);
    impl_->refresh();
}

void Viewport::setZero(const std::optional<ZeroPlace>& zero) {
    if (zero == impl_->zero) return;
    impl_->zero = zero;
    impl_->scene.setZero(zero);
    impl_->refresh();
}

void Viewport::setObstacles(const std::vector<ObstacleMark>& obstacles) {
    if (obstacles == impl_->obstacles) return;
    impl_->obstacles = obstacles;
    impl_->scene.setObstacles(obstacles);
    impl_->contentChanged();
}

void Viewport::setGuides(const GuideMarks& guides) {
    if (guides == impl_->guides) return;
    impl_->guides = guides;
    impl_->scene.setGuides(guides);
    impl_->refresh();
}

void Viewport::appendLivePath(std::span<const glm::vec3> tips, bool newStroke) {
    if (tips.empty()) return;
    impl_->scene.livePath().append(tips, newStroke);
    impl_->refresh();
}

void Viewport::clearLivePath() {
    impl_->scene.livePath().clear();
    impl_->refresh();
}

void Viewport::setPath(const EvaluatedPath& path) {
    impl_->scene.editedPath().setPath(path);
    impl_->refresh();
}

void Viewport::setPathValues(std::shared_ptr<const PathValues> values) {
    impl_->scene.setPathValues(std::move(values));
    impl_->refresh();
}

void Viewport::setExcess(std::optional<ExcessColours> left) {
    impl_->scene.setExcess(std::move(left));
    impl_->refresh();
}

void Viewport::setHiddenBodies(std::vector<bool> hidden) {
    impl_->scene.setHiddenBodies(std::move(hidden));
    impl_->refresh();
}

void Viewport::setBodyColours(std::vector<std::optional<QColor>> colours) {
    impl_->scene.setBodyColours(std::move(colours));
    impl_->refresh();
}

void Viewport::setMeasureMark(const std::optional<MeasureMark>& mark) {
    impl_->scene.measure().set(mark);
    impl_->refresh();
}

void Viewport::setGizmo(const std::optional<GizmoMark>& mark) {
    if (mark == impl_->gizmo) return;
    impl_->gizmo = mark;
    impl_->scene.gizmo().set(mark);
    impl_->refresh();
}

void Viewport::setPathVisible(bool visible) {
    impl_->scene.setPathVisible(visible);
    impl_->refresh();
}

void Viewport::setOtherPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths) {
    impl_->scene.otherPaths().setPaths(paths);
    impl_->refresh();
}

void Viewport::setOtherPathsVisible(bool visible) {
    impl_->scene.otherPaths().setVisible(visible);
    impl_->refresh();
}

void Viewport::setComparison(const ComparisonMark& mark) {
    impl_->scene.comparedPath().set(mark);
    impl_->refresh();
}

void Viewport::setDeviations(const DeviationPicture& picture) {
    const std::uint64_t order = ++impl_->deviationsOrdered;
    if (!picture.samples || picture.samples->empty() || !impl_->part) {
        impl_->scene.setDeviations({});
        impl_->refresh();
        return;
    }
    impl_->onPool([part = impl_->part, picture] { return deviationSurface(*part, picture); },
                  [impl = impl_.get(), order](const std::shared_ptr<const DeviationSurface>& surface) {
                      if (impl->deviationsOrdered == order) impl->scene.setDeviations(*surface);
                  });
}

void Viewport::setOutlines(const PlaceChains& lines) {
    impl_->scene.outlines().set(lines);
    impl_->refresh();
}

void Viewport::setStrokePlans(const PlaceChains& lines) {
    impl_->scene.strokePlans().set(lines);
    impl_->refresh();
}

void Viewport::setArea(const PlaceChains& lines) {
    impl_->scene.area().set(lines);
    impl_->refresh();
}

void Viewport::setPassPreview(const PlaceChains& lines) {
    impl_->scene.passPreview().set(lines);
    impl_->refresh();
}

void Viewport::setTouchedVoxels(const std::vector<TouchedVoxels>& areas) {
    impl_->scene.touchedVoxels().set(areas);
    impl_->refresh();
}

void Viewport::setMoveMark(const PlaceChains& moves) {
    impl_->scene.moveMark().set(moves);
    impl_->refresh();
}

void Viewport::setStandardView(StandardView view) {
    impl_->motion.turnTo(view, CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

void Viewport::setParallel(bool parallel) {
    impl_->motion.setParallel(parallel, CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

const CameraView& Viewport::cameraView() const noexcept {
    return impl_->motion.view();
}

void Viewport::setCameraView(const CameraView& view) {
    impl_->motion.setView(view);
    impl_->moved();
}

void Viewport::fit() {
    impl_->motion.fit(CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

void Viewport::push(const CameraPush& push, double seconds) {
    impl_->motion.push(push, seconds, CameraMotion::Clock::now(), impl_->flight());
    impl_->moved();
}

InteractiveTool* Viewport::interactiveTool() const {
    return impl_->tool;
}

void Viewport::setInteractiveTool(InteractiveTool* tool) {
    if (impl_->tool != nullptr && impl_->tool != tool) impl_->tool->leave();
    impl_->tool = tool;
    emit interactiveToolChanged();
}

void Viewport::setHandleTool(InteractiveTool* tool) {
    if (impl_->handles != nullptr && impl_->handles != tool) impl_->handles->leave();
    impl_->handles = tool;
}

InteractiveTool* Viewport::handleTool() const {
    return impl_->handles;
}

ViewportEvent Viewport::sight(const QPointF& position) const {
    const Sight sight = sightThrough(impl_->motion.view(), QSizeF(size()), position);
    ViewportEvent event;
    event.position = position;
    event.rayOrigin = sight.origin;
    event.rayDirection = sight.direction;
    event.parallel = sight.parallel;
    if (const auto& plane = impl_->scene.section().plane()) event.seenFrom = seenFrom(*plane, sight);
    return event;
}

std::optional<glm::dvec3> Viewport::pick(const QPointF& position) const {
    if (impl_->scene.previewing()) return std::nullopt;
    return impl_->scene.pick(sightThrough(impl_->motion.view(), impl_->motion.size(), position));
}

VolumeSnapshot Viewport::workpiece() const {
    return impl_->scene.previewing() ? VolumeSnapshot() : impl_->scene.seenWorkpiece();
}

QPointF Viewport::project(const glm::dvec3& place) const {
    return appearanceOf(impl_->motion.view(), QSizeF(size()), place);
}

FrameStatistics Viewport::statistics() const {
    FrameStatistics statistics = impl_->clock.statistics();
    const WorkpieceActors& workpiece = impl_->scene.workpiece();
    statistics.triangles = impl_->scene.triangles();
    statistics.fullDetail = !impl_->paintedMoving && workpiece.fullDetail();
    statistics.busy = workpiece.busy();
    return statistics;
}

void Viewport::resetStatistics() {
    impl_->clock.reset();
}

QString Viewport::obstacleOf(const QOpenGLContext* context) {
    if (context == nullptr || !context->isValid())
        return tr("The 3D view needs OpenGL 3.2 or later; this computer offers none. A driver of the graphics card may "
                  "be missing.");
    const QSurfaceFormat format = context->format();
    if (format.version() >= qMakePair(3, 2) && !context->isOpenGLES()) return {};
    return tr("The 3D view needs OpenGL 3.2 or later; this computer offers %1.%2. A newer driver of the graphics card "
              "may help.")
        .arg(format.majorVersion())
        .arg(format.minorVersion());
}

QString Viewport::drawingObstacle() {
    QOpenGLContext context;
    return obstacleOf(context.create() ? &context : nullptr);
}

void Viewport::warmUp() {
    if (isVisible() || impl_->part || !drawingObstacle().isEmpty()) return;
    impl_->canvas->warmUp();
    QTimer::singleShot(0, this, [this] {
        if (isVisible() || impl_->part) return;
        impl_->scene.setPart(sampleBodies(), {});
        impl_->canvas->warmUp();
        impl_->scene.setPart({}, {});
    });
}

bool Viewport::isValid() const {
    return impl_->canvas->isValid();
}

QImage Viewport::grabFramebuffer() {
    return impl_->canvas->grab();
}

void Viewport::resizeEvent(QResizeEvent*) {
    impl_->motion.setSize(QSizeF(size()));
    impl_->canvas->widget().setGeometry(rect());
}

} // namespace burin

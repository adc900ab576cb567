// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/guide_actors.h"

#include "ui/scene/actors.h"
#include "ui/scene/film_actor.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double filmOpacity = 0.13, holdingFilmOpacity = 0.22;
constexpr double throughOpacity = 0.30, holdingThroughOpacity = 0.45, quietOpacity = 0.34, quietThroughOpacity = 0.14;
constexpr double holdingWidth = 2.0, usualWidth = 1.2; // thin lines
constexpr double tubeRadius = 1.6, holdingTubeRadius = 2.6, tubeFits = 1.25;
constexpr double leaningLength = 120.0; // device-independent pixels
constexpr double labelLeft = 12.0, labelTop = 12.0, labelStep = 26.0;
constexpr int tubeSides = 8;

void give(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

} // namespace

/// One guide on the screen.
struct GuideActors::Drawn {
    Drawn(vtkRenderer& seenRenderer, vtkRenderer& throughRenderer)
        : seen(seenRenderer), through(throughRenderer), label(throughRenderer) {
        tubes->SetNumberOfSides(tubeSides);
        tubes->SetInputData(vtkNew<vtkPolyData>());
        tube = surfaceActor(vtkNew<vtkPolyData>());
        tube->GetMapper()->SetInputConnection(tubes->GetOutputPort());
        tube->GetProperty()->LightingOff();
        tube->PickableOff();
        for (vtkActor* actor : {film.Get(), lines.Get(), quiet.Get(), tube.Get()}) seen.AddActor(actor);
        for (vtkActor* actor : {linesThrough.Get(), quietThrough.Get(), tubeThrough.Get()}) through.AddActor(actor);
    }
    ~Drawn() {
        for (vtkActor* actor : {film.Get(), lines.Get(), quiet.Get(), tube.Get()}) seen.RemoveActor(actor);
        for (vtkActor* actor : {linesThrough.Get(), quietThrough.Get(), tubeThrough.Get()}) through.RemoveActor(actor);
    }
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;

    void setShapes(const GuideShapes& shapes) {
        give(*film, shapes.film);
        for (vtkActor* actor : {lines.Get(), linesThrough.Get()}) give(*actor, shapes.lines);
        for (vtkActor* actor : {quiet.Get(), quietThrough.Get()}) give(*actor, shapes.quiet);
        give(*tubeThrough, shapes.tube);
        tubes->SetInputData(shapes.tube);
        hasTube = shapes.tube->GetNumberOfLines() > 0;
        tube->SetVisibility(hasTube);
        if (hasTube)
            middle = glm::dvec3(shapes.tube->GetCenter()[0], shapes.tube->GetCenter()[1], shapes.tube->GetCenter()[2]);
    }

    vtkRenderer &seen, &through;
    vtkSmartPointer<vtkActor> film = filmActor(vtkNew<vtkPolyData>());
    vtkSmartPointer<vtkActor> lines = raisedLineActor(vtkNew<vtkPolyData>()),
                              quiet = raisedLineActor(vtkNew<vtkPolyData>()), tube;
    vtkSmartPointer<vtkActor> linesThrough = lineActor(vtkNew<vtkPolyData>()),
                              quietThrough = lineActor(vtkNew<vtkPolyData>()),
                              tubeThrough = lineActor(vtkNew<vtkPolyData>());
    vtkNew<vtkTubeFilter> tubes;
    Label label;
    GuideMark mark;
    glm::dvec3 middle{0.0}; ///< mm, centre of what is drawn as a tube
    bool hasTube = false;
    std::uint64_t order = 0; ///< number of the surface that is requested or shown
};

GuideActors::GuideActors(vtkRenderer& seen, vtkRenderer& through, SurfaceMaker maker)
    : seen_(seen), through_(through), maker_(std::move(maker)) {}

GuideActors::~GuideActors() = default;

void GuideActors::setPalette(const Palette& palette) {
    palette_ = palette;
    for (const auto& drawn : drawn_) colour(*drawn);
}

void GuideActors::setLineWidth(double screenPixels) {
    lineWidth_ = screenPixels;
    for (const auto& drawn : drawn_) colour(*drawn);
}

void GuideActors::set(const GuideMarks& marks) {
    const GuideMarks before = std::exchange(marks_, marks);
    const bool sameRoom = before.room.low == marks.room.low && before.room.high == marks.room.high;
    const bool sameField =
        before.field == marks.field && before.tips.low == marks.tips.low && before.tips.high == marks.tips.high;
    drawn_.resize(std::min(drawn_.size(), marks.guides.size()));
    for (std::size_t i = 0; i < marks.guides.size(); ++i) {
        const GuideMark& mark = marks.guides[i];
        const bool fresh = i >= drawn_.size();
        if (fresh) drawn_.push_back(std::make_unique<Drawn>(seen_, through_));
        Drawn& drawn = *drawn_[i];
        const GuideMark old = std::exchange(drawn.mark, mark);
        const bool same = !fresh && sameRoom && shapedAlike(old, mark) &&
                          (mark.guide.kind != GuideKind::surface || sameField) &&
                          (mark.guide.kind != GuideKind::stepOver || before.lastPass == marks.lastPass);
        if (!same) shape(drawn, mark);
        if (fresh || old.holds != mark.holds || old.guide.kind != mark.guide.kind) colour(drawn);
    }
}

void GuideActors::shape(Drawn& drawn, const GuideMark& mark) {
    drawn.order = 0;
    if (mark.guide.kind == GuideKind::surface && marks_.field) return orderSurface(drawn);
    drawn.setShapes(shapesOf(mark, marks_));
}

/// The previous surface stays until the new one is ready.
void GuideActors::orderSurface(Drawn& drawn) {
    const std::uint64_t order = drawn.order = ++orders_;
    maker_(marks_, drawn.mark.guide.distance, [this, order](const std::shared_ptr<const GuideSurface>& surface) {
        for (const auto& waiting : drawn_) {
            if (waiting->order != order) continue;
            vtkNew<vtkPolyData> none;
            waiting->setShapes({surface->shell, surface->contours, none, none});
        }
    });
}

void GuideActors::colour(Drawn& drawn) const {
    const bool holds = drawn.mark.holds;
    const QColor& colour = holds ? palette_.accent : palette_.guide;
    for (vtkActor* actor :
         {drawn.film.Get(), drawn.lines.Get(), drawn.tube.Get(), drawn.linesThrough.Get(), drawn.tubeThrough.Get()})
        setColour(*actor, colour);
    for (vtkActor* actor : {drawn.quiet.Get(), drawn.quietThrough.Get()}) setColour(*actor, palette_.guide);
    drawn.film->GetProperty()->SetOpacity(holds ? holdingFilmOpacity : filmOpacity);
    setBlended(*drawn.linesThrough, holds ? holdingThroughOpacity : throughOpacity);
    setBlended(*drawn.tubeThrough, holds ? holdingThroughOpacity : throughOpacity);
    setBlended(*drawn.quiet, quietOpacity);
    setBlended(*drawn.quietThrough, quietThroughOpacity);
    const double width = lineWidth_ * (holds ? holdingWidth : usualWidth);
    for (vtkActor* actor : {drawn.lines.Get(), drawn.linesThrough.Get()}) burin::setLineWidth(*actor, width);
    for (vtkActor* actor : {drawn.quiet.Get(), drawn.quietThrough.Get()}) burin::setLineWidth(*actor, lineWidth_);
    burin::setLineWidth(*drawn.tubeThrough, 1.5 * width);
}

void GuideActors::place(const CameraView& view, const QSizeF& size, double ratio) {
    for (const auto& drawn : drawn_) {
        if (drawn->mark.guide.kind == GuideKind::axis)
            drawn->setShapes(leaningShapes(drawn->mark, tip_, leaningLength * pixelAt(view, size, tip_)));
        if (!drawn->hasTube) continue;
        const double wanted = (drawn->mark.holds ? holdingTubeRadius : tubeRadius) * pixelAt(view, size, drawn->middle);
        const double now = drawn->tubes->GetRadius();
        // A radius that is approximately right is kept, to save the cost of a change.
        if (!(wanted < now * tubeFits && now < wanted * tubeFits)) drawn->tubes->SetRadius(wanted);
    }
    placeLabels(size, ratio);
}

/// Places the labels one below the other in the upper left corner.
void GuideActors::placeLabels(const QSizeF& size, double ratio) {
    QColor plate = palette_.field;
    plate.setAlpha(190);
    const int height = static_cast<int>(std::lround(size.height() * ratio));
    double top = labelTop;
    for (const auto& drawn : drawn_) {
        drawn->label.setVisible(!drawn->mark.label.isEmpty());
        if (drawn->mark.label.isEmpty()) continue;
        drawn->label.set(drawn->mark.label, drawn->mark.holds ? palette_.accent : palette_.guide, plate, ratio);
        drawn->label.setUpperLeft(QPointF(labelLeft, top) * ratio, height);
        top += labelStep;
    }
}

} // namespace burin

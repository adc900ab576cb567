// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/picture.h"

#include "ui/scene/offscreen_context.h"
#include "ui/scene/scene.h"
#include "ui/scene/section_side.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

namespace burin {

namespace {

using namespace std::chrono_literals;

constexpr int samplesPerPixel = 8;
constexpr double largestToolShare = 1.0 / 3.0; // of the content's diagonal: the tool must not dwarf the workpiece

/// VTK 9.1 logs two lines about GLEW for every context without an X server; they are harmless.
class QuietVtk {
public:
    QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    int before_;
};

void makeReady(vtkGenericOpenGLRenderWindow& window, const PictureContent& content) {
    window.SetMapped(true);
    window.SetIsCurrent(true);
    window.SetReadyForRendering(true);
    window.SetOwnContext(0);
    window.SetSize(content.width, content.height);
    window.OpenGLInitContext();
    window.SetMultiSamples(samplesPerPixel);
}

std::vector<ObstacleMark> marksOf(const std::vector<Obstacle>& obstacles) {
    std::vector<ObstacleMark> marks;
    for (const Obstacle& obstacle : obstacles)
        marks.push_back({std::make_shared<const Obstacle>(obstacle), obstacle.on, false});
    return marks;
}

/// A view from far enough away to show the content, and as much of the tool as doesn't dwarf it.
CameraView viewOf(const PictureContent& content, StandardView from, const Box& shown) {
    CameraView view = turnedTo({}, from);
    view.convergence = from == StandardView::isometric ? 1.0 : 0.0;
    Box box = shown;
    if (content.tool) {
        const double height =
            std::min(0.75 * content.tool->cutter.stickOut, glm::length(shown.size()) * largestToolShare);
        box.include(content.pose.tip + height * content.pose.axis);
    }
    return fitted(view, QSizeF(content.width, content.height), box);
}

void fill(Scene& scene, const PictureContent& content) {
    if (content.part) scene.setPart(shadedBodies(*content.part), content.part->box());
    scene.setWorkpiece(content.workpiece, {});
    scene.setWorkpieceOpacity(content.opacity);
    scene.setExcess(content.left);
    scene.setObstacles(marksOf(content.obstacles));
    scene.setZero(content.zero);
    scene.setTool(content.tool);
    ToolMarks marks;
    marks.proxy = content.pose;
    scene.setMarks(marks, false);
    if (!content.paths.empty()) {
        scene.editedPath().setPath(*content.paths.front());
        scene.setPathValues(content.values);
        scene.otherPaths().setPaths({content.paths.begin() + 1, content.paths.end()});
    }
}

void cutOpen(Scene& scene, const PictureSection& section, const CameraView& view) {
    scene.setSection(SectionPlane{section.axis, section.position, keepsLowBefore(-axesOf(view).back, section.axis)});
    scene.section().setHandle(false);
}

std::string png(vtkRenderWindow& window) {
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(&window);
    image->SetInputBufferTypeToRGB();
    image->ReadFrontBufferOff();
    image->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    const vtkUnsignedCharArray* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

} // namespace

class PictureDrawing::Stage {
public:
    Stage(OffscreenContext context, const PictureContent& content, const Palette& palette)
        : context_(std::move(context)), content_(content), size_(content.width, content.height) {
        const QuietVtk quiet;
        makeReady(*window_, content);
        scene_.emplace(
            *window_, [] {}, [](const GuideMarks&, double, const GuideActors::Shaped&) {}, // no guides are drawn
            [](const std::shared_ptr<const Obstacle>& obstacle, const ObstacleActors::Made& then) {
                then(std::make_shared<const ObstacleSurface>(surfaceOf(*obstacle)));
            });
        scene_->setPalette(palette);
        fill(*scene_, content);
        if (content.section) cutOpen(*scene_, *content.section, from(content.view));
        context_.release();
    }
    ~Stage() {
        const Current current(context_);
        scene_.reset();
        window_->Finalize();
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    bool ready() {
        const Current current(context_);
        static_cast<void>(scene_->prepare(from(content_.view), size_, 1.0, false));
        return scene_->workpiece().fullDetail();
    }
    std::string draw(StandardView view) {
        const Current current(context_);
        static_cast<void>(scene_->prepare(from(view), size_, 1.0, false));
        window_->Render();
        return png(*window_);
    }

private:
    /// Makes the context current and suppresses VTK's log.
    class Current {
    public:
        explicit Current(OffscreenContext& context) : context_(context) { context.makeCurrent(); }
        ~Current() { context_.release(); }
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

    private:
        OffscreenContext& context_;
        QuietVtk quiet_;
    };

    CameraView from(StandardView view) const { return viewOf(content_, view, scene_->contentBox()); }

    OffscreenContext context_;
    PictureContent content_;
    QSizeF size_;
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    std::optional<Scene> scene_;
};

PictureDrawing::PictureDrawing(std::unique_ptr<Stage> stage) : stage_(std::move(stage)) {}
PictureDrawing::~PictureDrawing() = default;
PictureDrawing::PictureDrawing(PictureDrawing&&) noexcept = default;
PictureDrawing& PictureDrawing::operator=(PictureDrawing&&) noexcept = default;

Result<PictureDrawing> PictureDrawing::begin(const PictureContent& content) {
    const Result<Palette> palette = loadPalette(content.theme);
    if (!palette) return palette.error();
    Result<OffscreenContext> context = OffscreenContext::make(content.width, content.height);
    if (!context) return context.error();
    return PictureDrawing(std::make_unique<Stage>(std::move(*context), content, *palette));
}

bool PictureDrawing::ready() {
    return stage_->ready();
}

void PictureDrawing::wait() {
    while (!ready()) std::this_thread::sleep_for(5ms);
}

std::string PictureDrawing::draw(StandardView view) {
    return stage_->draw(view);
}

Result<std::string> drawPicture(const PictureContent& content) {
    Result<PictureDrawing> drawing = PictureDrawing::begin(content);
    if (!drawing) return drawing.error();
    drawing->wait();
    return drawing->draw(content.view);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/picture.h"

#include "ui/scene/bench_lights.h"
#include "ui/scene/offscreen_context.h"
#include "ui/scene/tool_surface.h"
#include "ui/scene/workpiece_surface.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>

namespace burin {

namespace {

using Colour = std::array<double, 3>; // 0 … 1

constexpr Colour fluteColour{0.86, 0.88, 0.91}, shankColour{0.54, 0.60, 0.67}, holderColour{0.33, 0.37, 0.43};
constexpr Colour pathColour{0.95, 0.63, 0.22};
constexpr Colour backgroundTop{0.18, 0.22, 0.28}, backgroundBottom{0.09, 0.11, 0.14};

vtkSmartPointer<vtkActor> actorFor(vtkPolyData* data, const Colour& colour) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->GetProperty()->SetSpecular(0.25);
    actor->GetProperty()->SetSpecularPower(30.0);
    return actor;
}

vtkSmartPointer<vtkActor> workpieceActor(const VolumeSnapshot& workpiece) {
    vtkSmartPointer<vtkActor> actor = actorFor(workpieceSurface(workpiece), {1.0, 1.0, 1.0});
    actor->GetMapper()->ScalarVisibilityOn();
    actor->GetMapper()->SetColorModeToDirectScalars();
    shadeSimply(*actor);
    return actor;
}

void addTool(vtkRenderer& renderer, const Tool& tool, const glm::dvec3& tip) {
    const std::vector<RevolvedPiece> stack = pieces(tool.cutter);
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const ToolSection section = sectionOf(tool.cutter, i);
        const Colour colour = section == ToolSection::flutes  ? fluteColour
                              : section == ToolSection::shank ? shankColour
                                                              : holderColour;
        vtkSmartPointer<vtkActor> actor = actorFor(pieceSurface(stack[i]), colour);
        actor->SetPosition(tip.x, tip.y, tip.z);
        renderer.AddActor(actor);
    }
}

/// The stretches of a path that cut, as lines.
vtkSmartPointer<vtkPolyData> cuttingLines(const Path& path) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const glm::dvec3& tip = path.points[i].tip;
        const vtkIdType place = points->InsertNextPoint(tip.x, tip.y, tip.z);
        if (i == 0 || path.points[i].kind != MoveKind::cut) continue;
        lines->InsertNextCell(2);
        lines->InsertCellPoint(place - 1);
        lines->InsertCellPoint(place);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

/// VTK 9.1 logs two lines about GLEW for every context that has no X server behind it; they mean nothing.
class QuietVtk {
public:
    QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    int before_;
};

void aimCamera(vtkRenderer& renderer, const Box& bench) {
    const glm::dvec3 centre = bench.centre();
    vtkCamera* camera = renderer.GetActiveCamera();
    camera->SetFocalPoint(centre.x, centre.y, centre.z);
    camera->SetPosition(centre.x + 0.9, centre.y - 1.6, centre.z + 1.25);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(28.0);
    const std::array<double, 6> bounds{bench.low.x, bench.high.x, bench.low.y, bench.high.y, bench.low.z, bench.high.z};
    renderer.ResetCamera(bounds.data());
    camera->Zoom(1.04);
    renderer.ResetCameraClippingRange();
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

Result<std::string> drawPicture(const PictureContent& content) {
    Result<OffscreenContext> context = OffscreenContext::make(content.width, content.height);
    if (!context) return std::move(context).error();

    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(backgroundBottom.data());
    renderer->SetBackground2(backgroundTop.data());
    renderer->GradientBackgroundOn();
    addBenchLights(*renderer);
    renderer->AddActor(workpieceActor(content.workpiece));
    if (!content.path.points.empty()) {
        vtkSmartPointer<vtkActor> path = actorFor(cuttingLines(content.path), pathColour);
        path->GetProperty()->LightingOff();
        path->GetProperty()->SetOpacity(0.22);
        renderer->AddActor(path);
    }
    if (content.tool) addTool(*renderer, *content.tool, content.tip);

    vtkNew<vtkGenericOpenGLRenderWindow> window;
    window->SetMapped(true);
    window->SetIsCurrent(true);
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->SetSize(content.width, content.height);
    const QuietVtk quiet;
    window->OpenGLInitContext();
    window->SetMultiSamples(8);
    window->AddRenderer(renderer);
    Box bench = content.workpiece.grid().box();
    if (content.tool) { // as much of the tool as does not dwarf a small workpiece
        const double shown = std::min(0.75 * content.tool->cutter.stickOut, glm::length(bench.size()) / 3.0);
        bench.include(content.tip + glm::dvec3(0.0, 0.0, shown));
    }
    aimCamera(*renderer, bench);
    window->Render();
    std::string picture = png(*window);
    window->Finalize();
    return picture;
}

} // namespace burin

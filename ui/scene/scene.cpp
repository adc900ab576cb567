// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene.h"

#include "core/base/units.h"
#include "ui/scene/bench_lights.h"

#include <vtkCamera.h>

#include <array>

namespace burin {

Scene::Scene(vtkRenderWindow& window) : part_(*bench_), tool_(*bench_), grid_(*bench_), stock_(*bench_) {
    bench_->GradientBackgroundOn();
    addBenchLights(*bench_);
    window.AddRenderer(bench_);
}

void Scene::setPalette(const Palette& palette) {
    const auto colour = [](const QColor& c) { return std::array<double, 3>{c.redF(), c.greenF(), c.blueF()}; };
    bench_->SetBackground(colour(palette.sceneBottom).data());
    bench_->SetBackground2(colour(palette.sceneTop).data());
    part_.setColours(palette.part, palette.sceneBottom);
    tool_.setPalette(palette);
    grid_.setColour(palette.grid);
    stock_.setColour(palette.quietText);
}

void Scene::setPart(const std::vector<ShadedBody>& bodies, const Box& box) {
    part_.setBodies(bodies);
    partBox_ = box;
    refresh();
}

void Scene::setPartVisible(bool visible) {
    part_.setVisible(visible);
}

void Scene::setStock(const std::optional<Box>& stock) {
    stock_.setBox(stock);
    refresh();
}

Box Scene::contentBox() const {
    Box content = partBox_;
    if (stock_.box()) content.include(*stock_.box());
    return content;
}

void Scene::refresh() {
    grid_.setContent(contentBox());
}

void Scene::aimCamera(const CameraView& view) {
    stock_.drawLast();
    const CameraAxes axes = axesOf(view);
    vtkCamera* camera = bench_->GetActiveCamera();
    camera->SetPosition(axes.eye.x, axes.eye.y, axes.eye.z);
    camera->SetFocalPoint(view.focus.x, view.focus.y, view.focus.z);
    camera->SetViewUp(axes.up.x, axes.up.y, axes.up.z);
    camera->SetViewAngle(cameraViewAngle * 180.0 / pi);
    bench_->ResetCameraClippingRange();
}

std::size_t Scene::triangles() const {
    return part_.triangles() + tool_.triangles();
}

} // namespace burin

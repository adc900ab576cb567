// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/preview_stage.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/view_lights.h"

namespace burin {

namespace {

constexpr double previewCrease = 50.0 * pi / 180.0; // coarse triangles of a face differ more in normal than fine ones

} // namespace

std::vector<ShadedBody> shadedBodies(const ModelPreview& preview) {
    std::vector<ShadedBody> bodies;
    bodies.reserve(preview.bodies.size());
    for (const PreviewBody& body : preview.bodies) {
        TriangleMesh mesh;
        mesh.vertices.assign(body.mesh.vertices.begin(), body.mesh.vertices.end());
        mesh.triangles = body.mesh.triangles;
        bodies.push_back(shadedBody(mesh, body.colour, body.faceColours, previewCrease));
    }
    return bodies;
}

Box boundsOf(const ModelPreview& preview, double margin) {
    Box box;
    for (const PreviewBody& body : preview.bodies)
        for (const glm::vec3& vertex : body.mesh.vertices) box.include(glm::dvec3(vertex));
    if (box.empty()) return box;
    return {box.low - margin, box.high + margin};
}

PreviewStage::PreviewStage(vtkRenderWindow& window)
    : part_(*renderer_, *renderer_), grid_(*renderer_), shadow_(*renderer_), scaleBar_(*renderer_) {
    renderer_->DrawOff();
    addViewLights(*renderer_);
    window.AddRenderer(renderer_);
}

void PreviewStage::setPalette(const Palette& palette) {
    setBackdrop(*renderer_, palette.sceneTop, palette.sceneBottom);
    part_.setColours(palette.part, palette.pathHalo);
    grid_.setColour(palette.grid);
    shadow_.setPalette(palette);
    scaleBar_.setPalette(palette);
}

void PreviewStage::setLineWidths(double ratio) {
    part_.setLineWidth(thinLine * ratio);
    grid_.setLineWidth(thinLine * ratio);
}

void PreviewStage::set(std::vector<ShadedBody> bodies, const Box& content) {
    part_.setBodies(std::move(bodies));
    content_ = content;
    grid_.setContent(content);
    shadow_.setContent(content);
    renderer_->DrawOn();
}

void PreviewStage::clear() {
    part_.setBodies({});
    renderer_->DrawOff();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/view_lights.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>
#include <string>

namespace burin {

namespace {

struct ViewLight {
    glm::dvec3 from; ///< in the camera's frame
    double intensity;
};

constexpr ViewLight keyLight{{-0.4, 0.55, 0.58}, 0.72}, fillLight{{0.8, -0.3, 0.6}, 0.26};
/// Ambient light, and how much more of it comes from above than from the side.
constexpr double skyLight = 0.36, skySlope = 0.12;
/// The fraction of light lost at the far end of a depth cue.
constexpr double depthLoss = 0.30;
/// The weight of a surface's curvature, 1 / pixel, and the maximum light that it removes or adds.
constexpr double bendGain = 0.9, hollowLoss = 0.30, ridgeGain = 0.14;

std::string number(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << value;
    return text.str();
}

std::string lightOf(const ViewLight& light) {
    const glm::dvec3 towards = glm::normalize(light.from);
    return number(light.intensity) + " * max(0.0, dot(normalVCVSOutput, vec3(" + number(towards.x) + ", " +
           number(towards.y) + ", " + number(towards.z) + ")))";
}

/// The shading as code for VTK's surface shader.
std::string simpleShading() {
    return "  float lit = " + number(skyLight) + " + " + number(skySlope) + " * normalVCVSOutput.y + " +
           lightOf(keyLight) + " + " + lightOf(fillLight) + ";\n  float bend = " + number(bendGain) +
           " * (dFdx(normalVCVSOutput.x) + dFdy(normalVCVSOutput.y));\n  lit *= 1.0 + clamp(bend, " +
           number(-hollowLoss) + ", " + number(ridgeGain) +
           ");\n  lit *= 1.0 - clamp((-vertexVC.z - cueNearest) * cueLoss, 0.0, " + number(depthLoss) +
           ");\n  gl_FragData[0] = vec4(ambientColor + lit * diffuseColor, opacity);\n";
}

void addLight(vtkRenderer& renderer, const ViewLight& of) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(of.from.x, of.from.y, of.from.z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(of.intensity);
    renderer.AddLight(light);
}

} // namespace

void addViewLights(vtkRenderer& renderer) {
    renderer.AutomaticLightCreationOff();
    for (const ViewLight& light : {keyLight, fillLight}) addLight(renderer, light);
    addLight(renderer, {{0.0, 0.3, 1.0}, skyLight}); // VTK has no sky
}

void setBackdrop(vtkRenderer& renderer, const QColor& top, const QColor& bottom) {
    renderer.GradientBackgroundOn();
    renderer.SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
    renderer.SetBackground2(top.redF(), top.greenF(), top.blueF());
}

void shadeSimply(vtkActor& actor) {
    static const std::string shading = simpleShading();
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, shading, false);
    // Nothing is transparent, so the depth test can be done before a pixel is shaded.
    actor.GetShaderProperty()->AddFragmentShaderReplacement("if (gl_FragData[0].a <= 0.0)", true, "if (false)", false);
    setDepthCue(actor, {});
}

DepthCue depthCueOf(const Box& box, const glm::dvec3& eye, const glm::dvec3& along) {
    if (box.empty()) return {};
    DepthCue cue{glm::dot(box.corner(0) - eye, along), glm::dot(box.corner(0) - eye, along)};
    for (unsigned i = 1; i < 8; ++i) {
        const double distance = glm::dot(box.corner(i) - eye, along);
        cue.nearest = std::min(cue.nearest, distance);
        cue.farthest = std::max(cue.farthest, distance);
    }
    return cue;
}

void setDepthCue(vtkActor& actor, const DepthCue& cue) {
    const double depth = cue.farthest - cue.nearest;
    vtkUniforms& uniforms = *actor.GetShaderProperty()->GetFragmentCustomUniforms();
    uniforms.SetUniformf("cueNearest", static_cast<float>(cue.nearest));
    uniforms.SetUniformf("cueLoss", static_cast<float>(depth > 0.0 ? depthLoss / depth : 0.0));
}

} // namespace burin

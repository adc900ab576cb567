// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bench_lights.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkShaderProperty.h>

#include <glm/glm.hpp>

#include <array>
#include <locale>
#include <sstream>
#include <string>

namespace burin {

namespace {

struct BenchLight {
    glm::dvec3 from; ///< in the camera's frame
    double intensity;
};

constexpr std::array<BenchLight, 3> benchLights{
    {{{-0.7, 0.7, 1.0}, 0.45}, {{1.2, 0.2, 0.8}, 0.28}, {{0.0, 0.0, 1.0}, 0.58}}};

std::string vector(const glm::dvec3& v) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << "vec3(" << v.x << ", " << v.y << ", " << v.z << ")";
    return text.str();
}

/// In the words of VTK's shader for surfaces. A highlight between light and eye to the power of 128 is as wide as one
/// of a mirrored ray to the power of 32.
std::string simpleShading() {
    std::string text = "  vec3 diffuse = vec3(0.0), specular = vec3(0.0);\n  float lit, shine;\n";
    for (const BenchLight& light : benchLights) {
        const glm::dvec3 towards = glm::normalize(light.from), between = glm::normalize(towards + glm::dvec3(0, 0, 1));
        const std::string intensity = vector(glm::dvec3(light.intensity));
        text += "  lit = max(0.0, dot(normalVCVSOutput, " + vector(towards) + "));\n";
        text += "  diffuse += lit * " + intensity + ";\n";
        text += "  shine = max(0.0, dot(normalVCVSOutput, " + vector(between) + "));\n";
        for (int square = 0; square < 7; ++square) text += "  shine *= shine;\n";
        text += "  specular += shine * " + intensity + ";\n";
    }
    return text +
           "  gl_FragData[0] = vec4(ambientColor + diffuse * diffuseColor + specular * specularColor, opacity);\n";
}

} // namespace

void addBenchLights(vtkRenderer& renderer) {
    renderer.AutomaticLightCreationOff();
    for (const auto& [from, intensity] : benchLights) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(from.x, from.y, from.z);
        light->SetFocalPoint(0.0, 0.0, 0.0);
        light->SetIntensity(intensity);
        renderer.AddLight(light);
    }
}

void shadeSimply(vtkActor& actor) {
    static const std::string shading = simpleShading();
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, shading, false);
    // Nothing is transparent: depth may be decided before a pixel is shaded.
    actor.GetShaderProperty()->AddFragmentShaderReplacement("if (gl_FragData[0].a <= 0.0)", true, "if (false)", false);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/bench_lights.h"

#include <vtkLight.h>
#include <vtkNew.h>

#include <array>

namespace burin {

void addBenchLights(vtkRenderer& renderer) {
    renderer.AutomaticLightCreationOff();
    constexpr std::array<std::array<double, 4>, 3> lights{
        {{-0.7, 0.7, 1.0, 0.45}, {1.2, 0.2, 0.8, 0.28}, {0.0, 0.0, 1.0, 0.58}}}; // camera frame, and intensity
    for (const auto& [x, y, z, intensity] : lights) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(x, y, z);
        light->SetFocalPoint(0.0, 0.0, 0.0);
        light->SetIntensity(intensity);
        renderer.AddLight(light);
    }
}

} // namespace burin

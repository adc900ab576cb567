// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/offscreen_context.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace burin::testing {

/// A square VTK window without a display. Its background is magenta, a colour that nothing in the scene has.
class OffscreenStage {
public:
    /// @param pixels  of each side
    explicit OffscreenStage(int pixels) : context(OffscreenContext::make(pixels, pixels)) {
        renderer->SetBackground(1.0, 0.0, 1.0);
        window->SetMapped(true);
        window->SetIsCurrent(true);
        window->SetReadyForRendering(true);
        window->SetOwnContext(0);
        window->SetSize(pixels, pixels);
        window->OpenGLInitContext();
        window->SetMultiSamples(0);
        window->AddRenderer(renderer);
    }
    ~OffscreenStage() { window->Finalize(); }
    OffscreenStage(const OffscreenStage&) = delete;
    OffscreenStage& operator=(const OffscreenStage&) = delete;

    Result<OffscreenContext> context;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
};

} // namespace burin::testing

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSurfaceFormat>

namespace burin {

/// OpenGL as VTK wants it in a viewport: core profile 3.2, depth and stencil. To be called before the application is
/// made, as every context takes its format from there.
inline void useSceneSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
}

} // namespace burin

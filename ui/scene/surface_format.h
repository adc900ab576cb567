// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSurfaceFormat>

namespace burin {

/// The OpenGL format that VTK needs in a viewport: core profile 3.2, depth and stencil. Not forward-compatible (which
/// Qt requests unless deprecated functions are requested): in a forward-compatible context, lines wider than one pixel
/// are an error and are drawn one pixel wide.
inline QSurfaceFormat sceneSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::DeprecatedFunctions);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    return format;
}

} // namespace burin

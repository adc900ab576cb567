// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/path.h"
#include "core/tool/tool.h"
#include "core/volume/run_volume.h"

#include <optional>
#include <string>

namespace burin {

/// What a picture of the bench shows, setup frame, mm.
struct PictureContent {
    VolumeSnapshot workpiece;
    std::optional<Tool> tool; ///< standing at `tip`
    glm::dvec3 tip{0.0};
    Path path;                       ///< drawn where it cuts; empty: none
    int width = 1600, height = 1000; ///< pixels
};

/// Draws the workpiece in its materials' colours, the tool and the path, from the front right and above, with VTK.
/// Needs no display: an EGL context without a surface (Mesa) is made for it.
/// @return PNG. Errors: notSupported (no EGL with OpenGL 3.2), outOfMemory.
Result<std::string> drawPicture(const PictureContent& content);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/result.h"

#include <string>

namespace burin {

struct PictureContent;

/// The options for drawing a picture, as given by the user.
struct PictureOptions {
    std::string view = "isometric", section;
    double transparency = 0.0; ///< %
};

/// Declares --view, --section and --transparency.
void addPictureOptions(CommandParser command, PictureOptions& options);
/// Checks --section before work that takes time. Errors: argumentInvalid.
Result<void> checkPictureOptions(const PictureOptions& options);
/// The bytes of a PNG file with a picture of `content`. Errors: argumentInvalid (a section that misses the workpiece),
/// those of drawPicture.
Result<std::string> pictureOf(PictureContent content, const PictureOptions& options);
/// Writes the picture to a file. Errors: also those of writeFileAtomically.
Result<void> writePicture(PictureContent content, const PictureOptions& options, const std::string& file);

} // namespace burin

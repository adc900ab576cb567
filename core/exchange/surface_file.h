// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/volume_surface.h"

#include <filesystem>

namespace burin {

/// Whether a file has the suffix of a supported surface format: .stl, .ply, .3mf.
bool isSurfaceFile(const std::filesystem::path& file);

/// Writes a surface in the format of the suffix: STL and PLY binary, mm; 3MF with a body for each material, in its
/// colour. Written to a temporary file, then renamed. Errors: notSupported (another suffix), fileNotWritable, diskFull,
/// outOfMemory.
Result<void> writeSurfaceFile(const std::filesystem::path& file, const VolumeSurface& surface,
                              const PropertyList& materials);

} // namespace burin

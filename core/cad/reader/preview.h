// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model_preview.h"
#include "core/cad/reader/solids.h"

#include <optional>
#include <span>

namespace burin {

/// Meshes solids coarsely, for a picture while the mesh with a chord of `chord` mm is made. The solids are as before
/// afterwards. Nothing where that mesh is quickly made by itself (solids of plane faces alone, or so small that a
/// coarse mesh would hardly be coarser), where OpenCASCADE fails, and where it took more than `previewSeconds` of
/// processor time. Measured: 0.1 to 5 % of an import. Thread: the one that meshes.
std::optional<ModelPreview> previewOf(std::span<const NamedSolid> solids, double chord);

inline constexpr double previewSeconds = 2.0;

} // namespace burin

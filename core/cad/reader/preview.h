// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model_preview.h"
#include "core/cad/reader/solids.h"

#include <optional>
#include <span>

namespace burin {

/// Meshes solids coarsely, for display while the mesh with a chord of `chord` mm is being made. The solids are restored
/// afterwards. Empty if that mesh is fast to make (solids with only plane faces, or so small that a coarse mesh would
/// hardly be coarser), if OpenCASCADE fails, or if it took more than `previewSeconds` of processor time. Measured: 0.1
/// to 5 % of an import. Call on the meshing thread.
std::optional<ModelPreview> previewOf(std::span<const NamedSolid> solids, double chord);

inline constexpr double previewSeconds = 2.0;

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/cad_file.h"
#include "core/cad/reader/file_format.h"

namespace burin {

/// Heals, meshes and measures the solids of a B-rep file, and sends a preview if the request asks for one. Clears the
/// source's content first. Errors, with an empty subject: that of `file`; meshIncomplete, modelHasNoSolid.
Result<Model> modelOf(Result<CadFile> file, ModelSource& source);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"

#include <optional>

namespace burin {

/// The note on a model's unit if that needs one: not mm, not stated by the file, or not the one that it states.
/// @param stated whether the file states it
std::optional<ImportNote> unitNote(const Model& model, bool stated);

} // namespace burin

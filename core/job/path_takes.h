// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

namespace burin {

/// A path with a take as its last source: a copy joins no path by itself. Nothing is stored yet.
/// Errors: nameUnknown (the take), argumentInvalid (it was made with another tool, or the path has it already).
Result<StoredPath> withTake(const Project& project, StoredPath path, std::int64_t take);
/// A path without one of its takes. Errors: argumentInvalid (it is none of them, or the only source).
Result<StoredPath> withoutTake(StoredPath path, std::int64_t take);

} // namespace burin

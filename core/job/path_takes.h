// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

namespace burin {

/// Returns a path with a take as an additional last source, as copies are not added to paths automatically. Stores
/// nothing. Errors: nameUnknown (the take), argumentInvalid (recorded with another tool, or already in the path).
Result<StoredPath> withTake(const Project& project, StoredPath path, std::int64_t take);
/// Returns a path without one of its takes. Errors: argumentInvalid (not in the path, its only source, or its newest
/// take that is no copy: evaluation would add it again).
Result<StoredPath> withoutTake(const Project& project, StoredPath path, std::int64_t take);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pass_arguments.h"
#include "core/document/project_change.h"

#include <optional>

namespace burin {

/// Computes a pass, makes it the last source of a path or the first of a new one, saves and answers.
/// Where the arguments name a pass of the path, in its place.
/// @param path without sources: a new one @param machine by id; empty: the project's @return exit status
int addPassTo(ProjectChange& project, StoredPath path, const PassArguments& arguments, const std::string& machine,
              CommandContext& context);

/// Computes a path's passes anew, as each was asked for, in the place where it is, saves and answers.
/// @param pass id; nothing: all of the path @return exit status
int recompute(ProjectChange& project, StoredPath path, std::optional<std::int64_t> pass, const std::string& machine,
              CommandContext& context);

/// Takes a path out of a project, or one pass out of a path, saves and answers; passes that no path is made of any more
/// go with it. @param pass id; nothing: all of the path @return exit status
int removeFrom(ProjectChange& project, StoredPath path, std::optional<std::int64_t> pass, CommandContext& context);

} // namespace burin

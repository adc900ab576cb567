// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"
#include "core/job/pass_figures.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

// What the commands of "burin path" report of a path.

/// Errors: nameUnknown (detail: those that there are).
Result<StoredPath> pathWithId(const Project& project, std::int64_t id);
/// What a path is made of besides takes, in its order. Errors: those of Project::generated.
Result<std::vector<GeneratedInfo>> passesOf(const Project& project, const StoredPath& path);
/// {"id", "name", "takes", "passes": [{"id", "name", "tool", "points", "request"}], "edits"}
nlohmann::json jsonOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes);
/// The same for people, several lines.
std::string textOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes);
/// Adds to each pass of `jsonOf` what it does to the stock, with units in the keys.
void addFigures(const std::vector<PassFigures>& figures, nlohmann::json& passes);
/// The same for people, a line each.
std::string textOf(const std::vector<PassFigures>& figures);

/// Saves a change and answers with the path as it is now. @param further keys of the answer besides those of the path
/// @return exit status
int saveAndAnswer(ProjectChange& project, const StoredPath& path, CommandContext& context,
                  nlohmann::json further = nlohmann::json::object(), const std::string& furtherText = {});

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"
#include "core/job/pass_figures.h"
#include "core/path/path.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

// Reports on a path by the commands of "burin path".

/// Errors: nameUnknown (detail: existing ones).
Result<StoredPath> pathWithId(const Project& project, std::int64_t id);
/// The sources of a path other than takes, in its order. Errors: those of Project::generated.
Result<std::vector<GeneratedInfo>> passesOf(const Project& project, const StoredPath& path);
/// {"id", "name", "takes", "passes": [{"id", "name", "tool", "points", "request"}], "edits"}
nlohmann::json jsonOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes);
/// The same as readable text, several lines.
std::string textOf(const StoredPath& path, const std::vector<GeneratedInfo>& passes);
/// Adds the effect on the stock to each pass of `jsonOf`, with units in the keys.
void addFigures(const std::vector<PassFigures>& figures, nlohmann::json& passes);
/// The same as readable text, one line each.
std::string textOf(const std::vector<PassFigures>& figures);
/// Adds to each pass of `jsonOf` whether it is out of date: strokes that lead it have changed since it was computed.
void addOutdated(const std::vector<std::int64_t>& outdated, nlohmann::json& passes);
/// The same as readable text, one line for each that is.
std::string textOfOutdated(const std::vector<std::int64_t>& outdated);
/// The points as CSV, one line each, with units in the heading.
std::string csvOf(const Path& path);

/// Saves a change and answers with the resulting path. @param further keys of the answer besides those of the path
/// @return exit status
int saveAndAnswer(ProjectChange& project, const StoredPath& path, CommandContext& context,
                  nlohmann::json further = nlohmann::json::object(), const std::string& furtherText = {});
/// The same answer without saving, where nothing has changed.
int answerUnchanged(const Project& project, const StoredPath& path, CommandContext& context, nlohmann::json further,
                    const std::string& furtherText);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/path_takes.h"

#include "core/job/job_paths.h"

#include <algorithm>
#include <string>

namespace burin {

namespace {

bool contains(const StoredPath& path, std::int64_t take) {
    return std::ranges::find(path.sources, PathSource{take}) != path.sources.end();
}

} // namespace

Result<StoredPath> withTake(const Project& project, StoredPath path, std::int64_t take) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const std::string tool = toolOf(path, *sources);
    if (contains(path, take) || outline->info.toolId != tool)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(take),
                     "a take made with " + tool + " that path " + std::to_string(path.id) + " does not have"};
    addNewerTakes(path, *sources); // they belong to the path, and a later id in it would hide them
    if (!contains(path, take)) path.sources.push_back({take});
    return path;
}

Result<StoredPath> withoutTake(const Project& project, StoredPath path, std::int64_t take) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    addNewerTakes(path, *sources);
    if (path.sources.size() < 2 || std::erase(path.sources, PathSource{take}) == 0)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(take),
                     "one of several sources of path " + std::to_string(path.id)};
    StoredPath evaluated = path;
    addNewerTakes(evaluated, *sources);
    if (contains(evaluated, take))
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(take),
                     "a take that is not the newest one of the path; the newest one can be switched off"};
    return path;
}

} // namespace burin

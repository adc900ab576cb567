// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/path_takes.h"

#include "core/job/job_paths.h"

#include <algorithm>
#include <string>

namespace burin {

Result<StoredPath> withTake(const Project& project, StoredPath path, std::int64_t take) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    const std::string tool = toolOf(path, *sources);
    const bool there = std::ranges::find(path.sources, PathSource{take}) != path.sources.end();
    if (there || outline->info.toolId != tool)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(take),
                     "a take made with " + tool + " that path " + std::to_string(path.id) + " does not have"};
    path.sources.push_back({take});
    return path;
}

Result<StoredPath> withoutTake(StoredPath path, std::int64_t take) {
    if (path.sources.size() < 2 || std::erase(path.sources, PathSource{take}) == 0)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(take),
                     "one of several sources of path " + std::to_string(path.id)};
    return path;
}

} // namespace burin

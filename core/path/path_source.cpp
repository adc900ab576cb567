// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_source.h"

namespace burin {

std::string nameOf(PathSource source) {
    return source.isTake() ? "take " + std::to_string(source.id) : "pass " + std::to_string(-source.id);
}

std::vector<std::int64_t> takesOf(std::span<const PathSource> sources) {
    std::vector<std::int64_t> takes;
    for (const PathSource source : sources)
        if (source.isTake()) takes.push_back(source.id);
    return takes;
}

std::vector<PathSource> sourcesOf(std::span<const std::int64_t> takes) {
    std::vector<PathSource> sources;
    for (const std::int64_t take : takes) sources.push_back({take});
    return sources;
}

SourceInfo sourceOf(const TakeInfo& take) {
    return {{take.id}, take.toolId, take.allowance, take.tickPeriod, take.copyOf != 0};
}

SourceInfo sourceOf(const GeneratedInfo& generated) {
    return {{generated.id}, generated.toolId, generated.allowance, 0.0};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/left_work.h"

#include "core/document/working_copy.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view start = ".", ending = ".working";

/// Returns the user's file that a working copy belongs to; empty if it is not a working copy.
fs::path fileOf(const fs::path& copy) {
    const std::string name = copy.filename().string();
    if (!name.starts_with(start) || !name.ends_with(ending) || name.size() <= start.size() + ending.size()) return {};
    return copy.parent_path() / name.substr(start.size(), name.size() - start.size() - ending.size());
}

fs::file_time_type newestOf(const fs::path& copy) {
    fs::path journal = copy;
    journal += "-wal";
    std::error_code ignored;
    fs::file_time_type changed = fs::last_write_time(copy, ignored);
    std::error_code noJournal;
    const fs::file_time_type later = fs::last_write_time(journal, noJournal);
    return noJournal ? changed : std::max(changed, later);
}

} // namespace

FoundWork leftWork(const fs::path& folder) {
    std::vector<fs::path> copies;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
        if (!fileOf(entry->path()).empty()) copies.push_back(entry->path());
    FoundWork found;
    for (const fs::path& copy : copies) {
        const fs::file_time_type changed = newestOf(copy);
        const Result<std::shared_ptr<WorkingCopy>> locked = WorkingCopy::lock(fileOf(copy));
        if (!locked) {
            found.inUse = found.inUse || locked.error().code == ErrorCode::projectInUse;
            continue;
        }
        const Result<DocumentState> state = (*locked)->state();
        if (state && state->unsaved()) found.left.push_back({(*locked)->file(), changed});
    }
    std::ranges::sort(found.left, [](const LeftWork& a, const LeftWork& b) { return a.changed > b.changed; });
    return found;
}

} // namespace burin

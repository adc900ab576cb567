// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/companions.h"

#include "core/base/file.h"
#include "core/base/staged_file.h"

#include <algorithm>
#include <cerrno>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t companionRoom = 24; // ".", ".working.new-journal" and some margin

Companions companionsNamed(const fs::path& folder, const std::string& name) {
    return {folder / ("." + name + ".working"), folder / ("." + name + ".lock")};
}

/// Returns the same name for the same file, however it was specified, whether or not it exists.
fs::path plainNameOf(const fs::path& file) {
    std::error_code failed;
    const fs::path absolute = fs::absolute(behindLinks(file), failed);
    fs::path plain = fs::weakly_canonical(absolute, failed);
    return failed ? absolute.lexically_normal() : plain;
}

bool isSameFile(const fs::path& a, const fs::path& b) {
    struct stat first {};
    struct stat second {};
    if (::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0)
        return first.st_dev == second.st_dev && first.st_ino == second.st_ino;
    return plainNameOf(a) == plainNameOf(b);
}

/// Returns the files that exist next to `project`, or may exist at any moment.
std::vector<fs::path> companionFiles(const fs::path& project) {
    std::vector<fs::path> files;
    const fs::path plain = plainNameOf(project);
    for (const char* ending : {"-wal", "-shm", "-journal"}) files.push_back(withEnding(plain, ending));
    for (const Companions& names : {Companions::of(plain), Companions::unshortened(plain)}) {
        files.push_back(names.lock);
        for (const char* copy : {"", ".new"})
            for (const char* ending : databaseEndings)
                files.push_back(withEnding(withEnding(names.working, copy), ending));
    }
    return files;
}

} // namespace

fs::path labelledBeside(const fs::path& file, const std::string& label) {
    constexpr std::size_t room = 20; // ".", the label, ".", "-wal" and some margin
    const std::string ending = file.extension().string();
    const std::string stem = nameWithRoom(file.stem().string(), ending.size() + room);
    return file.parent_path() / (stem + "." + label + ending);
}

fs::path withEnding(const fs::path& file, const char* ending) {
    fs::path result = file;
    return result += ending;
}

Companions Companions::of(const fs::path& file) {
    return companionsNamed(file.parent_path(), nameWithRoom(file.filename().string(), companionRoom));
}

Companions Companions::unshortened(const fs::path& file) {
    return companionsNamed(file.parent_path(), file.filename().string());
}

void removeDatabase(const fs::path& file) noexcept {
    for (const char* ending : databaseEndings) ::unlink((file.native() + ending).c_str());
}

Result<void> checkDistinct(const std::string& argument, const fs::path& file, std::span<const fs::path> others) {
    for (const fs::path& other : others) {
        if (other.empty()) continue;
        const std::vector<fs::path> beside = companionFiles(other);
        if (isSameFile(file, other) ||
            std::ranges::any_of(beside, [&](const fs::path& companion) { return isSameFile(file, companion); }))
            return Error{ErrorCode::argumentInvalid, argument, file.string(),
                         "a file other than \"" + other.string() + "\" and those that Burin keeps beside it"};
    }
    return {};
}

Result<void> checkOutput(const std::string& argument, const fs::path& output, std::span<const fs::path> inputs) {
    struct stat standing {};
    if (::stat(output.c_str(), &standing) == 0 && S_ISDIR(standing.st_mode)) return writeError(output, EISDIR);
    if (const int refused = refusalToWrite(behindLinks(output)); refused != 0) return writeError(output, refused);
    return checkDistinct(argument, output, inputs);
}

} // namespace burin

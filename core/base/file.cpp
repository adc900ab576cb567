// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"

#include "core/base/available_memory.h"
#include "core/base/staged_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <unistd.h>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// Bytes to read at first: one more than the file has, so that its end is found at once. Pipes and devices have no
/// size.
std::size_t firstRoom(const fs::path& file) {
    constexpr std::uintmax_t least = 65536;
    std::error_code untold;
    const std::uintmax_t size = fs::file_size(file, untold);
    return static_cast<std::size_t>(untold ? least : std::max(size + 1, least));
}

fs::path firstExisting(const fs::path& first, const fs::path& second) {
    std::error_code ignored;
    return fs::exists(first, ignored) ? first : second;
}

std::string reasonOf(int systemError) {
    if (systemError == EISDIR) return "is a folder";
    return systemError == 0 ? "the system states no reason" : std::strerror(systemError); // 0: not reported
}

} // namespace

Result<std::ifstream> openFileStream(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) return readError(file, EISDIR);
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return readError(file, errno);
    return stream;
}

Result<std::string> readFile(const fs::path& file) try {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    std::string content;
    std::size_t read = 0;
    for (std::size_t room = firstRoom(file); read == content.size(); room = 2 * content.size()) {
        if (Result<void> fits = needMemory(file.c_str(), static_cast<double>(room)); !fits)
            return std::move(fits).error();
        content.resize(room);
        stream->read(content.data() + read, static_cast<std::streamsize>(room - read));
        read += static_cast<std::size_t>(stream->gcount());
    }
    if (stream->bad()) return readError(file, errno);
    content.resize(read);
    return content;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, file.string(), {}, {}};
}

Error readError(const fs::path& file, int systemError) {
    if (systemError == ENOENT || systemError == ENOTDIR) return {ErrorCode::fileNotFound, file.string(), {}, {}};
    return {ErrorCode::fileNotReadable, file.string(), {}, reasonOf(systemError)};
}

Error writeError(const fs::path& file, int systemError) {
    const bool full = systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG;
    return {full ? ErrorCode::diskFull : ErrorCode::fileNotWritable, file.string(), {}, reasonOf(systemError)};
}

Result<void> replaceFile(const fs::path& written, const fs::path& file) {
    Result<StagedFile> staged = StagedFile::adopt(written, file);
    return staged ? staged->putInPlace() : std::move(staged).error();
}

Result<void> writeFileAtomically(const fs::path& file, std::string_view content) {
    Result<StagedFile> staged = StagedFile::containing(file, content);
    return staged ? staged->putInPlace() : std::move(staged).error();
}

fs::path executableDirectory() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    return failed ? fs::current_path() : program.parent_path();
}

fs::path resourceDirectory() {
    const fs::path here = executableDirectory();
    return firstExisting(here / "../share/burin/resources", firstExisting(here / "resources", here / "../resources"));
}

fs::path pluginDirectory() {
    const fs::path here = executableDirectory();
    return firstExisting(here / "../lib/burin/plugins", firstExisting(here / "plugins", here / "../plugins"));
}

fs::path translationDirectory() {
    const fs::path here = executableDirectory();
    return firstExisting(here / "../share/burin/translations",
                         firstExisting(here / "translations", here / "../translations"));
}

} // namespace burin

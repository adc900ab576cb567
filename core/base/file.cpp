// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"

#include "core/base/available_memory.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// Closes a descriptor when it leaves its scope.
class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const noexcept { return number_; }

private:
    int number_;
};

bool writeAll(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// 0, or the `errno` value of what went wrong.
int flushFile(const fs::path& file) {
    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    return descriptor.number() < 0 || ::fsync(descriptor.number()) != 0 ? errno : 0;
}

/// The same for the names in a folder.
int flushFolder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_CLOEXEC));
    // One may write in a folder that one may not read, and some file systems can't flush any (EINVAL): what was renamed
    // there is then as durable as they make it.
    if (descriptor.number() < 0) return 0;
    return ::fsync(descriptor.number()) != 0 && errno != EINVAL ? errno : 0;
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Bytes to read at first: one more than there are, so that the end is found at once. A pipe or a device does not tell.
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
    const bool folder = systemError == EISDIR;
    return {ErrorCode::fileNotReadable, file.string(), {}, folder ? "is a folder" : std::strerror(systemError)};
}

Error writeError(const fs::path& file, int systemError) {
    const bool full = systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG;
    return {full ? ErrorCode::diskFull : ErrorCode::fileNotWritable, file.string(), {}, std::strerror(systemError)};
}

fs::path temporaryBeside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    const std::string name = "." + file.filename().string() + "." + std::to_string(::getpid()) + "-" +
                             std::to_string(counter.fetch_add(1)) + ".part";
    return folderOf(file) / name;
}

Result<void> replaceFile(const fs::path& written, const fs::path& file) {
    int reason = flushFile(written);
    if (reason == 0 && ::rename(written.c_str(), file.c_str()) != 0) reason = errno;
    if (reason != 0) {
        std::error_code ignored;
        fs::remove(written, ignored);
        return writeError(file, reason);
    }
    reason = flushFolder(folderOf(file));
    if (reason != 0) return writeError(file, reason);
    return {};
}

Result<void> writeFileAtomically(const fs::path& file, std::string_view content) {
    const fs::path beside = temporaryBeside(file);
    bool complete = false;
    int reason = 0;
    {
        const Descriptor descriptor(::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        complete = descriptor.number() >= 0 && writeAll(descriptor.number(), content);
        reason = errno;
    }
    if (complete) return replaceFile(beside, file);
    std::error_code ignored;
    fs::remove(beside, ignored);
    return writeError(file, reason);
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

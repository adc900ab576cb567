// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
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
    ~Descriptor() { if (number_ >= 0) ::close(number_); }
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

Result<void> flushToDisk(const fs::path& path) {
    const Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    // Some file systems can't flush a folder (EINVAL); the rename is then as durable as they make it.
    if (descriptor.number() < 0 || (::fsync(descriptor.number()) != 0 && errno != EINVAL)) return writeError(path, errno);
    return {};
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

fs::path firstExisting(const fs::path& first, const fs::path& second) {
    std::error_code ignored;
    return fs::exists(first, ignored) ? first : second;
}

} // namespace

Result<std::string> readFile(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return Error{ErrorCode::fileNotFound, file.string(), {}, {}};
    if (fs::is_directory(file, ignored)) return Error{ErrorCode::fileNotReadable, file.string(), {}, "is a folder"};
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return Error{ErrorCode::fileNotReadable, file.string(), {}, std::strerror(errno)};
    std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (stream.bad()) return Error{ErrorCode::fileNotReadable, file.string(), {}, std::strerror(errno)};
    return content;
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
    std::error_code ignored;
    if (Result<void> flushed = flushToDisk(written); !flushed) {
        fs::remove(written, ignored);
        return Error{flushed.error().code, file.string(), {}, flushed.error().detail};
    }
    if (::rename(written.c_str(), file.c_str()) != 0) {
        const int reason = errno;
        fs::remove(written, ignored);
        return writeError(file, reason);
    }
    return flushToDisk(folderOf(file));
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
    return firstExisting(here / "resources", firstExisting(here / "../resources", here / "../share/burin/resources"));
}

fs::path pluginDirectory() {
    const fs::path here = executableDirectory();
    return firstExisting(here / "plugins", firstExisting(here / "../plugins", here / "../lib/burin/plugins"));
}

} // namespace burin

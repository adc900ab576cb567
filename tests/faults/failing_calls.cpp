// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Loaded before the C library (LD_PRELOAD): makes the n-th call that changes a file fail, in the program that
// BURIN_FAULT_PROGRAM names and for files below BURIN_FAULT_FOLDER.
//   BURIN_FAULT_AT      n, from 1; 0: none, only count
//   BURIN_FAULT_KIND    EIO, EINTR: this call. ENOSPC: this one and all that follow, as on a full disk.
//                       SHORT: a write takes half. KILL: the program dies instead of the call
//   BURIN_FAULT_COUNT   file that gets the number of calls, eight bytes, valid through a kill
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

enum class Fault { none, error, half };

struct Settings {
    std::string folder, kind;
    std::uint64_t at = 0;
    std::atomic<std::uint64_t>* count = nullptr; // shared with the file; null: this program is not affected
};

const char* valueOf(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

Settings readSettings() {
    Settings settings;
    if (std::string_view(valueOf("BURIN_FAULT_PROGRAM")) != program_invocation_short_name) return settings;
    settings.folder = valueOf("BURIN_FAULT_FOLDER");
    settings.kind = valueOf("BURIN_FAULT_KIND");
    settings.at = std::strtoull(valueOf("BURIN_FAULT_AT"), nullptr, 10);
    const long file = syscall(SYS_openat, AT_FDCWD, valueOf("BURIN_FAULT_COUNT"), O_RDWR | O_CLOEXEC, 0);
    if (file < 0 || settings.folder.empty()) return settings;
    void* const shared =
        mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED, static_cast<int>(file), 0);
    syscall(SYS_close, file);
    if (shared != MAP_FAILED) settings.count = static_cast<std::atomic<std::uint64_t>*>(shared);
    return settings;
}

const Settings& settings() {
    static const Settings read = readSettings();
    return read;
}

bool concerns(std::string_view path) {
    return settings().count != nullptr && path.starts_with(settings().folder);
}

/// Counts a call on `path` and returns its fault, with errno set.
Fault faultOf(std::string_view path, bool writes) {
    if (!concerns(path)) return Fault::none;
    const std::uint64_t number = settings().count->fetch_add(1) + 1;
    const std::string& kind = settings().kind;
    const bool now = settings().at > 0 && (number == settings().at || (kind == "ENOSPC" && number > settings().at));
    if (!now) return Fault::none;
    if (kind == "KILL") {
        kill(getpid(), SIGKILL);
        for (;;) pause();
    }
    if (kind == "SHORT") return writes ? Fault::half : Fault::none;
    errno = kind == "EINTR" ? EINTR : kind == "ENOSPC" ? ENOSPC : EIO;
    return Fault::error;
}

std::string_view pathOf(int descriptor, std::array<char, PATH_MAX>& buffer) {
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const long size = syscall(SYS_readlink, link.c_str(), buffer.data(), buffer.size());
    return size < 0 ? std::string_view() : std::string_view(buffer.data(), static_cast<std::size_t>(size));
}

Fault faultOn(int descriptor, bool writes) {
    if (settings().count == nullptr || descriptor <= STDERR_FILENO) return Fault::none;
    std::array<char, PATH_MAX> buffer{};
    return faultOf(pathOf(descriptor, buffer), writes);
}

std::string absolute(const char* path) {
    if (path[0] == '/') return path;
    std::array<char, PATH_MAX> here{};
    if (syscall(SYS_getcwd, here.data(), here.size()) < 0) return path;
    return std::string(here.data()) + "/" + path;
}

Fault faultAt(const char* path) {
    return settings().count == nullptr ? Fault::none : faultOf(absolute(path), false);
}

std::size_t half(std::size_t size) {
    return std::max<std::size_t>(size / 2, 1);
}

int openFile(const char* path, int flags, mode_t rights) {
    if ((flags & O_CREAT) != 0 && faultAt(path) == Fault::error) return -1;
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, rights));
}

FILE* openStream(const char* name, const char* path, const char* mode) {
    if (std::strpbrk(mode, "wa+") != nullptr && faultAt(path) == Fault::error) return nullptr;
    using Open = FILE* (*)(const char*, const char*);
    return reinterpret_cast<Open>(dlsym(RTLD_NEXT, name))(path, mode);
}

} // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t size) {
    const Fault fault = faultOn(descriptor, true);
    if (fault == Fault::error) return -1;
    return syscall(SYS_write, descriptor, bytes, fault == Fault::half ? half(size) : size);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t offset) {
    const Fault fault = faultOn(descriptor, true);
    if (fault == Fault::error) return -1;
    return syscall(SYS_pwrite64, descriptor, bytes, fault == Fault::half ? half(size) : size, offset);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset) {
    return pwrite64(descriptor, bytes, size, offset);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    const Fault fault = faultOn(descriptor, true);
    if (fault == Fault::error) return -1;
    if (fault == Fault::half && count > 0)
        return syscall(SYS_write, descriptor, parts[0].iov_base, half(parts[0].iov_len));
    return syscall(SYS_writev, descriptor, parts, count);
}

int fsync(int descriptor) {
    return faultOn(descriptor, false) == Fault::error ? -1 : static_cast<int>(syscall(SYS_fsync, descriptor));
}

int fdatasync(int descriptor) {
    return faultOn(descriptor, false) == Fault::error ? -1 : static_cast<int>(syscall(SYS_fdatasync, descriptor));
}

int ftruncate64(int descriptor, off64_t size) {
    return faultOn(descriptor, false) == Fault::error ? -1 : static_cast<int>(syscall(SYS_ftruncate, descriptor, size));
}

int ftruncate(int descriptor, off_t size) {
    return ftruncate64(descriptor, size);
}

int rename(const char* from, const char* to) {
    return faultAt(to) == Fault::error ? -1 : static_cast<int>(syscall(SYS_rename, from, to));
}

int link(const char* from, const char* to) {
    return faultAt(to) == Fault::error ? -1 : static_cast<int>(syscall(SYS_link, from, to));
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t rights = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return openFile(path, flags, rights);
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t rights = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return openFile(path, flags | O_LARGEFILE, rights);
}

FILE* fopen(const char* path, const char* mode) {
    return openStream("fopen", path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    return openStream("fopen64", path, mode);
}
}

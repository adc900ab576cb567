// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_file.h"

#include "core/base/checksum.h"
#include "core/base/file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longestName = 255;  // bytes, for every file system that Burin is used on
constexpr std::size_t temporaryRoom = 40; // ".", ".PID-NUMBER.part-journal"
constexpr std::array journalEndings{"", "-wal", "-shm", "-journal"};

/// Repeats a system call that was interrupted by a signal; a limited number of times, in case a driver keeps failing.
template <class Call>
auto uninterrupted(Call call) {
    auto outcome = call();
    for (int tries = 0; outcome < 0 && errno == EINTR && tries < 100; ++tries) outcome = call();
    return outcome;
}

/// Returns 0, or the `errno` value of the failure.
int writeAll(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = uninterrupted([&] { return ::write(descriptor, content.data(), content.size()); });
        if (written < 0) return errno;
        if (written == 0) return EIO;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Flushes the names in a folder. Returns 0, or the `errno` value of the failure.
int flushFolder(const fs::path& folder) {
    const int descriptor = uninterrupted([&] { return ::open(folder.c_str(), O_RDONLY | O_CLOEXEC); });
    // A folder may be writable but not readable, and some file systems cannot flush any (EINVAL): a rename is then as
    // durable as the file system makes it.
    if (descriptor < 0) return 0;
    const int reason = uninterrupted([&] { return ::fsync(descriptor); }) != 0 && errno != EINVAL ? errno : 0;
    ::close(descriptor);
    return reason;
}

/// The descriptor of this process that `/dev/stdout` and similar names refer to; -1 if none.
int descriptorNamed(const fs::path& file) {
    const std::string name = file.lexically_normal().string();
    if (name == "/dev/stdout") return STDOUT_FILENO;
    if (name == "/dev/stderr") return STDERR_FILENO;
    const std::string own = "/proc/" + std::to_string(::getpid()) + "/fd/";
    for (const std::string_view folder : {std::string_view("/dev/fd/"), std::string_view("/proc/self/fd/"),
                                          std::string_view("/proc/thread-self/fd/"), std::string_view(own)}) {
        if (!name.starts_with(folder)) continue;
        int number = -1;
        const char* const end = name.data() + name.size();
        const auto [rest, wrong] = std::from_chars(name.data() + folder.size(), end, number);
        return wrong == std::errc{} && rest == end ? number : -1;
    }
    return -1;
}

/// ".NAME.", the beginning of names made by `temporaryBeside`.
std::string temporaryStart(const fs::path& file) {
    return "." + nameWithRoom(file.filename().string(), temporaryRoom) + ".";
}

bool isTemporary(std::string_view name, std::string_view start) {
    if (!name.starts_with(start)) return false;
    name.remove_prefix(start.size());
    for (const std::string_view ending : journalEndings)
        if (!ending.empty() && name.ends_with(ending)) name.remove_suffix(ending.size());
    if (!name.ends_with(".part")) return false;
    name.remove_suffix(5);
    return !name.empty() && name.find_first_not_of("0123456789-") == std::string_view::npos;
}

/// The writer of such a file holds a lock on it.
bool isBeingWritten(const fs::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(descriptor);
    return locked;
}

/// Files of this process that are neither put in place nor removed yet.
struct Unplaced {
    std::recursive_timed_mutex mutex; ///< also held while files are put in place
    std::set<fs::path> files;
};

Unplaced& unplaced() {
    static auto* const all = new Unplaced; // never destroyed: threads may outlive static objects
    return *all;
}

void noteUnplaced(const fs::path& file) {
    const std::lock_guard guard(unplaced().mutex);
    unplaced().files.insert(file);
}

void forgetUnplaced(const fs::path& file) {
    const std::lock_guard guard(unplaced().mutex);
    unplaced().files.erase(file);
}

void removeWithJournals(const fs::path& file) noexcept {
    for (const char* ending : journalEndings) ::unlink((file.string() + ending).c_str());
}

} // namespace

Result<void> makeFolderOf(const fs::path& file) {
    std::error_code failed;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), failed);
    return failed ? Result<void>(writeError(file, failed.value())) : Result<void>();
}

std::string nameWithRoom(const std::string& name, std::size_t suffixBytes) {
    if (name.size() + suffixBytes <= longestName) return name;
    constexpr std::size_t digits = 16;
    std::size_t kept = longestName - suffixBytes - digits - 1;
    while (kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0U) == 0x80U) --kept; // not within a character
    std::array<char, digits> sum{};
    const auto written = std::to_chars(sum.data(), sum.data() + digits, std::uint64_t{checksum(name)}, 16);
    return name.substr(0, kept) + "~" + std::string(sum.data(), written.ptr);
}

fs::path temporaryBeside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return folderOf(file) /
           (temporaryStart(file) + std::to_string(::getpid()) + "-" + std::to_string(counter.fetch_add(1)) + ".part");
}

void removeAbandonedParts(const fs::path& file) noexcept try {
    const std::string start = temporaryStart(file);
    std::error_code failed;
    for (fs::directory_iterator entry(folderOf(file), failed), end; !failed && entry != end; entry.increment(failed))
        if (isTemporary(entry->path().filename().native(), start) && !isBeingWritten(entry->path()))
            ::unlink(entry->path().c_str());
} catch (...) { // out of memory: the files stay until the next call
}

fs::path behindLinks(const fs::path& file) {
    constexpr int mostLinks = 40; // limit of the kernel
    fs::path target = file;
    for (int link = 0; link < mostLinks && descriptorNamed(target) < 0; ++link) {
        std::error_code none;
        const fs::path next = fs::read_symlink(target, none);
        if (none) break;
        target = next.is_absolute() ? next : folderOf(target) / next;
    }
    return target;
}

int refusalToWrite(const fs::path& target) noexcept {
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) == 0) return 0;
    return errno == ENOENT ? 0 : errno;
}

StagedFile::StagedFile(fs::path file, fs::path target) : file_(std::move(file)), target_(std::move(target)) {}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : file_(std::move(other.file_))
    , target_(std::move(other.target_))
    , beside_(std::exchange(other.beside_, {}))
    , previous_(std::exchange(other.previous_, {}))
    , waiting_(std::move(other.waiting_))
    , descriptor_(std::exchange(other.descriptor_, -1))
    , existed_(other.existed_)
    , looked_(other.looked_)
    , state_(std::exchange(other.state_, State::done)) {}

StagedFile::~StagedFile() {
    if (!isStream() && state_ == State::writing) removeWithJournals(beside_);
    if (!isStream()) forgetUnplaced(beside_);
    if (!previous_.empty()) ::unlink(previous_.c_str());
    if (!previous_.empty()) forgetUnplaced(previous_);
    if (!isStream() && descriptor_ >= 0) ::close(descriptor_);
}

Result<StagedFile> StagedFile::begin(const fs::path& file) {
    StagedFile staged(file, behindLinks(file));
    staged.descriptor_ = descriptorNamed(staged.target_);
    if (staged.descriptor_ >= 0) return staged;
    struct stat standing {};
    if (::stat(staged.target_.c_str(), &standing) == 0) {
        if (S_ISDIR(standing.st_mode)) return writeError(file, EISDIR);
        if (!S_ISREG(standing.st_mode)) return staged;
    }
    if (Result<void> opened = staged.openBeside(); !opened) return std::move(opened).error();
    return staged;
}

Result<void> StagedFile::openBeside() {
    if (const int refused = refusalToWrite(target_); refused != 0) return writeError(file_, refused);
    removeAbandonedParts(target_);
    beside_ = temporaryBeside(target_);
    descriptor_ = uninterrupted(
        [&] { return ::open(beside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666); });
    if (descriptor_ < 0) {
        const int reason = errno;
        beside_.clear(); // the file may belong to another process
        return writeError(file_, reason);
    }
    noteUnplaced(beside_);
    ::flock(descriptor_, LOCK_EX | LOCK_NB); // without a lock the file is only less protected from clean-up
    return {};
}

Result<StagedFile> StagedFile::adopt(fs::path written, const fs::path& file) {
    StagedFile staged(file, behindLinks(file));
    staged.beside_ = std::move(written);
    noteUnplaced(staged.beside_);
    if (const int refused = refusalToWrite(staged.target_); refused != 0) return writeError(file, refused);
    staged.descriptor_ =
        uninterrupted([&] { return ::open(staged.beside_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC); });
    if (staged.descriptor_ < 0) return writeError(file, errno);
    if (Result<void> flushed = staged.flush(); !flushed) return std::move(flushed).error();
    return staged;
}

Result<StagedFile> StagedFile::containing(const fs::path& file, std::string_view content) {
    Result<StagedFile> staged = begin(file);
    if (!staged) return staged;
    if (Result<void> written = staged->append(content); !written) return std::move(written).error();
    if (Result<void> flushed = staged->flush(); !flushed) return std::move(flushed).error();
    return staged;
}

Result<void> StagedFile::append(std::string_view content) {
    if (isStream()) {
        waiting_ += content;
        return {};
    }
    if (const int reason = writeAll(descriptor_, content); reason != 0) return writeError(file_, reason);
    return {};
}

Result<void> StagedFile::flush() {
    if (isStream()) return {};
    struct stat standing {};
    if (::stat(target_.c_str(), &standing) == 0) {
        // Only root may change the owner of a file; otherwise the file is then owned by the user, as with any editor.
        if (::fchown(descriptor_, standing.st_uid, standing.st_gid) == 0 || standing.st_uid == ::geteuid())
            static_cast<void>(::fchmod(descriptor_, standing.st_mode & 07777));
        else
            static_cast<void>(::fchmod(descriptor_, standing.st_mode & 0777));
    }
    if (uninterrupted([&] { return ::fsync(descriptor_); }) != 0) return writeError(file_, errno);
    return {};
}

Result<void> StagedFile::sendToStream() {
    const bool own = descriptor_ >= 0;
    const int descriptor =
        own ? descriptor_ : uninterrupted([&] { return ::open(target_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC); });
    if (descriptor < 0) return writeError(file_, errno);
    const int reason = writeAll(descriptor, waiting_);
    if (!own) ::close(descriptor);
    if (reason != 0) return writeError(file_, reason);
    return {};
}

/// Gives the present file a second name until it is no longer needed. Returns 0, or the reason for the failure.
int StagedFile::linkPrevious() {
    const fs::path name = temporaryBeside(target_);
    const int reason = uninterrupted([&] { return ::link(target_.c_str(), name.c_str()); }) == 0 ? 0 : errno;
    looked_ = true;
    existed_ = reason != ENOENT;
    if (reason != 0) return reason;
    previous_ = name;
    noteUnplaced(previous_);
    return 0;
}

Result<void> StagedFile::keepPrevious() {
    if (isStream() || looked_) return {};
    const int reason = linkPrevious();
    if (reason == ENOSPC || reason == EDQUOT || reason == EIO) return writeError(file_, reason);
    return {};
}

Result<void> StagedFile::putInPlace() {
    if (isStream()) {
        state_ = State::done;
        return sendToStream();
    }
    const PlacingTogether alone;
    if (!looked_) linkPrevious();
    if (uninterrupted([&] { return ::rename(beside_.c_str(), target_.c_str()); }) != 0) return writeError(file_, errno);
    state_ = State::placed;
    const int reason = flushFolder(folderOf(target_));
    if (reason == 0) return {};
    Error error = writeError(file_, reason);
    if (!takeBack()) error.detail += "; the new content stands there all the same";
    return error;
}

bool StagedFile::takeBack() noexcept {
    if (state_ != State::placed) return false;
    if (existed_ && previous_.empty()) return false;
    const bool done = existed_ ? uninterrupted([&] { return ::rename(previous_.c_str(), target_.c_str()); }) == 0
                               : ::unlink(target_.c_str()) == 0;
    if (!done) return false;
    if (!previous_.empty()) forgetUnplaced(previous_);
    previous_.clear();
    state_ = State::done;
    return true;
}

PlacingTogether::PlacingTogether() {
    unplaced().mutex.lock();
}

PlacingTogether::~PlacingTogether() {
    unplaced().mutex.unlock();
}

void abandonStagedFiles() noexcept {
    // Never unlocked. A thread that holds it longer is waiting for the reader of a pipe.
    static_cast<void>(unplaced().mutex.try_lock_for(std::chrono::milliseconds(200)));
    for (const fs::path& file : unplaced().files) removeWithJournals(file);
}

Result<void> putInPlace(std::span<StagedFile> files) {
    const PlacingTogether alone;
    if (files.size() > 1)
        for (StagedFile& file : files)
            if (Result<void> kept = file.keepPrevious(); !kept) return kept;
    for (std::size_t i = 0; i < files.size(); ++i) {
        Result<void> placed = files[i].putInPlace();
        if (placed) continue;
        for (StagedFile& before : files.first(i)) before.takeBack();
        return placed;
    }
    return {};
}

} // namespace burin

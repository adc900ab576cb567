// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/step_file.h"

#include "core/base/file.h"

#include <cerrno>
#include <fcntl.h>
#include <map>
#include <unistd.h>

namespace burin {

namespace {

/// Opens a file that has no name. Returns a negative number where that is not possible.
int openNameless(const std::filesystem::path& beside) {
    const int file = ::open(beside.parent_path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) return file;
    const std::filesystem::path named = temporaryBeside(beside); // the file system has no nameless files
    const int other = ::open(named.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (other >= 0) ::unlink(named.c_str());
    return other;
}

bool writeAt(int file, std::uint64_t at, std::string_view bytes) noexcept {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

} // namespace

std::shared_ptr<StepFile> StepFile::in(const std::filesystem::path& beside) {
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::weak_ptr<StepFile>> files;
    const std::lock_guard lock(mutex);
    std::erase_if(files, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<StepFile>& file = files[beside.parent_path()];
    if (std::shared_ptr<StepFile> shared = file.lock()) return shared;
    const int descriptor = openNameless(beside);
    if (descriptor < 0) return nullptr;
    const auto made = std::make_shared<StepFile>(descriptor);
    file = made;
    return made;
}

StepFile::~StepFile() {
    ::close(descriptor_);
}

FilePart StepFile::append(std::string_view bytes) {
    const std::lock_guard lock(mutex_);
    if (!writeAt(descriptor_, end_, bytes)) return {};
    const FilePart part{end_, bytes.size()};
    end_ += part.size;
    return part;
}

std::size_t StepFile::read(std::uint64_t at, std::span<char> into) const noexcept {
    std::size_t done = 0;
    while (done < into.size()) {
        const ssize_t read =
            ::pread(descriptor_, into.data() + done, into.size() - done, static_cast<off_t>(at + done));
        if (read < 0 && errno == EINTR) continue;
        if (read <= 0) break;
        done += static_cast<std::size_t>(read);
    }
    return done;
}

void StepFile::release(const FilePart& part) noexcept {
    const std::lock_guard lock(mutex_);
    if (part.at + part.size == end_ && ::ftruncate(descriptor_, static_cast<off_t>(part.at)) == 0)
        end_ = part.at;
    else // where this fails, the space is given back with the file
        ::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(part.at),
                    static_cast<off_t>(part.size));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"
#include "tests/fuzz/project_mutation.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <unistd.h>

using namespace burin;
namespace fs = std::filesystem;

namespace {

/// A file in memory: writing each input to a disk would take longer than reading it. SQLite opens no file without a
/// name (memfd_create).
class MemoryFile {
public:
    MemoryFile() {
        std::error_code missing;
        const fs::path memory = fs::is_directory("/dev/shm", missing) ? "/dev/shm" : fs::temp_directory_path();
        folder_ = memory / ("burin-fuzz-" + std::to_string(::getpid()));
        fs::create_directory(folder_);
    }
    ~MemoryFile() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    fs::path name() const { return folder_ / "p.burin"; }
    void write(const std::uint8_t* bytes, std::size_t count) const {
        const int file = ::open(name().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        if (file < 0 || ::write(file, bytes, count) != static_cast<ssize_t>(count)) std::abort();
        ::close(file);
    }
    /// A reader must leave no other files behind.
    void checkAlone() const {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (entry.path() != name() && entry.path().extension() != ".lock") std::abort();
    }

private:
    fs::path folder_;
};

/// Reads everything in a project as a command or the window does.
void readAll(const Project& project) {
    static_cast<void>(project.model());
    static_cast<void>(project.setup());
    static_cast<void>(project.materials());
    static_cast<void>(project.tools());
    static_cast<void>(project.obstacles());
    static_cast<void>(project.axisMode());
    static_cast<void>(project.travelPlacement());
    static_cast<void>(project.programTarget());
    static_cast<void>(project.programDraft());
    static_cast<void>(project.leftAt());
    static_cast<void>(project.keptProgram());
    static_cast<void>(project.jobDigest());
    if (const auto kept = project.guides())
        if (kept->guides.size() > GuideSettings::capacity) std::abort();
    static_cast<void>(project.paths());
    static_cast<void>(project.programs());
    const auto takes = project.takes();
    if (!takes) return;
    for (const TakeInfo& take : *takes) {
        static_cast<void>(project.takeOutline(take.id));
        static_cast<void>(project.visitSamples(take.id, [](std::span<const Sample>) { return Result<void>(); }));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const MemoryFile file;
    file.write(bytes, count);
    if (const auto project = Project::openForReading(file.name())) readAll(*project);
    file.checkAlone();
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t count, std::size_t most,
                                               unsigned seed) {
    return fuzz::mutateProject(bytes, count, most, seed);
}

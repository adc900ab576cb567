// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

using namespace burin;

namespace {

/// All that a project tells, as a command or the window asks for it.
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
    static_cast<void>(project.guides());
    static_cast<void>(project.paths());
    static_cast<void>(project.programs());
    if (const auto takes = project.takes())
        for (const TakeInfo& take : *takes) static_cast<void>(project.take(take.id));
}

} // namespace

/// The file lies in memory: writing each to a disk would take longer than reading it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const int descriptor = ::memfd_create("fuzz.burin", MFD_CLOEXEC);
    static const std::string file = "/proc/self/fd/" + std::to_string(descriptor);
    if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, bytes, count, 0) != static_cast<ssize_t>(count))
        std::abort();
    if (const auto project = Project::openForReading(file)) readAll(*project);
    return 0;
}

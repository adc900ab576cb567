// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/available_memory.h"

#include "core/base/numbers.h"

#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

namespace burin {

std::size_t availableMemory() {
    std::ifstream information("/proc/meminfo");
    for (std::string name; information >> name;) {
        std::size_t kibibytes = 0;
        if (name == "MemAvailable:" && information >> kibibytes) return kibibytes * 1024;
        information.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

Result<void> needMemory(const char* subject, double bytes, MemoryRemedy remedy) {
    constexpr double share = 0.8, bytesPerMegabyte = 1e6;
    const double free = share * static_cast<double>(availableMemory());
    if (bytes <= free) return {};
    return Error{ErrorCode::outOfMemory, subject,
                 formatFixed(bytes / bytesPerMegabyte, 0) + " MB, " + formatFixed(free / bytesPerMegabyte, 0) + " MB",
                 remedy == MemoryRemedy::fewerTakes ? std::string(fewerTakes) : std::string()};
}

} // namespace burin

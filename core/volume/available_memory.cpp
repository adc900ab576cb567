// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/available_memory.h"

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

} // namespace burin

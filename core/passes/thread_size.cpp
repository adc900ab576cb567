// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_size.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace burin {

const std::array<ThreadSize, 14> coarseThreads{{
    {"M3", 3.0, 0.5},
    {"M3.5", 3.5, 0.6},
    {"M4", 4.0, 0.7},
    {"M5", 5.0, 0.8},
    {"M6", 6.0, 1.0},
    {"M8", 8.0, 1.25},
    {"M10", 10.0, 1.5},
    {"M12", 12.0, 1.75},
    {"M14", 14.0, 2.0},
    {"M16", 16.0, 2.0},
    {"M18", 18.0, 2.5},
    {"M20", 20.0, 2.5},
    {"M22", 22.0, 2.5},
    {"M24", 24.0, 3.0},
}};

Result<ThreadSize> threadSizeNamed(std::string_view designation) {
    const auto named = std::ranges::find(coarseThreads, designation, &ThreadSize::name);
    if (named != coarseThreads.end()) return *named;
    const std::size_t cross = designation.find_first_of("xX");
    if (cross != std::string_view::npos && cross > 1 && designation.front() == 'M') {
        const std::optional<double> diameter = parseNumber(designation.substr(1, cross - 1)),
                                    pitch = parseNumber(designation.substr(cross + 1));
        if (diameter && pitch && *diameter > 0.0 && *pitch > 0.0 && *pitch < *diameter)
            return ThreadSize{{}, *diameter, *pitch};
    }
    std::string known;
    for (const ThreadSize& size : coarseThreads) known += std::string(size.name) + ", ";
    return Error{ErrorCode::nameUnknown, "thread", std::string(designation), known + "M8x1"};
}

double threadDepth(double pitch) noexcept {
    return 0.625 * 0.5 * std::sqrt(3.0) * pitch;
}

double externalDepth(double pitch, double flat) noexcept {
    return 0.5 * std::sqrt(3.0) * (0.875 * pitch - flat);
}

double minorDiameter(const ThreadSize& size) noexcept {
    return size.diameter - 2.0 * threadDepth(size.pitch);
}

} // namespace burin

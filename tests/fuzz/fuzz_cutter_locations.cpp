// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/apt_reader.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Accepted input has points within the reach of a machine, feeds above 0 and arcs that end on their circle.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    (void)isCutterLocations(text);
    const Result<ParsedProgram> program = parseCutterLocations(text, "fuzz");
    if (!program) {
        if (program.error().place.empty() || program.error().detail.empty()) std::abort();
        return 0;
    }
    for (const NcMotion& motion : program->motions) {
        const glm::dvec3& to = motion.to.linear();
        for (int axis = 0; axis < 3; ++axis)
            if (!(to[axis] >= -1e6 && to[axis] <= 1e6)) std::abort();
        const bool feeds = motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc;
        if (feeds && !(motion.feed > 0.0 && motion.feed <= 1e9)) std::abort();
        if (motion.kind == NcMotionKind::arc && !motion.startKnown()) std::abort();
    }
    return 0;
}

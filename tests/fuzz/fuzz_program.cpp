// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/lint.h"
#include "core/nc/parser.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Every control reads the text. Accepted programs have finite points, and lint then finds no error except a missing
/// end; marks are within the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    MachineProfile machine;
    for (const Control& control : controls()) {
        const auto program = parseProgram(text, "fuzz", control);
        if (program)
            for (const NcMotion& motion : program->motions)
                if (!(glm::length(motion.to.linear()) < 1e15)) std::abort();
        for (const LintMark& mark : lint(text, {&control, &machine}))
            if (mark.line == 0 || mark.column == 0 || mark.length == 0 || mark.text.empty()) std::abort();
    }
    return 0;
}

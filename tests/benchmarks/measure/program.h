// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

#include <functional>
#include <vector>

namespace burin::benchmarks {

/// What one benchmark program measures.
struct Program {
    const char* name;  ///< of the executable
    const char* shows; ///< for --help
    std::vector<std::function<void(Session&)>> groups;
};

/// The command line that all benchmarks share: --json, --only PREFIX. @return  exit status (README.md)
int run(const Program& program, int argc, char** argv);

} // namespace burin::benchmarks

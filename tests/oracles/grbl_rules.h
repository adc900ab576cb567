// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin {

/// What GRBL 1.1 would answer to a program, sent line by line.
struct GrblVerdict {
    int error = 0; ///< of the first line that it refuses: GRBL's number; 0: all accepted
    int line = 0;  ///< from 1
};

/// GRBL's published rules (doc/csv/error_codes_en_US.csv, doc/markdown/interface.md and commands.md of 1.1), written
/// anew for tests. Knows words, modal groups, units, feed modes, planes and arcs; of the machine only where it is (from
/// 0).
GrblVerdict grblVerdict(const std::string& program);

} // namespace burin

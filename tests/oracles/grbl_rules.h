// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin {

/// GRBL 1.1's answer to a program that is sent line by line.
struct GrblVerdict {
    int error = 0; ///< GRBL's error number of the first refused line; 0: all lines accepted
    int line = 0;  ///< from 1
};

/// GRBL's published rules (doc/csv/error_codes_en_US.csv, doc/markdown/interface.md and commands.md of 1.1),
/// implemented independently for tests. Covers words, modal groups, units, feed modes, planes and arcs; of the
/// machine's state it knows only the position (starting at 0).
GrblVerdict grblVerdict(const std::string& program);

} // namespace burin

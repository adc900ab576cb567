// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/job/damaged/damages.h"
#include "tests/core/job/damaged/tray_job.h"

#include <string>
#include <vector>

namespace burin::test {

/// The result of checking a text.
struct Verdict {
    std::vector<std::uint32_t> lines; ///< named by findings, rejections of the control or a syntax error
    std::string text;                 ///< for people
    std::size_t findings = 0;         ///< including rejections of the control; 1 for a syntax error

    bool passed() const { return findings == 0; }
    bool names(std::uint32_t first, std::uint32_t last) const;
};

Verdict judge(const TrayJob& job, const std::string& text, const std::string& dialect);

} // namespace burin::test

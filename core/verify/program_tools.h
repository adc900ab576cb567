// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

namespace burin {

/// The tools that a program makes moves with, each once, and the tool of every motion.
struct ProgramTools {
    std::vector<Tool> tools;             ///< never empty
    std::vector<std::uint16_t> ofMotion; ///< by index in ParsedProgram::motions; from `known` on without meaning
    std::size_t known = 0; ///< number of motions before the first with a tool that the request does not have
};

/// Looks tools up in the request by their T numbers. Errors: notSupported (several numbers, but one tool for all in the
/// request).
Result<ProgramTools> toolsOf(const VerifyRequest& request);

/// The error for a program that calls a tool which the request does not have, after its known motions.
Error unknownTool(const VerifyRequest& request, const ProgramTools& tools);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

namespace burin {

/// The tools that a program makes moves with, each once, and which of them every motion has.
struct ProgramTools {
    std::vector<Tool> tools;             ///< never empty
    std::vector<std::uint16_t> ofMotion; ///< by place in ParsedProgram::motions; from `known` on of no meaning
    std::size_t known = 0;               ///< motions before the first of a tool that the request does not have
};

/// Looks tools up by their T numbers in the request. Errors: notSupported (several numbers, and a request that has one
/// tool for all).
Result<ProgramTools> toolsOf(const VerifyRequest& request);

/// The error of a program that calls a tool which the request does not have, behind its known motions.
Error unknownTool(const VerifyRequest& request, const ProgramTools& tools);

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

namespace burin {

/// The tools that a program makes moves with, each once, and which of them every motion has.
struct ProgramTools {
    std::vector<Tool> tools;             ///< never empty
    std::vector<std::uint16_t> ofMotion; ///< by place in ParsedProgram::motions
};

/// Looks tools up by their T numbers in the request. Errors: nameUnknown (a number that the request has no tool for),
/// notSupported (several numbers, and a request that has one tool for all).
Result<ProgramTools> toolsOf(const VerifyRequest& request);

} // namespace burin

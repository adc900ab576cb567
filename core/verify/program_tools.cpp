// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/program_tools.h"

#include <algorithm>
#include <map>

namespace burin {

namespace {

/// The tool of moves before the first tool change is assumed to be that of the first change, as nothing else is known.
int numberOf(const NcMotion& motion, int first) {
    return motion.tool != 0 ? motion.tool : first;
}

int firstNumber(const ParsedProgram& program) {
    for (const NcMotion& motion : program.motions)
        if (motion.tool != 0) return motion.tool;
    return 0;
}

} // namespace

Result<ProgramTools> toolsOf(const VerifyRequest& request) {
    const ParsedProgram& program = *request.program;
    const int first = firstNumber(program);
    ProgramTools result;
    std::map<int, std::uint16_t> places;
    for (const NcMotion& motion : program.motions) {
        const int number = numberOf(motion, first);
        auto place = places.find(number);
        if (place == places.end()) {
            if (request.tools.empty() && !places.empty())
                return Error{ErrorCode::notSupported, "a program with a tool change", "one program a tool", {}};
            const auto tool = std::find_if(request.tools.begin(), request.tools.end(),
                                           [&](const Tool& one) { return one.number == number; });
            if (!request.tools.empty() && tool == request.tools.end() && number != 0) break;
            result.tools.push_back(tool != request.tools.end() ? *tool : request.tool);
            place = places.emplace(number, static_cast<std::uint16_t>(result.tools.size() - 1)).first;
        }
        result.ofMotion.push_back(place->second);
    }
    result.known = result.ofMotion.size();
    result.ofMotion.resize(program.motions.size());
    if (result.tools.empty()) result.tools.push_back(request.tool);
    return result;
}

Error unknownTool(const VerifyRequest& request, const ProgramTools& tools) {
    std::string there;
    for (const Tool& tool : request.tools) there += (there.empty() ? "T" : ", T") + std::to_string(tool.number);
    const int number = numberOf(request.program->motions[tools.known], firstNumber(*request.program));
    return {ErrorCode::nameUnknown, "tool", "T" + std::to_string(number), there};
}

} // namespace burin

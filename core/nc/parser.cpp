// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parser.h"

#include "core/nc/interpreter.h"
#include "core/nc/line_reader.h"
#include "core/nc/line_walker.h"

#include <algorithm>

namespace burin {
namespace {

/// Lines that may be the cause of a fault: "; its start is set by line 145 and line 146".
std::string causesOf(const BlockFault& fault) {
    std::string text;
    const auto [first, second] = std::minmax(fault.starts[0], fault.starts[1]);
    if (second != 0) text += "; its start is set by line " + std::to_string(second);
    if (first != 0 && first != second) text += " and line " + std::to_string(first);
    if (fault.incrementalSince != 0)
        text += "; distances are incremental since line " + std::to_string(fault.incrementalSince);
    return text;
}

Error syntaxError(const std::string& origin, std::uint32_t line, std::string_view text, const BlockFault& fault) {
    std::string detail(wordingOf(fault.problem));
    const std::string words = fault.length > 1 ? shownWords(text, fault.column - 1, fault.length) : std::string();
    if (!words.empty()) detail += ": " + words;
    detail += causesOf(fault);
    return Error{ErrorCode::programSyntax, origin,
                 "line " + std::to_string(line) + ", column " + std::to_string(fault.column), std::move(detail)};
}

} // namespace

Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin, const Control& control,
                                   const MachineState& start) {
    Interpreter interpreter(control, start);
    Parameters parameters(start.unsetParametersAreZero,
                          [&interpreter](int number) { return interpreter.parameter(number); });
    interpreter.program.motions.reserve(static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1);
    Block block;
    BlockFault fault;
    LineWalker lines(text);
    while (const std::optional<std::string_view> line = lines.next()) {
        if (!readLine(*line, control, parameters, block, fault))
            return syntaxError(origin, lines.number(), *line, fault);
        const LineWalker::Mark mark = lines.mark(block, control.tapeMarks);
        if (mark == LineWalker::Mark::misplaced)
            return syntaxError(origin, lines.number(), *line, {ProgramProblem::percentMisplaced, 1, 1});
        if (mark == LineWalker::Mark::closes) {
            interpreter.program.ended = true;
            break;
        }
        if (!block.empty() && !interpreter.run(block, lines.number(), fault))
            return syntaxError(origin, lines.number(), *line, fault);
        if (interpreter.atEnd()) break;
    }
    return std::move(interpreter.program);
}

Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin) {
    return parseProgram(text, origin, defaultControl());
}

} // namespace burin

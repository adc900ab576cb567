// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_path.h"

#include "core/job/program_job.h"
#include "core/machine/kinematics.h"
#include "core/nc/apt_reader.h"
#include "core/nc/dialect_library.h"
#include "core/nc/parser.h"
#include "core/nc/work_offset.h"
#include "core/verify/tool_moves.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace burin {

namespace {

Result<ParsedProgram> read(std::string_view text, const std::string& file, const std::string& dialect,
                           const MachineProfile& machine) {
    return isCutterLocations(text) ? parseCutterLocations(text, file, kinematicsOf(machine, glm::dvec3(0.0)).get())
                                   : parseProgram(text, file, controlOfDialect(dialect, machine.axes()));
}

/// Checks that all positions are in the frame of one work offset, which is the setup's.
Result<void> checkOffsets(const ParsedProgram& program, const std::string& file) {
    std::optional<int> offset;
    for (const NcMotion& motion : program.motions) {
        if (!motion.takesAny()) continue;
        if (!offset) offset = motion.workOffset;
        if (motion.ownZero || motion.workOffset != *offset)
            return Error{ErrorCode::programSyntax, file, "line " + std::to_string(motion.line),
                         "a path has one work offset, and the program uses another one from here on"};
    }
    return {};
}

/// Empty if no tool has that number.
std::optional<Tool> numbered(const ToolChoice& choice, int number) {
    const std::vector<Tool>& tools = choice.tools;
    if (!tools.empty() && (choice.anyNumber || (number == 0 && tools.size() == 1))) return tools.front();
    const auto found = std::ranges::find(tools, number, &Tool::number);
    return found == tools.end() ? std::nullopt : std::optional(*found);
}

Error unknownNumber(const std::vector<Tool>& tools, int number) {
    std::string known;
    for (const Tool& tool : tools)
        known += (known.empty() ? "T" : ", T") + std::to_string(tool.number) + " (" + tool.id + ")";
    return {ErrorCode::nameUnknown, "tool", "T" + std::to_string(number), known};
}

/// Whether all feed moves are made with one tool number.
bool callsOneNumber(const ParsedProgram& program) {
    std::optional<int> number;
    for (const NcMotion& motion : program.motions) {
        if (motion.rapid() || motion.kind == NcMotionKind::dwell) continue;
        if (number.value_or(motion.tool) != motion.tool) return false;
        number = motion.tool;
    }
    return true;
}

/// Makes passes from consecutive moves.
class PassWriter {
public:
    PassWriter(const std::string& file, const ToolChoice& tools)
        : file_(file), name_(std::filesystem::path(file).filename().string()), tools_(tools) {}

    Result<void> add(const ToolMove& move, const NcMotion& motion) {
        if (move.rapid || !move.startKnown || !move.endKnown) {
            made_.startless += !move.rapid && move.endKnown ? 1 : 0;
            begins_ = true;
            return {};
        }
        if (move.from.tip == move.to.tip && move.from.axis == move.to.axis) return {};
        if (Result<void> ready = beginPass(motion); !ready) return ready;
        ProgramPass& pass = made_.passes.back();
        if (move.tilted()) {
            if (pass.tool.cutter.type != CutterType::ball || pass.tool.cutter.solid != nullptr)
                return Error{ErrorCode::programSyntax, file_, "line " + std::to_string(motion.line),
                             "a tilted tool axis; paths tilt ball end mills only"};
            pass.tilted = true;
        }
        const Coolant coolant = coolantOf(motion);
        pass.coolantChanges = pass.coolantChanges || (!pass.moves.strokes.empty() && coolant != coolant_);
        coolant_ = coolant;
        if (pass.coolant == Coolant::off) pass.coolant = coolant;
        if (begins_) pass.moves.strokes.push_back({{move.from, moment_++}});
        begins_ = false;
        pass.moves.strokes.back().push_back(
            {move.to, moment_++, true, false, move.feed, motion.spindleOn() ? motion.spindleSpeed : 0.0, coolant});
        pass.length += glm::distance(move.from.tip, move.to.tip);
        return {};
    }
    ProgramPasses finish() { return std::move(made_); }

private:
    Result<void> beginPass(const NcMotion& motion) {
        if (!made_.passes.empty() && motion.tool == number_) return {};
        std::optional<Tool> tool = numbered(tools_, motion.tool);
        if (!tool) return unknownNumber(tools_.tools, motion.tool);
        if (Result<void> turns = checkTurns(tool->cutter, "a path of a program for a tool that doesn't turn"); !turns)
            return turns;
        number_ = motion.tool;
        moment_ = 0;
        begins_ = true;
        ProgramPass& pass = made_.passes.emplace_back();
        pass.moves.info.name = name_;
        pass.moves.info.toolId = tool->id;
        pass.tool = std::move(*tool);
        return {};
    }

    std::string file_, name_;
    const ToolChoice& tools_; ///< must outlive it
    ProgramPasses made_;
    std::int64_t moment_ = 0;
    int number_ = 0;
    Coolant coolant_ = Coolant::off; ///< of the move before
    bool begins_ = true;
};

} // namespace

double ProgramPasses::length() const noexcept {
    double sum = 0.0;
    for (const ProgramPass& pass : passes) sum += pass.length;
    return sum;
}

std::size_t ProgramPasses::coolantChanges() const noexcept {
    return static_cast<std::size_t>(std::ranges::count(passes, true, &ProgramPass::coolantChanges));
}

Result<ProgramPasses> passesOfProgram(std::string_view text, const std::string& file, const std::string& dialect,
                                      const MillingContext& milling, const ToolChoice& tools,
                                      const Progress& progress) {
    const Result<ParsedProgram> program = read(text, file, dialect, milling.machine);
    if (!program) return program.error();
    if (Result<void> checkable = checkLength(*program, file); !checkable) return std::move(checkable).error();
    if (Result<void> one = checkOffsets(*program, file); !one) return std::move(one).error();
    const ToolChoice only{{tools.onlyTool.value_or(Tool{})}, true};
    PassWriter writer(file, tools.onlyTool && callsOneNumber(*program) ? only : tools);
    constexpr double undivided = 1e9; // degrees: the path has the program's own moves
    for (const ToolMove& move : toolMoves(*program, milling.setup.workOffset, milling.machine, {}, undivided)) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "program", {}, {}};
        if (Result<void> added = writer.add(move, program->motions[move.motion]); !added)
            return std::move(added).error();
    }
    ProgramPasses made = writer.finish();
    if (made.passes.empty()) return Error{ErrorCode::pathEmpty, file, "", "it has no move at feed"};
    for (const NcMotion& motion : program->motions) {
        made.arcs += motion.kind == NcMotionKind::arc ? 1 : 0;
        made.dwells += motion.kind == NcMotionKind::dwell ? 1 : 0;
    }
    for (const ProgramPass& pass : made.passes)
        if (Result<void> valid = checkGenerated(pass.moves); !valid) return std::move(valid).error();
    return made;
}

PassUse useOf(const ProgramPass& pass) noexcept {
    using Cooling = SetFeed::Cooling;
    const Cooling cooling = pass.coolantChanges              ? Cooling::program
                            : pass.coolant == Coolant::flood ? Cooling::flood
                            : pass.coolant == Coolant::mist  ? Cooling::mist
                                                             : Cooling::off;
    return {cooling, pass.tilted};
}

namespace {

/// Arcs are not fitted to moves that turn the tool: each would have many axes.
void takeAxes(StoredPath& path, bool isNew) {
    if (isNew)
        std::erase_if(path.edits, [](const Edit& edit) { return std::holds_alternative<FitArcs>(edit.parameters); });
    for (const Edit& edit : path.edits)
        if (const auto* axis = std::get_if<ToolAxis>(&edit.parameters); axis && axis->from == ToolAxis::From::program)
            return;
    ToolAxis stated;
    stated.from = ToolAxis::From::program;
    path.edits.push_back({stated});
}

} // namespace

StoredPath withProgram(StoredPath path, const std::string& name, const PassUse& use, std::int64_t source) {
    const bool isNew = path.sources.empty();
    if (isNew && path.name.empty()) path.name = name;
    if (isNew) path.edits = programEdits();
    for (Edit& edit : path.edits)
        if (auto* feeds = std::get_if<SetFeed>(&edit.parameters)) {
            feeds->feeds = SetFeed::Feeds::program;
            if (isNew || use.cooling == SetFeed::Cooling::program) feeds->cooling = use.cooling;
        }
    if (use.tilted) takeAxes(path, isNew);
    path.sources.push_back({source});
    return path;
}

} // namespace burin

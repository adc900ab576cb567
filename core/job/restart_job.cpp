// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/restart_job.h"

#include "core/base/numbers.h"
#include "core/nc/dialect_library.h"
#include "core/nc/line_walker.h"
#include "core/nc/restart.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double clearance = 2.0;                         // mm above the stock, where rapids end
constexpr double largestTouch = 0.001;                    // mm³, as allowed by the check for a rapid
constexpr double shortestLead = 5.0, leadDiameters = 1.0; // mm; multiple of the cutter diameter

/// Returns the tools that a text may call; if it calls no number, or there is one tool for all numbers, that tool.
std::map<int, PostTool> postTools(const ParsedProgram& program, const MillingContext& milling,
                                  const ProgramRequest& request) {
    const Tool& only = request.tools.size() == 1 ? request.tools.front() : milling.tool;
    std::map<int, PostTool> tools{{0, {only.number, only.name}}};
    for (const Tool& tool : request.tools) tools[tool.number] = {tool.number, tool.name};
    if (request.tools.size() == 1)
        for (const NcMotion& motion : program.motions) tools.try_emplace(motion.tool, PostTool{motion.tool, only.name});
    return tools;
}

/// Returns the largest diameter of the cutters that a program calls, mm.
double widest(const ParsedProgram& program, const MillingContext& milling, const ProgramRequest& request) {
    if (request.tools.size() == 1) return request.tools.front().cutter.diameter;
    double diameter = 0.0;
    for (const Tool& tool : request.tools)
        if (std::ranges::find(program.motions, tool.number, &NcMotion::tool) != program.motions.end())
            diameter = std::max(diameter, tool.cutter.diameter);
    return diameter > 0.0 ? diameter : milling.tool.cutter.diameter;
}

/// Whether the plunge onto the path removes material, which shows that the tool had not plunged there before: a cutter
/// that is wider than its shank hits what it left above.
bool cutsOnTheWayDown(const CheckedProgram& program) {
    const auto down = std::ranges::find(program.parsed.motions, NcMotionKind::line, &NcMotion::kind);
    if (down == program.parsed.motions.end()) return false;
    return std::ranges::any_of(program.report.loads, [&](const MotionLoad& load) {
        return load.line <= down->line && load.volume > largestTouch;
    });
}

class RestartMaker {
public:
    RestartMaker(const MillingContext& milling, const ParsedProgram& interrupted, std::uint32_t line,
                 const ProgramRequest& request)
        : milling_(milling), interrupted_(interrupted), request_(request) {
        const double zero = milling.setup.workOffset.z;
        wanted_.line = line;
        wanted_.lead = std::max(shortestLead, leadDiameters * widest(interrupted, milling, request));
        wanted_.freeHeight = milling.setup.stock.high.z - zero + clearance;
        wanted_.safeHeight = milling.safeHeight() - zero;
        wanted_.programName = request.name;
        wanted_.units = request.units;
        wanted_.tools = postTools(interrupted, milling, request);
    }

    Result<RestartedProgram> make(RestartEntry entry, Progress& progress) {
        wanted_.entry = entry;
        wanted_.header.clear();
        Result<Restart> restart = restartAt(interrupted_, wanted_);
        if (!restart) return std::move(restart).error();
        restart->program.header = header(*restart);
        descends_ = restart->place[Axis::z] < wanted_.freeHeight;
        const Result<std::shared_ptr<const PostProcessor>> dialect = loadDialect(request_.dialect);
        if (!dialect) return dialect.error();
        Result<std::string> text = writeProgram(restart->program, milling_.machine, **dialect, progress);
        if (!text) return std::move(text).error();
        ProgramRequest check = request_;
        auto done = std::make_shared<ParsedProgram>(interrupted_);
        done->motions.resize(restart->done);
        check.before = std::move(done);
        Result<CheckedProgram> checked = checkProgram(milling_, std::move(*text), request_.name, check, progress);
        if (!checked) return std::move(checked).error();
        return RestartedProgram{std::move(*checked), wanted_.line, restart->cut, restart->lead,
                                restart->place.linear()};
    }

    /// Whether the tool of the last program made plunges onto the path at feed.
    bool descends() const noexcept { return descends_; }

private:
    std::vector<std::string> header(const Restart& restart) const {
        std::vector<Tool> called;
        for (const NcSection& section : restart.program.sections) {
            const auto tool = std::ranges::find(request_.tools, section.toolNumber, &Tool::number);
            const Tool& one = tool == request_.tools.end() ? milling_.tool : *tool;
            if (std::ranges::find(called, one.id, &Tool::id) == called.end()) called.push_back(one);
        }
        std::vector<std::string> lines = programHeader(milling_, called, request_.setupName);
        lines.insert(lines.begin(), {"RESTART at line " + std::to_string(wanted_.line) +
                                         " of the interrupted program: all lines before it are done",
                                     "The path is repeated from " + formatFixed(restart.lead, 1) + " mm before line " +
                                         std::to_string(restart.cut) + ". Measure the new tool first"});
        return lines;
    }

    const MillingContext& milling_;
    const ParsedProgram& interrupted_;
    const ProgramRequest& request_;
    RestartRequest wanted_;
    bool descends_ = false;
};

} // namespace

Result<RestartedProgram> makeRestart(const MillingContext& milling, const std::string& text, std::uint32_t line,
                                     const ProgramRequest& request, Progress& progress) {
    if (const std::uint32_t lines = lineCount(text); line < 1 || line > lines)
        return Error{ErrorCode::argumentInvalid, "restart line", std::to_string(line), "1 to " + std::to_string(lines)};
    const Result<ParsedProgram> interrupted =
        parseProgram(text, "interrupted program", controlOfDialect(request.dialect, milling.machine.axes()));
    if (!interrupted) return interrupted.error();
    if (!std::ranges::all_of(interrupted->motions, [](const NcMotion& motion) { return motion.to.onlyLinear(); }))
        return Error{ErrorCode::notSupported, "a restart of a program that tilts the tool", "programs of X, Y and Z",
                     ""};
    RestartMaker maker(milling, *interrupted, line, request);
    Result<RestartedProgram> near = [&] {
        const ProgressPart part(progress, 0.0, 0.5);
        return maker.make(RestartEntry::lead, progress);
    }();
    if (!near) return near;
    const bool cuts = maker.descends() && cutsOnTheWayDown(near->program);
    if (near->program.passed() && !cuts) return near;
    const ProgressPart part(progress, 0.5, 1.0);
    Result<RestartedProgram> far = maker.make(RestartEntry::retract, progress);
    if (!far || cuts) return far;
    return far->program.errorCount() < near->program.errorCount() ? std::move(far) : std::move(near);
}

} // namespace burin

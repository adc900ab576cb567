// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_job.h"

#include "core/base/available_memory.h"
#include "core/base/numbers.h"
#include "core/cutting/coolant_advice.h"
#include "core/job/computed_pass.h"
#include "core/job/lower_feeds.h"
#include "core/nc/dialect_library.h"
#include "core/nc/work_offset.h"
#include "core/path/milling_side.h"
#include "core/verify/kept_check.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

namespace burin {

namespace {

/// Returns the findings and the reason for exporting the program nevertheless: one line per kind of finding, with its
/// worst value.
std::vector<std::string> overrideLines(const CheckedProgram& program, const std::string& reason) {
    struct Kind {
        std::size_t count = 0;
        double worst = 0.0;
    };
    std::map<FindingKind, Kind> kinds;
    for (const Finding& finding : program.report.findings) {
        Kind& kind = kinds[finding.kind];
        ++kind.count;
        kind.worst = std::max(kind.worst, finding.amount);
    }
    std::vector<std::string> lines{"REFUSED BY THE CHECK AND EXPORTED ALL THE SAME", "Reason: " + reason};
    for (const auto& [id, kind] : kinds) {
        const std::string unit = unitOf(id);
        lines.push_back("Found: " + std::to_string(kind.count) + " x " + idOf(id) +
                        (unit.empty() ? "" : ", worst " + formatFixed(kind.worst, 4) + " " + unit));
    }
    const auto rejected = std::ranges::count(program.lint, LintSeverity::error, &LintMark::severity);
    if (rejected > 0) lines.push_back("Found: " + std::to_string(rejected) + " x rejected by the control");
    return lines;
}

Result<void> checkNumbers(const std::vector<Tool>& tools) {
    std::set<int> numbers;
    for (const Tool& tool : tools)
        if (!numbers.insert(tool.number).second)
            return Error{ErrorCode::argumentInvalid, "tool number", std::to_string(tool.number),
                         "a number of its own for each tool of a program"};
    return {};
}

Result<std::string> post(const MillingContext& milling, const ProgramPaths& paths, const ProgramRequest& request,
                         Progress& progress) {
    if (Result<void> numbered = checkNumbers(paths.tools); !numbered) return numbered.error();
    for (const Tool& tool : paths.tools)
        if (Result<void> turns = checkTurns(tool.cutter, "a program for a tool that doesn't turn"); !turns)
            return turns.error();
    PostRequest post;
    post.programName = request.name;
    post.header = programHeader(milling, paths.tools, request.setupName);
    post.workOffset = milling.setup.workOffset;
    post.workOffsetNumber = milling.setup.zero.workOffset;
    post.units = request.units;
    for (const Tool& tool : paths.tools) post.tools[tool.id] = {tool.number, tool.name};
    post.safeHeight = milling.safeHeight() - milling.setup.workOffset.z;
    const Result<NcProgram> program = toProgram(paths.paths, post, milling.machine);
    if (!program) return program.error();
    const Result<std::shared_ptr<const PostProcessor>> dialect = loadDialect(request.dialect);
    if (!dialect) return dialect.error();
    return writeProgram(*program, milling.machine, **dialect, progress);
}

Result<CheckedProgram> postAndCheck(const MillingContext& milling, const ProgramPaths& paths,
                                    const ProgramRequest& request, Progress& progress) {
    progress.stage(0.0, 0.1);
    Result<std::string> text = post(milling, paths, request, progress);
    if (!text) return std::move(text).error();
    return checkProgram(milling, std::move(*text), request.name, request, progress);
}

/// Returns the tools of the program's T numbers: one tool for all of them, or several to look up. Errors:
/// argumentInvalid (several tools with the same number).
Result<std::vector<Tool>> toolsMeant(const ParsedProgram& program, const MillingContext& milling,
                                     const ProgramRequest& request) {
    if (request.tools.size() == 1) return request.tools;
    std::set<int> numbers;
    for (const NcMotion& motion : program.motions)
        if (motion.tool != 0) numbers.insert(motion.tool);
    if (request.tools.empty() || numbers.empty()) return std::vector{milling.tool};
    std::vector<Tool> called;
    for (const int number : numbers)
        std::ranges::copy_if(request.tools, std::back_inserter(called),
                             [number](const Tool& tool) { return tool.number == number; });
    if (Result<void> numbered = checkNumbers(called); !numbered) return numbered.error();
    // If a called number belongs to no tool, all tools are named together with it.
    return called.size() < numbers.size() ? request.tools : called;
}

/// Measured with the edits of the main job on a recording of one hour: its strokes, and the peak memory of the edits.
constexpr double bytesPerSample = 300.0;

std::string memorySubject(const StoredPath& path, std::uint64_t samples) {
    return path.name + " (" + std::to_string(samples) + " samples)";
}

// The time of a check grows with the length of the moves: a mistyped number would take hours. mm
constexpr double longestMove = 1e6, longestProgram = 1e7;

constexpr std::string_view authored = "path authored by hand"; // some dialects write it in capitals

} // namespace

Result<void> checkLength(const ParsedProgram& program, const std::string& origin) {
    double all = 0.0;
    for (const NcMotion& motion : program.motions) {
        const double length = motion.startKnown() ? lengthOf(motion) : 0.0;
        all += length;
        if (length <= longestMove && all <= longestProgram) continue;
        const bool move = !(length <= longestMove);
        return Error{ErrorCode::programSyntax, origin, "line " + std::to_string(motion.line),
                     move ? "a move of " + formatShortest(std::round(length)) + " mm, and up to " +
                                formatShortest(longestMove) + " mm are checked"
                          : "all moves up to here are longer than the " + formatShortest(longestProgram) +
                                " mm that are checked"};
    }
    return {};
}

bool isPosted(std::string_view text) {
    constexpr std::size_t header = 4000; // characters
    const std::string_view head = text.substr(0, header);
    return !std::ranges::search(head, authored, [](char a, char b) {
                return std::tolower(static_cast<unsigned char>(a)) == b;
            }).empty();
}

namespace {

/// Returns the machinable materials other than the stock's, separated by commas.
std::string otherMaterials(const EmbeddedSetup& embedded) {
    const PropertyList& list = embedded.workpiece.properties();
    std::string names;
    for (int i = 1; i < list.size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        if (property == embedded.stockProperty || list.isProtected(property) || list.baseOf(property) != property)
            continue;
        names += (names.empty() ? "" : ", ") + list[property].name;
    }
    return names;
}

std::string textOf(const ProgramZero& zero) {
    if (zero.on == ZeroReference::point) return "stated coordinates";
    if (zero.on == ZeroReference::stock && zero.sides == ProgramZero{}.sides) return "centre of the stock's top face";
    std::string text(idOf(zero.on));
    for (std::size_t axis = 0; axis < zero.sides.size(); ++axis)
        text += std::string(", ") + "XYZ"[axis] + " " + std::string(idOf(zero.sides[axis]));
    return text;
}

/// Returns the coolants that tools use in the stock and the machine does not have, each once.
std::vector<Coolant> missingCoolants(const std::vector<Tool>& tools, const Property& material,
                                     const MachineProfile& machine) {
    std::vector<Coolant> missing;
    for (const Tool& tool : tools)
        if (const Coolant advised = advisedCoolant(tool, material);
            !machine.has(advised) && std::ranges::find(missing, advised) == missing.end())
            missing.push_back(advised);
    return missing;
}

} // namespace

std::vector<std::string> programHeader(const MillingContext& milling, const std::vector<Tool>& tools,
                                       const std::string& setupName) {
    const auto length = [](double value) { return formatFixed(value, 3); };
    const auto place = [&](const glm::dvec3& v) { return "X" + length(v.x) + " Y" + length(v.y) + " Z" + length(v.z); };
    const Box& stock = milling.setup.stock;
    std::vector<std::string> lines;
    lines.push_back("Burin: " + std::string(authored) + ", checked by re-simulation before export");
    if (!milling.model->sourceFile.empty())
        lines.push_back("Part: " + std::filesystem::path(milling.model->sourceFile).filename().string());
    if (!setupName.empty()) lines.push_back("Setup: " + setupName);
    lines.push_back("Stock: " + milling.setup.stockMaterial + ", size " + place(stock.size()) + " mm");
    if (const std::string others = otherMaterials(milling.embedded); !others.empty())
        lines.push_back("Stock of several materials, also: " + others);
    lines.push_back("Program zero: " + textOf(milling.setup.zero) + "; in the " +
                    (isNone(milling.setup.placement) ? "model's" : "setup's") + " frame " +
                    place(milling.setup.workOffset) + " mm");
    if (const int number = milling.setup.zero.workOffset; number != ProgramZero{}.workOffset)
        lines.push_back("Work offset: " + workOffsetName(number));
    lines.push_back("Stock in program coordinates: " + place(stock.low - milling.setup.workOffset) + " to " +
                    place(stock.high - milling.setup.workOffset) + " mm");
    const Property& material = milling.embedded.workpiece.properties()[milling.embedded.stockProperty];
    for (const Coolant missing : missingCoolants(tools, material, milling.machine))
        lines.push_back("Coolant: " + std::string(idOf(missing)) + " is advised for " + material.name +
                        ", the machine has none");
    for (const Tool& tool : tools)
        lines.push_back((tools.size() > 1 ? "Tool " + std::to_string(tool.number) + ": " : "Tool: ") + tool.name +
                        ", stick-out at least " + length(tool.cutter.stickOut) + " mm");
    return lines;
}

std::size_t CheckedProgram::errorCount() const noexcept {
    const auto rejected = std::ranges::count(lint, LintSeverity::error, &LintMark::severity);
    return report.findings.size() + static_cast<std::size_t>(rejected);
}

const Tool* CheckedProgram::toolNumbered(int number) const noexcept {
    if (tools.size() == 1) return &tools.front();
    const auto found = std::ranges::find(tools, number, &Tool::number);
    return found == tools.end() ? nullptr : &*found;
}

namespace {

Result<SourceStrokes> takeStrokesOf(const Project& project, const TakeOutline& take) {
    StrokeReader reader(take);
    Result<void> read =
        project.visitSamples(take.info.id, [&reader](std::span<const Sample> part) { return reader.add(part); });
    if (!read) return std::move(read).error();
    return reader.finish();
}

Result<SourceStrokes> generatedStrokesOf(const Project& project, PathSource source) {
    const Result<GeneratedMoves> moves = project.generatedMoves(source.id);
    if (!moves) return moves.error();
    Result<SourceStrokes> made = strokesOf(*moves);
    if (made && millsThreads(moves->info))
        for (PathStroke& stroke : made->strokes) stroke.allowance = stroke.required = -drillFit;
    return made;
}

/// Returns the takes that a path is made of, in the path's order.
Result<std::vector<TakeOutline>> outlinesOf(const Project& project, const StoredPath& path) {
    std::vector<TakeOutline> outlines;
    for (const std::int64_t id : takesOf(path.sources)) {
        Result<TakeOutline> take = project.takeOutline(id);
        if (!take) return std::move(take).error();
        outlines.push_back(std::move(*take));
    }
    return outlines;
}

/// Returns the number of generated points of a path.
Result<std::uint64_t> generatedPoints(const Project& project, const StoredPath& path) {
    const Result<std::vector<GeneratedInfo>> generated = project.generated();
    if (!generated) return generated.error();
    std::uint64_t points = 0;
    for (const PathSource source : path.sources)
        if (const auto made = std::ranges::find(*generated, source.id, &GeneratedInfo::id); made != generated->end())
            points += made->pointCount;
    return points;
}

} // namespace

Result<std::vector<SourceStrokes>> strokesOf(const Project& project, const StoredPath& path) {
    const Result<std::vector<TakeOutline>> takes = outlinesOf(project, path);
    if (!takes) return takes.error();
    const Result<std::uint64_t> points = generatedPoints(project, path);
    if (!points) return points.error();
    std::uint64_t samples = *points;
    for (const TakeOutline& take : *takes) samples += take.info.sampleCount - take.info.undoneCount;
    if (Result<void> fits = needMemory(memorySubject(path, samples).c_str(),
                                       bytesPerSample * static_cast<double>(samples), MemoryRemedy::fewerTakes);
        !fits)
        return std::move(fits).error();
    std::vector<SourceStrokes> strokes;
    auto take = takes->begin();
    for (const PathSource source : path.sources) {
        Result<SourceStrokes> made =
            source.isTake() ? takeStrokesOf(project, *take++) : generatedStrokesOf(project, source);
        if (!made) return std::move(made).error();
        strokes.push_back(std::move(*made));
    }
    return strokes;
}

namespace {

/// Returns the conditions by property; empty if the stock has only one material.
Result<std::vector<CuttingConditions>> conditionsByMaterial(const MillingContext& milling, const Tool& tool) {
    const PropertyList& list = milling.embedded.workpiece.properties();
    std::vector<CuttingConditions> conditions(static_cast<std::size_t>(list.size()));
    int milled = 0;
    for (int i = 1; i < list.size(); ++i) {
        const auto property = static_cast<PropertyIndex>(i);
        if (list.isProtected(property)) continue;
        ++milled;
        const Result<CuttingConditions> found =
            cuttingConditions(tool, list[property], milling.machine.maximumSpindleSpeed, milling.machine.maximumFeed);
        if (!found) return found.error();
        conditions[property] = *found;
    }
    if (milled < 2) conditions.clear();
    return conditions;
}

} // namespace

Result<EvaluatedPath> evaluateStored(std::vector<SourceStrokes> strokes, const MillingContext& milling,
                                     const Tool& tool, const StoredPath& path, std::span<const MilledPath> before,
                                     Progress& progress, const EvaluationHelp& help) {
    const Property& material = milling.embedded.workpiece.properties()[milling.embedded.stockProperty];
    const Result<CuttingConditions> conditions =
        cuttingConditions(tool, material, milling.machine.maximumSpindleSpeed, milling.machine.maximumFeed);
    if (!conditions) return conditions.error();
    PathContext context;
    context.part = &milling.part;
    context.tool = tool;
    context.conditions = *conditions;
    Result<std::vector<CuttingConditions>> byMaterial = conditionsByMaterial(milling, tool);
    if (!byMaterial) return std::move(byMaterial).error();
    for (const CuttingConditions& each : *byMaterial)
        if (each.rampAngle > 0.0) context.conditions.rampAngle = std::min(context.conditions.rampAngle, each.rampAngle);
    context.materialConditions = std::move(*byMaterial);
    context.advisedCoolant = advisedCoolant(tool, material);
    context.machine = milling.machine;
    context.stock = milling.setup.stock;
    context.obstacles = solidsOf(milling.surroundings());
    context.workOffset = milling.setup.workOffset;
    context.lendStock = [&milling, before](const StockUse& use, Progress& lending) {
        return milling.stock->lend(before, use, lending);
    };
    if (!before.empty()) context.cleared = before.back().evaluated->cleared;
    for (const SourceStrokes& each : help.sources != nullptr ? *help.sources : strokes)
        if (each.info.tickPeriod > 0.0) {
            context.tickPeriod = each.info.tickPeriod;
            break;
        }
    constexpr double editing = 0.9; // share of the work
    Result<EvaluatedPath> evaluated = [&] {
        const ProgressPart part(progress, 0.0, editing);
        return evaluate(path.name, std::move(strokes), path.edits, context, progress, help);
    }();
    if (!evaluated) return evaluated;
    for (const MilledPath& earlier : before) evaluated->after.push_back(earlier.evaluated);
    if (!tool.cutter.turns()) { // it mills neither climb nor conventional, and clears less than its profile
        evaluated->cleared = context.cleared;
        return evaluated;
    }
    const ProgressPart part(progress, editing, 1.0);
    Result<MilledSides> sides = millingSides(evaluated->path, context, progress);
    if (!sides) return std::move(sides).error();
    evaluated->sides = std::move(sides->intervals);
    evaluated->cleared = std::move(sides->cleared);
    return evaluated;
}

Result<EvaluatedPath> evaluateStored(const Project& project, const MillingContext& milling, const StoredPath& path,
                                     Progress& progress) {
    Result<std::vector<SourceStrokes>> strokes = strokesOf(project, path);
    if (!strokes) return std::move(strokes).error();
    return evaluateStored(std::move(*strokes), milling, milling.tool, path, {}, progress);
}

Result<CheckedProgram> makeProgram(const MillingContext& milling, const Path& path, const ProgramRequest& request,
                                   Progress& progress) {
    return makeProgram(milling, ProgramPaths{{path}, {milling.tool}}, request, progress);
}

Result<CheckedProgram> makeProgram(const MillingContext& milling, const ProgramPaths& paths,
                                   const ProgramRequest& request, Progress& progress) {
    ProgramRequest wanted = request;
    wanted.tools = paths.tools;
    if (!wanted.kept) wanted.kept = std::make_shared<KeptCheck>(); // lower feeds change no move
    Result<CheckedProgram> checked = postAndCheck(milling, paths, wanted, progress);
    if (!checked) return checked;
    ProgramPaths slower = paths;
    const std::unique_ptr<const Kinematics> kinematics = kinematicsOf(milling.machine, milling.setup.workOffset);
    if (const std::size_t slowed = lowerFeeds(slower.paths, checked->parsed, checked->report.feedLimits, *kinematics);
        slowed > 0) {
        checked = postAndCheck(milling, slower, wanted, progress);
        if (!checked) return checked;
        checked->slowed = slowed;
    }
    checked->moments = momentsOf(checked->parsed, wholeOf(paths.paths), *kinematics);
    if (checked->passed() || request.overrideReason.empty()) return checked;
    return overrideCheck(std::move(*checked), request.overrideReason, milling.machine);
}

Result<CheckedProgram> overrideCheck(CheckedProgram program, const std::string& reason, const MachineProfile& machine) {
    Result<std::string> text =
        withHeaderComments(program.text, overrideLines(program, reason), program.dialect, machine.maximumLineLength);
    if (!text) return std::move(text).error();
    Result<ParsedProgram> parsed = parseProgram(*text, "program", controlOfDialect(program.dialect, machine.axes()));
    if (!parsed) return std::move(parsed).error();
    const auto lines = [](const std::string& all) { return std::ranges::count(all, '\n'); };
    const auto added = static_cast<std::uint32_t>(lines(*text) - lines(program.text));
    for (Finding& finding : program.report.findings)
        if (finding.line > 0) finding.line += added;
    for (Finding& warning : program.report.warnings) warning.line += added;
    for (NearPass& pass : program.report.nearPasses) pass.line += added;
    for (TouchedVoxels& area : program.report.touched) area.line += added;
    for (MotionLoad& load : program.report.loads) load.line += added;
    for (LintMark& mark : program.lint) mark.line += added;
    program.text = std::move(*text);
    program.parsed = std::move(*parsed);
    program.overridden = true;
    return program;
}

Result<CheckedProgram> checkProgram(const MillingContext& milling, std::string text, const std::string& origin,
                                    const ProgramRequest& request, Progress& progress) {
    const Control& control = controlOfDialect(request.dialect, milling.machine.axes());
    Result<ParsedProgram> parsed = parseProgram(text, origin, control);
    if (!parsed) return std::move(parsed).error();
    if (Result<void> checkable = checkLength(*parsed, origin); !checkable) return std::move(checkable).error();
    VerifyRequest verification;
    verification.program = &*parsed;
    verification.control = &control;
    verification.model = milling.model.get();
    verification.partModel = milling.partModel.get();
    verification.part = &milling.part;
    verification.setup = milling.setup;
    verification.workOffset = milling.setup.zero.workOffset;
    verification.materials = milling.materials;
    verification.obstacles = milling.surroundings();
    if (milling.travel.zero) // an estimated position must not make a program fail
        verification.travel =
            travelEnvelope(milling.machine, milling.travel, milling.setup.workOffset, topOf(milling.setup)).tips;
    Result<std::vector<Tool>> tools = toolsMeant(*parsed, milling, request);
    if (!tools) return std::move(tools).error();
    CheckedProgram checked;
    checked.tools = std::move(*tools);
    verification.tool = checked.tools.front();
    if (!request.tools.empty() && !request.anyNumber) verification.tools = checked.tools;
    if (request.before) {
        Result<std::vector<Tool>> before = toolsMeant(*request.before, milling, request);
        if (!before) return std::move(before).error();
        verification.before = request.before.get();
        verification.toolsBefore = std::move(*before);
    }
    verification.machine = milling.machine;
    verification.gougeTolerance = request.gougeTolerance;
    verification.excessTolerance = request.excessTolerance;
    verification.promised = request.promised.get();
    verification.exactSamples = request.exactSamples;
    verification.import = request.import;
    Result<VerifyReport> report = verify(verification, progress, &checked.machined, request.kept.get());
    if (!report) return std::move(report).error();
    checked.lint = lint(text, {&control, &milling.machine});
    checked.text = std::move(text);
    checked.dialect = request.dialect;
    checked.gougeTolerance = request.gougeTolerance;
    checked.excessTolerance = request.excessTolerance;
    checked.parsed = std::move(*parsed);
    checked.report = std::move(*report);
    return checked;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/kept_program.h"

#include "core/base/checksum.h"
#include "core/base/resource_folder.h"
#include "core/job/job_paths.h"
#include "core/machine/machine_library.h"
#include "core/nc/dialect_library.h"
#include "core/verify/report_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace burin {

namespace {

using nlohmann::json;

/// Increment with every change that alters the verdict of parser, lint or check on a program.
constexpr int rulesOfJudgement = 2;

/// Combines data for one checksum: each part is preceded by its length, so that parts cannot run into each other.
class Parts {
public:
    void add(std::string_view part) { all_ += std::to_string(part.size()) + ' ' + std::string(part); }
    std::uint64_t checksum() const { return burin::checksum(all_); }

private:
    std::string all_;
};

/// Adds the library materials that the project has no copy of.
Result<void> addMaterials(const Project& project, Parts& parts) {
    const Result<Setup> setup = project.setup();
    if (!setup) return setup.error();
    Result<std::vector<Property>> own = project.materials();
    if (!own && own.error().code != ErrorCode::projectIncomplete) return std::move(own).error();
    const std::vector<std::string> used = materialsUsed(*setup);
    const std::set<std::string> wanted(used.begin(), used.end());
    for (const std::string& id : wanted) {
        if (own && std::ranges::find(*own, id, &Property::id) != own->end()) continue;
        const Result<Property> material = loadMaterial(id);
        if (!material) return material.error();
        parts.add(toJson(*material));
    }
    return {};
}

Result<void> addTools(const Project& project, Parts& parts) {
    const Result<std::vector<TakeInfo>> takes = standingTakes(project);
    if (!takes) return takes.error();
    std::set<std::string> ids;
    for (const TakeInfo& take : *takes) ids.insert(take.toolId);
    for (const std::string& id : ids) {
        const Result<Tool> tool = toolFor(project, id);
        if (!tool) return tool.error();
        parts.add(toJson(*tool));
    }
    return {};
}

/// Empty if a tool no longer exists.
std::optional<std::vector<Tool>> toolsFor(const Project& project, const std::vector<std::string>& ids) {
    std::vector<Tool> tools;
    for (const std::string& id : ids) {
        Result<Tool> tool = toolFor(project, id);
        if (!tool) return std::nullopt;
        tools.push_back(std::move(*tool));
    }
    if (tools.empty()) return std::nullopt;
    return tools;
}

/// Null if it can no longer be read.
std::shared_ptr<const CheckedProgram> programOf(const Project& project, const KeptProgram& kept) {
    const Result<MachineProfile> machine = loadMachine(kept.machine);
    const Control& control = controlOfDialect(kept.dialect, machine ? machine->axes() : linearAxes);
    Result<ParsedProgram> parsed = parseProgram(kept.text, "program", control);
    std::optional<VerifyReport> report = reportFromJson(kept.report);
    std::optional<std::vector<Tool>> tools = toolsFor(project, kept.tools);
    if (!parsed || !machine || !report || !tools) return nullptr;
    auto program = std::make_shared<CheckedProgram>();
    program->text = kept.text;
    program->dialect = kept.dialect;
    program->parsed = std::move(*parsed);
    program->tools = std::move(*tools);
    program->gougeTolerance = kept.gougeTolerance;
    program->excessTolerance = kept.excessTolerance;
    program->lint = lint(kept.text, {&control, &*machine});
    program->report = std::move(*report);
    program->overridden = kept.overridden;
    return program;
}

} // namespace

std::string toJson(const KeptProgram& program) {
    const json record{{"text", program.text},
                      {"dialect", program.dialect},
                      {"machine", program.machine},
                      {"units", idOf(program.units)},
                      {"gouge_tolerance_mm", program.gougeTolerance},
                      {"excess_tolerance_mm", program.excessTolerance},
                      {"overridden", program.overridden},
                      {"by_hand", program.byHand},
                      {"tools", program.tools},
                      {"left_out", program.leftOut},
                      {"report", program.report},
                      {"judged", program.judged}};
    return record.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<KeptProgram> keptProgramFromJson(std::string_view text) try {
    const json record = json::parse(text);
    KeptProgram program;
    record.at("text").get_to(program.text);
    record.at("dialect").get_to(program.dialect);
    record.at("machine").get_to(program.machine);
    record.at("gouge_tolerance_mm").get_to(program.gougeTolerance);
    program.excessTolerance = record.value("excess_tolerance_mm", program.excessTolerance); // missing in older files
    record.at("overridden").get_to(program.overridden);
    record.at("by_hand").get_to(program.byHand);
    record.at("tools").get_to(program.tools);
    record.at("left_out").get_to(program.leftOut);
    record.at("report").get_to(program.report);
    record.at("judged").get_to(program.judged);
    const auto units = ncUnitsFromId(record.at("units").get<std::string>());
    if (!units) return std::nullopt;
    program.units = *units;
    return program;
} catch (const json::exception&) {
    return std::nullopt;
}

Result<std::uint64_t> judgedBasis(const Project& project, const std::string& machine) {
    Parts parts;
    parts.add(BURIN_VERSION);
    parts.add(std::to_string(rulesOfJudgement));
    const Result<ResourceText> profile = findResource(machineResource, machine);
    if (!profile) return profile.error();
    parts.add(profile->text);
    const Result<std::int64_t> job = project.jobDigest();
    if (!job) return job.error();
    parts.add(std::to_string(*job));
    if (Result<void> added = addMaterials(project, parts); !added) return std::move(added).error();
    if (Result<void> added = addTools(project, parts); !added) return std::move(added).error();
    return parts.checksum();
}

std::uint64_t judgedChecksum(std::uint64_t basis, const KeptProgram& program) {
    Parts parts;
    parts.add(std::to_string(basis));
    parts.add(program.text);
    parts.add(program.dialect);
    parts.add(program.machine);
    parts.add(json(program.gougeTolerance).dump());
    parts.add(json(program.excessTolerance).dump());
    parts.add(program.overridden ? "overridden" : "");
    for (const std::string& tool : program.tools) parts.add(tool);
    parts.add(program.report);
    return parts.checksum();
}

Result<bool> isJudgedSo(const Project& project, const KeptProgram& program) {
    const Result<std::uint64_t> basis = judgedBasis(project, program.machine);
    if (!basis) return basis.error();
    return judgedChecksum(*basis, program) == program.judged;
}

Result<std::optional<ReopenedProgram>> reopenProgram(const Project& project) {
    const Result<std::string> record = project.keptProgram();
    if (!record) return record.error();
    std::optional<KeptProgram> kept = keptProgramFromJson(*record);
    if (!kept) return std::optional<ReopenedProgram>();
    ReopenedProgram reopened;
    reopened.program = programOf(project, *kept);
    if (!reopened.program) return std::optional<ReopenedProgram>();
    const Result<std::uint64_t> basis = judgedBasis(project, kept->machine);
    reopened.basis = basis ? *basis : 0;
    reopened.upToDate = basis && judgedChecksum(*basis, *kept) == kept->judged;
    reopened.kept = std::move(*kept);
    return std::optional(std::move(reopened));
}

KeptProgram keptOf(const CheckedProgram& program, const std::string& machine, NcUnits units, std::uint64_t basis) {
    KeptProgram kept;
    kept.text = program.text;
    kept.dialect = program.dialect;
    kept.machine = machine;
    kept.units = units;
    kept.gougeTolerance = program.gougeTolerance;
    kept.excessTolerance = program.excessTolerance;
    kept.overridden = program.overridden;
    for (const Tool& tool : program.tools) kept.tools.push_back(tool.id);
    kept.report = toJson(program.report);
    kept.judged = judgedChecksum(basis, kept);
    return kept;
}

Result<void> keepVerdict(Project& project, const CheckedProgram& program, const std::string& machine, NcUnits units) {
    const Result<std::uint64_t> basis = judgedBasis(project, machine);
    if (!basis) return basis.error();
    return project.setKeptProgram(toJson(keptOf(program, machine, units, *basis)));
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/assembly_report.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/cad/file_unit.h"
#include "core/machine/machine_library.h"
#include "core/verify/excess.h"
#include "core/verify/findings.h"
#include "core/verify/load_chart.h"
#include "ui/messages/messages.h"
#include "ui/panels/embedding_labels.h"
#include "ui/panels/fixture_labels.h"
#include "ui/panels/model_labels.h"
#include "ui/panels/texts.h"

#include <algorithm>
#include <array>
#include <set>

namespace burin {

namespace {

// Longer lists are truncated.
constexpr std::size_t mostFindings = 20, mostOmissions = 10, mostPlunges = 5, mostPathModes = 5;

/// "and 7 more", for a truncated list.
std::string moreText(std::size_t all, std::size_t shown) {
    return worded(BURIN_TEXT("Command", "and %1 more"), {std::to_string(all - shown)});
}

} // namespace

std::string placeText(const glm::dvec3& place) {
    return "(" + formatFixed(place.x, 3) + ", " + formatFixed(place.y, 3) + ", " + formatFixed(place.z, 3) + ") mm";
}

namespace {

// Names of a model's format and unit that need translation: formats such as "STEP AP214" are the same in every
// language.
[[maybe_unused]] constexpr std::array modelWords{BURIN_TEXT("ImportUnit", "none"),
                                                 BURIN_TEXT("ImportFormat", "STL binary")};

std::string bodyText(const Body& body, const std::string& name) {
    return worded(BURIN_TEXT("Command", "body     %1: %2 mm^3, %3 mm^2, %4 faces, %5 triangles"),
                  {name, formatFixed(body.volume, 3), formatFixed(body.area, 3), std::to_string(body.faceCount),
                   std::to_string(body.mesh.triangles.size())}) +
           (body.openEdges > 0 ? worded(BURIN_TEXT("Command", ", open")) : std::string());
}

std::string sizeText(const glm::dvec3& size) {
    return formatFixed(size.x, 3) + " x " + formatFixed(size.y, 3) + " x " + formatFixed(size.z, 3) + " mm";
}

/// A line on the size in the stated unit if another one was used; else empty.
std::string unitText(const Model& model) {
    if (!unitReplaced(model)) return {};
    return "\n  " +
           worded(BURIN_TEXT("Command", "stated   unit %1: %2"),
                  {worded({"ImportUnit", model.lengthUnit.c_str()}), sizeText(sizeInUnit(model, model.statedUnit))});
}

std::string noteText(const ImportNote& note) {
    return worded(note.kind == ImportNote::Kind::warning ? BURIN_TEXT("Command", "warning  %1")
                                                         : BURIN_TEXT("Command", "note     %1"),
                  {importNoteText(note.text).toStdString()});
}

} // namespace

std::string textOf(const Model& model) {
    if (model.bodies.empty()) return worded(BURIN_TEXT("Command", "no part"));
    const glm::dvec3 size = model.box().size();
    const std::string unit =
        unitReplaced(model) ? unitName(model.unitScale, formatShortest(model.unitScale) + " mm") : model.lengthUnit;
    std::string text = model.sourceFile + "\n  " +
                       worded(BURIN_TEXT("Command", "format   %1, unit %2"),
                              {worded({"ImportFormat", model.format.c_str()}), worded({"ImportUnit", unit.c_str()})}) +
                       "\n  " +
                       worded(BURIN_TEXT("Command", "size     %1 x %2 x %3 mm"),
                              {formatFixed(size.x, 3), formatFixed(size.y, 3), formatFixed(size.z, 3)}) +
                       unitText(model) + "\n  " +
                       worded(BURIN_TEXT("Command", "volume   %1 mm^3"), {formatFixed(model.volume(), 3)});
    text += textOfTree(model,
                       [&](std::size_t body, const std::string& name) { return bodyText(model.bodies[body], name); });
    for (const ImportNote& note : model.notes) text += "\n  " + noteText(note);
    return text;
}

std::string unprotected(const EmbeddedSetup& embedded) {
    const auto bodies =
        std::ranges::count(embedded.findings, EmbeddingFinding::Kind::tooSmall, &EmbeddingFinding::kind);
    if (bodies == 0) return {};
    return worded(BURIN_TEXT("Command", "Bodies too small for the voxels to be protected: %1. Choose smaller voxels, "
                                        "or continue nevertheless with --override."),
                  {std::to_string(bodies)});
}

std::string textOfDoubts(const Model& model, const EmbeddedSetup& embedded) {
    std::string text;
    const auto add = [&text](const QString& doubt) {
        text += "\n" + worded(BURIN_TEXT("Command", "warning: %1"), {doubt.toStdString()});
    };
    for (const ImportNote& note : model.notes)
        if (note.kind == ImportNote::Kind::warning) add(importNoteText(note.text));
    for (const EmbeddingFinding& finding : embedded.findings) add(embeddingText(finding, LengthUnit::millimetre));
    return text;
}

std::string textOf(const std::vector<BadFit>& fixtures) {
    std::string text;
    for (const auto& [name, fit] : fixtures)
        text += "\n" + worded(BURIN_TEXT("Command", "warning: %1"),
                              {fitText(name, fit, LengthUnit::millimetre).toStdString()});
    return text;
}

namespace {

/// Readable names for the ids of findings and near passes in JSON.
constexpr std::array findingNames{
    BURIN_TEXT("FindingName", "gouge"),
    BURIN_TEXT("FindingName", "rapid_in_stock"),
    BURIN_TEXT("FindingName", "shank_collision"),
    BURIN_TEXT("FindingName", "holder_collision"),
    BURIN_TEXT("FindingName", "spindle_off"),
    BURIN_TEXT("FindingName", "spindle_on"),
    BURIN_TEXT("FindingName", "travel_limit"),
    BURIN_TEXT("FindingName", "feed_limit"),
    BURIN_TEXT("FindingName", "spindle_limit"),
    BURIN_TEXT("FindingName", "unknown_start"),
    BURIN_TEXT("FindingName", "obstacle_collision"),
    BURIN_TEXT("FindingName", "spindle_power"),
    BURIN_TEXT("FindingName", "spindle_torque"),
    BURIN_TEXT("FindingName", "tool_breakage"),
    BURIN_TEXT("FindingName", "tool_bending"),
    BURIN_TEXT("FindingName", "chip_load"),
    BURIN_TEXT("FindingName", "depth_of_cut"),
    BURIN_TEXT("FindingName", "width_of_cut"),
    BURIN_TEXT("FindingName", "plunge_without_centre"),
    BURIN_TEXT("FindingName", "tool_unknown"),
    BURIN_TEXT("FindingName", "tool_not_loaded"),
    BURIN_TEXT("FindingName", "length_offset_missing"),
    BURIN_TEXT("FindingName", "length_offset_of_another_tool"),
    BURIN_TEXT("FindingName", "other_work_offset"),
    BURIN_TEXT("FindingName", "spindle_reversed"),
    BURIN_TEXT("FindingName", "corner_gouge"),
    BURIN_TEXT("FindingName", "corner_excess"),
    BURIN_TEXT("FindingName", "allowance_differs"),
    BURIN_TEXT("FindingName", "part_not_protected"),
    BURIN_TEXT("FindingName", "shank_near_stock"),
    BURIN_TEXT("FindingName", "shank_near_part"),
    BURIN_TEXT("FindingName", "shank_near_obstacle"),
    BURIN_TEXT("FindingName", "holder_near_stock"),
    BURIN_TEXT("FindingName", "holder_near_part"),
    BURIN_TEXT("FindingName", "holder_near_obstacle"),
};

std::string findingName(const std::string& id) {
    for (const TextId& name : findingNames)
        if (id == name.text) return worded(name);
    return id;
}

/// "spindle_power 918.0 W of 900.0 W"
std::string amountText(const Finding& finding) {
    const std::string name = findingName(idOf(finding.kind));
    if (!(finding.limit > 0.0)) return name + " " + formatFixed(finding.amount, 4);
    const int decimals = finding.limit > 1.0 && finding.kind != FindingKind::allowanceDiffers ? 1 : 4;
    const std::string unit = std::string(" ") + unitOf(finding.kind);
    return worded(BURIN_TEXT("Command", "%1 %2 of %3"),
                  {name, formatFixed(finding.amount, decimals) + unit, formatFixed(finding.limit, decimals) + unit});
}

/// "line 7: spindle_power 918.0 W of 900.0 W at (…) mm, and on 12 more lines"
std::string textOf(const Finding& finding) {
    const std::string where = finding.line > 0
                                  ? worded(BURIN_TEXT("Command", "line %1"), {std::to_string(finding.line)})
                                  : worded(BURIN_TEXT("Command", "program"));
    const std::string text =
        worded(BURIN_TEXT("Command", "%1: %2 at %3"), {where, amountText(finding), placeText(finding.place)});
    if (finding.count < 2) return text;
    return worded(static_cast<std::size_t>(finding.count - 1), BURIN_TEXT("Command", "%2, and on %1 more line"),
                  BURIN_TEXT("Command", "%2, and on %1 more lines"), {text});
}

/// Lines to append to others; empty if there are none.
std::string linesOf(const std::vector<LintMark>& marks) {
    std::string text;
    for (std::size_t i = 0; i < marks.size() && i < mostFindings; ++i) {
        const LintMark& mark = marks[i];
        text += "\n  " + worded(mark.severity == LintSeverity::error
                                    ? BURIN_TEXT("Command", "line %1, column %2: rejected by the control: %3")
                                    : BURIN_TEXT("Command", "line %1, column %2: %3"),
                                {std::to_string(mark.line), std::to_string(mark.column), lintText(mark).toStdString()});
    }
    if (marks.size() > mostFindings) text += "\n  " + moreText(marks.size(), mostFindings);
    return text;
}

} // namespace

std::string notWritten(const std::string& file) {
    return worded(BURIN_TEXT("Command",
                             "\"%1\" was not written: the program failed its check. To write it nevertheless, state a "
                             "reason with --override; the program's header shows the reason."),
                  {file});
}

std::string textOfOmissions(const std::vector<EditReport>& reports) {
    std::string text;
    for (const EditReport& report : reports) {
        if (report.omissions.empty()) continue;
        text += "\n  " +
                worded(report.omissions.size(), BURIN_TEXT("Command", "left out by %2: %3 mm of %4 mm, %1 part"),
                       BURIN_TEXT("Command", "left out by %2: %3 mm of %4 mm, %1 parts"),
                       {report.edit, formatFixed(lengthOf(report.omissions), 1), formatFixed(report.lengthBefore, 1)});
        const std::vector<const Omission*> parts = longestFirst(report.omissions);
        for (std::size_t i = 0; i < parts.size() && i < mostOmissions; ++i)
            text += "\n    " + worded(BURIN_TEXT("Command", "%1 mm from %2: %3"),
                                      {formatFixed(parts[i]->length, 2), placeText(parts[i]->line.front()),
                                       worded(textOf(parts[i]->reason))});
        if (parts.size() > mostOmissions) text += "\n    " + moreText(parts.size(), mostOmissions);
    }
    return text;
}

std::string textOfEntries(const std::vector<EditReport>& reports) {
    std::string text;
    for (const EditReport& report : reports) {
        if (report.entries.empty()) continue;
        const auto entries = [&](EntryForm form) { return countOf(report.entries, form); };
        const std::size_t plunges = entries(EntryForm::plunge);
        text += "\n  " +
                worded(BURIN_TEXT("Command", "%1: of %2 entries into material %3 by ramp, %4 by helix, %5 by "
                                             "plunge"),
                       {report.edit, std::to_string(report.entries.size()), std::to_string(entries(EntryForm::ramp)),
                        std::to_string(entries(EntryForm::helix)), std::to_string(plunges)});
        std::size_t told = 0;
        for (const StrokeEntry& entry : report.entries) {
            if (entry.form != EntryForm::plunge || told == mostPlunges) continue;
            ++told;
            text += "\n    " + worded(BURIN_TEXT("Command", "plunge of %1 mm to %2: no room for a ramp or helix"),
                                      {formatFixed(entry.depth, 2), placeText(entry.tip)});
        }
        if (plunges > told) text += "\n    " + moreText(plunges, told);
    }
    return text;
}

namespace {

std::string outcomeText(const CheckedProgram& program, double gougeTolerance) {
    const VerifyReport& report = program.report;
    return worded(program.passed()
                      ? BURIN_TEXT("Command", "passed: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact "
                                              "geometry)")
                      : BURIN_TEXT("Command", "refused: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact "
                                              "geometry)"),
                  {formatFixed(report.gougeMax, 4), formatFixed(gougeTolerance, 3), std::to_string(report.samples),
                   std::to_string(report.exactSamples)});
}

std::string excessText(const VerifyReport& report) {
    return worded(report.excessMax < longestExcess
                      ? BURIN_TEXT("Command", "excess   %1 mm at most, %2 mm on average, where the tool can reach")
                      : BURIN_TEXT("Command", "excess   %1 mm or more, %2 mm on average, where the tool can reach"),
                  {formatFixed(report.excessMax, 3), formatFixed(report.excessMean, 3)});
}

std::string timeText(const VerifyReport& report) {
    const std::string text = worded(
        static_cast<std::size_t>(report.toolChanges),
        BURIN_TEXT("Command", "removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool change (%4 s "
                              "at the programmed feeds alone)"),
        BURIN_TEXT("Command", "removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool changes (%4 s "
                              "at the programmed feeds alone)"),
        {formatFixed(report.removed, 1), formatFixed(report.machiningSeconds, 0),
         formatFixed(report.secondsWithoutAcceleration, 0)});
    if (report.untimedMoves == 0) return text;
    return worded(
        static_cast<std::size_t>(report.untimedMoves),
        BURIN_TEXT("Command", "%2; without %1 move whose start the program does not state (approach, return)"),
        BURIN_TEXT("Command", "%2; without %1 moves whose start the program does not state (approach, return)"),
        {text});
}

std::string machineText(const MachineProfile& machine) {
    return worded(isTypicalMachine(machine.id)
                      ? BURIN_TEXT("Command", "machine  %1: typical values, not those of your machine (burin machines "
                                              "copy)")
                      : BURIN_TEXT("Command", "machine  %1"),
                  {resourceName(machine.name)});
}

std::string loadText(const MotionLoad& load) {
    return worded(BURIN_TEXT("Command", "load     peak %1 N, %2 W, %3 N m on line %4 at %5 s"),
                  {formatFixed(load.peak.force, 0), formatFixed(load.peak.power, 0), formatFixed(load.peak.torque, 2),
                   std::to_string(load.line), formatFixed(load.peak.at, 1)});
}

std::string modeText(const StatedPathMode& mode) {
    if (mode.mode == PathMode::exactStop) return worded(BURIN_TEXT("Command", "exact stop after every block"));
    if (mode.mode == PathMode::exactPath) return worded(BURIN_TEXT("Command", "exact path, stops at corners"));
    return mode.tolerance > 0.0
               ? worded(BURIN_TEXT("Command", "blended within %1 mm"), {formatFixed(mode.tolerance, 3)})
               : worded(BURIN_TEXT("Command", "blended without limit"));
}

std::string textOf(const NearPass& pass) {
    const std::string text = worded(
        BURIN_TEXT("Command", "line %1: %2 %3 mm at %4"),
        {std::to_string(pass.line), findingName(idOf(pass)), formatFixed(pass.distance, 3), placeText(pass.place)});
    if (pass.lines < 2) return text;
    return worded(BURIN_TEXT("Command", "%1; %2 lines within %3 mm of that point"),
                  {text, std::to_string(pass.lines), formatShortest(nearPlace)});
}

std::string textOf(const TouchedVoxels& area) {
    return worded(
        BURIN_TEXT("Command", "touched  line %1: with the tip at %2 shank and holder touch %3 voxels of %4 mm"),
        {std::to_string(area.line), placeText(area.pose.tip), std::to_string(area.centres.size()),
         formatShortest(area.edge)});
}

std::string warningText(const std::string& text) {
    return worded(BURIN_TEXT("Command", "warning  %1"), {text});
}

/// Effects of spindle, tool and controller: load, feeds, corners. One line each.
std::vector<std::string> motionLines(const CheckedProgram& program) {
    const VerifyReport& report = program.report;
    std::vector<std::string> lines;
    if (const MotionLoad* const load = peakLoad(report.loads); load != nullptr && load->peak.force > 0.0)
        lines.push_back(loadText(*load));
    if (program.slowed > 0)
        lines.push_back(worded(
            static_cast<std::size_t>(program.slowed),
            BURIN_TEXT("Command", "feeds    reduced on %1 move to the limits of spindle and tool (feed by engagement)"),
            BURIN_TEXT("Command",
                       "feeds    reduced on %1 moves to the limits of spindle and tool (feed by engagement)")));
    for (std::size_t i = 0; i < report.pathModes.size() && i < mostPathModes; ++i)
        if (const StatedPathMode& mode = report.pathModes[i]; mode.mode != PathMode::machine)
            lines.push_back(worded(BURIN_TEXT("Command", "corners  from line %1 on, as the program states: %2"),
                                   {std::to_string(mode.line), modeText(mode)}));
    return lines;
}

/// Findings with a remedy for each kind, warnings and near passes. One line each.
std::vector<std::string> findingLines(const VerifyReport& report) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < report.findings.size() && i < mostFindings; ++i)
        lines.push_back(textOf(report.findings[i]));
    if (report.findings.size() > mostFindings) lines.push_back(moreText(report.findings.size(), mostFindings));
    std::set<FindingKind> told;
    for (const Finding& finding : report.findings)
        if (told.insert(finding.kind).second)
            lines.push_back(worded(BURIN_TEXT("Command", "remedy   %1: %2"),
                                   {findingName(idOf(finding.kind)), worded(remedyOf(finding.kind))}));
    for (const TouchedVoxels& area : report.touched) lines.push_back(textOf(area));
    for (std::size_t i = 0; i < report.warnings.size() && i < mostFindings; ++i)
        lines.push_back(warningText(textOf(report.warnings[i])));
    if (report.warnings.size() > mostFindings)
        lines.push_back(worded(BURIN_TEXT("Command", "and %1 more warnings"),
                               {std::to_string(report.warnings.size() - mostFindings)}));
    for (std::size_t i = 0; i < report.nearPasses.size() && i < mostFindings; ++i)
        lines.push_back(warningText(textOf(report.nearPasses[i])));
    if (report.nearPasses.size() > mostFindings)
        lines.push_back(worded(BURIN_TEXT("Command", "and %1 more points with warnings"),
                               {std::to_string(report.nearPasses.size() - mostFindings)}));
    return lines;
}

} // namespace

std::string textOf(const CheckedProgram& program, double gougeTolerance, const MachineProfile& machine) {
    std::string text = outcomeText(program, gougeTolerance) + "\n  " + excessText(program.report) + "\n  " +
                       timeText(program.report) + "\n  " + machineText(machine);
    for (const std::string& line : motionLines(program)) text += "\n  " + line;
    for (const std::string& line : findingLines(program.report)) text += "\n  " + line;
    return text + linesOf(program.lint);
}

} // namespace burin

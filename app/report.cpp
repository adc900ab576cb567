// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/report.h"

#include "core/base/numbers.h"
#include "core/machine/machine_library.h"
#include "core/verify/excess.h"
#include "core/verify/findings.h"
#include "core/verify/load_chart.h"
#include "core/verify/report_json.h"
#include "ui/panels/embedding_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>
#include <sstream>

namespace burin {

using nlohmann::json;

json jsonOf(const glm::dvec3& v) {
    return json::array({v.x, v.y, v.z});
}

json jsonOf(const Box& box) {
    return json::array({jsonOf(box.low), jsonOf(box.high)});
}

json jsonOf(const MachineProfile& machine) {
    return {{"id", machine.id},
            {"name", machine.name},
            {"dialect", machine.dialect.empty() ? json(nullptr) : json(machine.dialect)},
            {"typical", isTypicalMachine(machine.id)}};
}

json jsonOf(const Model& model) {
    json bodies = json::array();
    for (const Body& body : model.bodies) {
        json entry{{"name", body.name},           {"volume_mm3", body.volume},
                   {"area_mm2", body.area},       {"bounding_box_mm", jsonOf(body.box)},
                   {"faces", body.faceCount},     {"triangles", body.mesh.triangles.size()},
                   {"open_edges", body.openEdges}};
        entry["colour"] = body.colour ? json(*body.colour) : json(nullptr);
        bodies.push_back(std::move(entry));
    }
    json healing = json::array(), warnings = json::array();
    for (const ImportNote& note : model.notes)
        (note.kind == ImportNote::Kind::warning ? warnings : healing).push_back(note.text);
    return {{"file", model.sourceFile},
            {"format", model.format},
            {"unit", model.lengthUnit},
            {"unit_scale_mm", model.unitScale},
            {"mesh_chord_mm", model.meshChord},
            {"volume_mm3", model.volume()},
            {"bounding_box_mm", jsonOf(model.box())},
            {"bodies", bodies},
            {"healing", healing},
            {"warnings", warnings}};
}

json jsonOf(const Tool& tool) {
    return {{"id", tool.id},
            {"name", tool.name},
            {"number", tool.number},
            {"type", cutterTypeName(tool.cutter.type)},
            {"diameter_mm", tool.cutter.diameter},
            {"corner_radius_mm", tool.cutter.cornerRadius},
            {"flute_length_mm", tool.cutter.fluteLength},
            {"shank_diameter_mm", tool.cutter.shankDiameter},
            {"stick_out_mm", tool.cutter.stickOut}};
}

json jsonOf(const VerifyReport& report) {
    return json::parse(toJson(report));
}

namespace {

json jsonOf(const Omission& part) {
    return {{"reason", idOf(part.reason)},
            {"text", textOf(part.reason).text},
            {"take", part.take},
            {"first_tick", part.first},
            {"last_tick", part.last},
            {"from_mm", burin::jsonOf(part.line.front())},
            {"to_mm", burin::jsonOf(part.line.back())},
            {"length_mm", part.length}};
}

json jsonOf(const std::vector<StrokeEntry>& entries) {
    json list = json::array();
    for (const StrokeEntry& entry : entries)
        list.push_back({{"form", idOf(entry.form)},
                        {"take", entry.take},
                        {"tick", entry.sample},
                        {"to_mm", burin::jsonOf(entry.tip)},
                        {"depth_mm", entry.depth}});
    return list;
}

} // namespace

json jsonOf(const std::vector<EditReport>& reports) {
    json list = json::array();
    for (const EditReport& report : reports) {
        json entry{{"edit", report.edit},
                   {"points_before", report.pointsBefore},
                   {"points_after", report.pointsAfter},
                   {"largest_deviation_mm", report.largestDeviation},
                   {"worst_place_mm", jsonOf(report.worstPlace)}};
        if (!report.omissions.empty()) {
            entry["length_before_mm"] = report.lengthBefore;
            entry["left_out_mm"] = lengthOf(report.omissions);
            entry["left_out"] = json::array();
            for (const Omission& part : report.omissions) entry["left_out"].push_back(jsonOf(part));
        }
        if (!report.entries.empty()) entry["entries"] = jsonOf(report.entries);
        list.push_back(std::move(entry));
    }
    return list;
}

json jsonOf(const std::vector<LintMark>& marks) {
    json list = json::array();
    for (const LintMark& mark : marks)
        list.push_back({{"line", mark.line},
                        {"column", mark.column},
                        {"severity", mark.severity == LintSeverity::error ? "error" : "warning"},
                        {"text", mark.text}});
    return list;
}

std::string textOf(const Model& model) {
    std::ostringstream text;
    const glm::dvec3 size = model.box().size();
    text << model.sourceFile << "\n"
         << "  format   " << model.format << ", unit " << model.lengthUnit << "\n"
         << "  size     " << formatFixed(size.x, 3) << " x " << formatFixed(size.y, 3) << " x "
         << formatFixed(size.z, 3) << " mm\n"
         << "  volume   " << formatFixed(model.volume(), 3) << " mm^3";
    for (const Body& body : model.bodies)
        text << "\n  body     " << body.name << ": " << formatFixed(body.volume, 3) << " mm^3, "
             << formatFixed(body.area, 3) << " mm^2, " << body.faceCount << " faces, " << body.mesh.triangles.size()
             << " triangles" << (body.openEdges > 0 ? ", open" : "");
    for (const ImportNote& note : model.notes)
        text << "\n  " << (note.kind == ImportNote::Kind::warning ? "warning  " : "note     ") << note.text;
    return text.str();
}

std::vector<std::string> doubtsOf(const Model& model, const EmbeddedSetup& embedded) {
    std::vector<std::string> doubts;
    for (const ImportNote& note : model.notes)
        if (note.kind == ImportNote::Kind::warning) doubts.push_back(note.text);
    for (const EmbeddingFinding& finding : embedded.findings)
        doubts.push_back(embeddingText(finding, LengthUnit::millimetre).toStdString());
    return doubts;
}

std::string unprotected(const EmbeddedSetup& embedded) {
    const auto bodies =
        std::ranges::count(embedded.findings, EmbeddingFinding::Kind::tooSmall, &EmbeddingFinding::kind);
    if (bodies == 0) return {};
    return QCoreApplication::translate("Command", "Bodies too small for the voxels to be protected: %1. Choose smaller "
                                                  "voxels, or go on all the same with --override.")
        .arg(bodies)
        .toStdString();
}

std::string textOfDoubts(const std::vector<std::string>& doubts) {
    std::string text;
    for (const std::string& doubt : doubts) text += "\nwarning: " + doubt;
    return text;
}

namespace {

/// "line 7: spindle_power 918.0 W of 900.0 W at (…) mm, and on 12 lines near by"
std::string textOf(const Finding& finding) {
    const int decimals = finding.limit > 1.0 && finding.kind != FindingKind::allowanceDiffers ? 1 : 4;
    const std::string unit = finding.limit > 0.0 ? std::string(" ") + unitOf(finding.kind) : std::string();
    std::string text = (finding.line > 0 ? "line " + std::to_string(finding.line) : "program") + ": " +
                       idOf(finding.kind) + " " + formatFixed(finding.amount, finding.limit > 0.0 ? decimals : 4) +
                       unit;
    if (finding.limit > 0.0) text += " of " + formatFixed(finding.limit, decimals) + unit;
    text += " at (" + formatFixed(finding.place.x, 3) + ", " + formatFixed(finding.place.y, 3) + ", " +
            formatFixed(finding.place.z, 3) + ") mm";
    if (finding.count > 1)
        text += ", and on " + std::to_string(finding.count - 1) + (finding.count == 2 ? " more line" : " more lines");
    return text;
}

/// Lines that follow others; empty: there are none.
std::string linesOf(const std::vector<LintMark>& marks) {
    std::ostringstream text;
    for (std::size_t i = 0; i < marks.size() && i < 20; ++i)
        text << "\n  line " << marks[i].line << ", column " << marks[i].column
             << (marks[i].severity == LintSeverity::error ? ": rejected by the control: " : ": ") << marks[i].text;
    if (marks.size() > 20) text << "\n  and " << marks.size() - 20 << " more";
    return text.str();
}

} // namespace

std::string notWritten(const std::string& file) {
    return "\"" + file +
           "\" was not written: the program failed its check. To write it all the same, state a reason with "
           "--override; "
           "its header shows the reason.";
}

std::string textOfOmissions(const std::vector<EditReport>& reports) {
    constexpr std::size_t most = 10;
    std::ostringstream text;
    for (const EditReport& report : reports) {
        if (report.omissions.empty()) continue;
        text << "\n  left out by " << report.edit << ": " << formatFixed(lengthOf(report.omissions), 1) << " mm of "
             << formatFixed(report.lengthBefore, 1) << " mm, " << report.omissions.size()
             << (report.omissions.size() == 1 ? " part" : " parts");
        const std::vector<const Omission*> parts = longestFirst(report.omissions);
        for (std::size_t i = 0; i < parts.size() && i < most; ++i) {
            const Omission& part = *parts[i];
            const glm::dvec3& place = part.line.front();
            text << "\n    " << formatFixed(part.length, 2) << " mm from (" << formatFixed(place.x, 3) << ", "
                 << formatFixed(place.y, 3) << ", " << formatFixed(place.z, 3) << ") mm: " << textOf(part.reason).text;
        }
        if (parts.size() > most) text << "\n    and " << parts.size() - most << " more";
    }
    return text.str();
}

std::string textOfEntries(const std::vector<EditReport>& reports) {
    constexpr std::size_t most = 5;
    std::ostringstream text;
    for (const EditReport& report : reports) {
        if (report.entries.empty()) continue;
        const auto count = [&](EntryForm form) { return countOf(report.entries, form); };
        const std::size_t plunges = count(EntryForm::plunge);
        text << "\n  " << report.edit << ": of " << report.entries.size() << " entries into material "
             << count(EntryForm::ramp) << " by ramp, " << count(EntryForm::helix) << " by helix, " << plunges
             << " by plunge";
        std::size_t told = 0;
        for (const StrokeEntry& entry : report.entries) {
            if (entry.form != EntryForm::plunge || told == most) continue;
            ++told;
            text << "\n    plunge of " << formatFixed(entry.depth, 2) << " mm to (" << formatFixed(entry.tip.x, 3)
                 << ", " << formatFixed(entry.tip.y, 3) << ", " << formatFixed(entry.tip.z, 3)
                 << ") mm: no room for a ramp or helix";
        }
        if (plunges > told) text << "\n    and " << plunges - told << " more";
    }
    return text.str();
}

namespace {

std::string untimedText(int moves) {
    if (moves == 0) return {};
    return "; without " + std::to_string(moves) + (moves == 1 ? " move" : " moves") +
           " whose way the program does not state (approach, way home)";
}

} // namespace

std::string textOf(const CheckedProgram& program, double gougeTolerance, const MachineProfile& machine) {
    const VerifyReport& report = program.report;
    std::ostringstream text;
    text << (program.passed() ? "passed" : "refused") << ": gouge " << formatFixed(report.gougeMax, 4)
         << " mm (tolerance " << formatFixed(gougeTolerance, 3) << " mm, " << report.samples << " points, "
         << report.exactSamples << " of them on exact geometry)\n"
         << "  excess   " << formatFixed(report.excessMax, 3)
         << (report.excessMax < longestExcess ? " mm at most, " : " mm or more, ") << formatFixed(report.excessMean, 3)
         << " mm in the mean, where the tool can reach\n"
         << "  removed  " << formatFixed(report.removed, 1) << " mm^3 in " << formatFixed(report.machiningSeconds, 0)
         << " s, with accelerations, corners, dwells and " << report.toolChanges
         << (report.toolChanges == 1 ? " tool change (" : " tool changes (")
         << formatFixed(report.secondsWithoutAcceleration, 0) << " s at the programmed feeds alone)"
         << untimedText(report.untimedMoves) << "\n"
         << "  machine  " << machine.name
         << (isTypicalMachine(machine.id) ? ": typical values, not those of your machine (burin machines copy)" : "");
    if (const MotionLoad* const load = peakLoad(report.loads); load != nullptr && load->peak.force > 0.0)
        text << "\n  load     peak " << formatFixed(load->peak.force, 0) << " N, " << formatFixed(load->peak.power, 0)
             << " W, " << formatFixed(load->peak.torque, 2) << " N m on line " << load->line << " at "
             << formatFixed(load->peak.at, 1) << " s";
    if (program.slowed > 0)
        text << "\n  feeds    brought down on " << program.slowed << (program.slowed == 1 ? " move" : " moves")
             << " to what spindle and tool bear (feed by engagement)";
    for (std::size_t i = 0; i < report.pathModes.size() && i < 5; ++i) {
        const StatedPathMode& mode = report.pathModes[i];
        if (mode.mode == PathMode::machine) continue;
        text << "\n  corners  from line " << mode.line << " as the program says: "
             << (mode.mode == PathMode::exactStop   ? "exact stop after every block"
                 : mode.mode == PathMode::exactPath ? "exact path, stops at corners"
                 : mode.tolerance > 0.0             ? "blended within " + formatFixed(mode.tolerance, 3) + " mm"
                                                    : std::string("blended without limit"));
    }
    for (std::size_t i = 0; i < report.findings.size() && i < 20; ++i) text << "\n  " << textOf(report.findings[i]);
    if (report.findings.size() > 20) text << "\n  and " << report.findings.size() - 20 << " more";
    std::set<FindingKind> told;
    for (const Finding& finding : report.findings)
        if (told.insert(finding.kind).second)
            text << "\n  remedy   " << idOf(finding.kind) << ": " << remedyOf(finding.kind).text;
    for (std::size_t i = 0; i < report.warnings.size() && i < 20; ++i)
        text << "\n  warning  " << textOf(report.warnings[i]);
    if (report.warnings.size() > 20) text << "\n  and " << report.warnings.size() - 20 << " more warnings";
    for (std::size_t i = 0; i < report.nearPasses.size() && i < 20; ++i) {
        const NearPass& pass = report.nearPasses[i];
        text << "\n  warning  line " << pass.line << ": " << idOf(pass) << " " << formatFixed(pass.distance, 3)
             << " mm at (" << formatFixed(pass.place.x, 3) << ", " << formatFixed(pass.place.y, 3) << ", "
             << formatFixed(pass.place.z, 3) << ") mm";
        if (pass.lines > 1)
            text << "; " << pass.lines << " lines within " << formatShortest(nearPlace) << " mm of there";
    }
    if (report.nearPasses.size() > 20)
        text << "\n  and " << report.nearPasses.size() - 20 << " more places with warnings";
    return text.str() + linesOf(program.lint);
}

} // namespace burin

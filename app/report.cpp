// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/report.h"

#include "app/assembly_report.h"
#include "core/cad/file_unit.h"
#include "core/machine/machine_library.h"
#include "core/verify/findings.h"
#include "core/verify/report_json.h"
#include "ui/panels/embedding_labels.h"
#include "ui/panels/fixture_labels.h"

#include <array>
#include <cmath>
#include <map>

namespace burin {

using nlohmann::json;

namespace {

/// Each colour that single faces have, with the number of triangles in it.
json faceColoursOf(const Body& body) {
    std::map<std::array<std::uint8_t, 3>, std::uint64_t> triangles;
    for (const ColouredTriangles& part : body.faceColours) triangles[part.colour] += part.count;
    json colours = json::array();
    for (const auto& [colour, count] : triangles) colours.push_back({{"colour", colour}, {"triangles", count}});
    return colours;
}

} // namespace

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
        entry["face_colours"] = faceColoursOf(body);
        bodies.push_back(std::move(entry));
    }
    json healing = json::array(), warnings = json::array(), leftOut = json::array();
    for (const ImportNote& note : model.notes)
        (note.kind == ImportNote::Kind::warning   ? warnings
         : note.kind == ImportNote::Kind::leftOut ? leftOut
                                                  : healing)
            .push_back(note.text);
    return {
        {"file", model.sourceFile},
        {"format", model.format},
        {"unit", model.lengthUnit},
        {"unit_scale_mm", model.unitScale},
        {"stated_unit_scale_mm", model.statedUnit > 0.0 ? json(model.statedUnit) : json(nullptr)},
        {"size_in_stated_unit_mm", unitReplaced(model) ? jsonOf(sizeInUnit(model, model.statedUnit)) : json(nullptr)},
        {"mesh_chord_mm", model.meshChord},
        {"volume_mm3", model.volume()},
        {"bounding_box_mm", jsonOf(model.box())},
        {"bodies", bodies},
        {"assemblies", jsonOfAssemblies(model)},
        {"healing", healing},
        {"left_out", leftOut},
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
            {"take", part.source},
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
                        {"take", entry.source},
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
        for (const glm::dvec3& place : report.inserted) entry["inserted_mm"].push_back(jsonOf(place));
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

json jsonOf(const std::vector<BadFit>& fixtures) {
    json list = json::array();
    for (const auto& [name, fit] : fixtures)
        list.push_back({{"name", name},
                        {"in_stock_mm", fit.depth},
                        {"gap_mm", std::isinf(fit.gap) ? json(nullptr) : json(fit.gap)},
                        {"text", fitText(name, fit, LengthUnit::millimetre).toStdString()}});
    return list;
}

std::vector<std::string> doubtsOf(const Model& model, const EmbeddedSetup& embedded) {
    std::vector<std::string> doubts;
    for (const ImportNote& note : model.notes)
        if (note.kind == ImportNote::Kind::warning) doubts.push_back(note.text);
    for (const EmbeddingFinding& finding : embedded.findings)
        doubts.push_back(embeddingText(finding, LengthUnit::millimetre).toStdString());
    return doubts;
}

} // namespace burin

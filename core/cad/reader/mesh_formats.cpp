// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/base/zip_archive.h"
#include "core/cad/import_notes.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/file_text.h"
#include "core/cad/reader/ply_head.h"
#include "core/cad/reader/scene_file.h"
#include "core/cad/reader/text_lines.h"
#include "core/cad/reader/unit_note.h"

#include <pugixml.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

// Triangle formats that assimp reads: OBJ, PLY and OFF state no unit, 3MF and AMF do.
namespace burin {

namespace {

/// Errors: fileDamaged (place: the byte).
Result<void> parse(std::string_view text, pugi::xml_document& xml) {
    const pugi::xml_parse_result parsed = xml.load_buffer(text.data(), text.size());
    if (parsed) return {};
    return Error{ErrorCode::fileDamaged, {}, "byte " + std::to_string(parsed.offset), parsed.description()};
}

/// assimp names an object of a 3MF file only by its number: "Object_7".
void nameObjects(const pugi::xml_node& model, std::vector<MeshSolid>& solids) {
    for (const pugi::xml_node& object : model.child("resources").children("object")) {
        const std::string name = object.attribute("name").value();
        const std::string byNumber = std::string("Object_") + object.attribute("id").value();
        for (MeshSolid& solid : solids)
            if (!name.empty() && solid.name == byNumber) solid.name = name;
    }
}

struct Unit {
    std::string_view name, shown;
    double millimetres;
};
/// From the 3MF core specification 1.3, 3.4, and ISO/ASTM 52915 (AMF), 5.1.
constexpr std::array units{Unit{"micron", "micron", 1e-3}, Unit{"micrometer", "micron", 1e-3},
                           Unit{"millimeter", "mm", 1.0},  Unit{"centimeter", "cm", 10.0},
                           Unit{"inch", "inch", 25.4},     Unit{"foot", "foot", 304.8},
                           Unit{"feet", "foot", 304.8},    Unit{"meter", "m", 1000.0}};

/// Sets the unit that the file states, or the default of the format if it states none, unless the request has another.
Result<void> takeUnit(Model& model, const std::string& name, const ReadRequest& request) {
    for (const Unit& unit : units) {
        if (unit.name != (name.empty() ? "millimeter" : name)) continue;
        model.lengthUnit = unit.shown;
        setUnit(model, unit.millimetres, true, request.unitInstead);
        return {};
    }
    return Error{ErrorCode::fileDamaged, {}, "unit \"" + name + "\"", {}};
}

Result<Model> withScene(Model model, std::string_view content, const char* format) {
    Result<std::vector<MeshSolid>> solids = readScene(content, format);
    if (!solids) return std::move(solids).error();
    return withBodies(std::move(model), std::move(*solids));
}

Result<Model> unitless(ModelSource& source, const char* title, const char* format) {
    Model model;
    model.format = title;
    takeUnit(model, source.request.fileUnit);
    return withScene(std::move(model), source.content, format);
}

constexpr std::size_t headSize = 65536;

} // namespace

FormatMatch matchFormat(ThreeMfFormat, std::string_view content) {
    return {isArchiveWith(content, ".model"), {}};
}

Result<Model> readFormat(ThreeMfFormat, ModelSource& source) {
    const std::optional<std::string> xml = unzippedFile(source.content, ".model");
    if (!xml) return Error{ErrorCode::fileDamaged, {}, "the archive can't be unpacked", {}};
    pugi::xml_document document;
    if (Result<void> parsed = parse(*xml, document); !parsed) return std::move(parsed).error();
    const pugi::xml_node root = document.child("model");
    Model model;
    model.format = "3MF";
    if (Result<void> taken = takeUnit(model, root.attribute("unit").value(), source.request); !taken)
        return std::move(taken).error();
    Result<std::vector<MeshSolid>> solids = readScene(source.content, "3mf");
    if (!solids) return std::move(solids).error();
    nameObjects(root, *solids);
    return withBodies(std::move(model), std::move(*solids));
}

FormatMatch matchFormat(AmfFormat, std::string_view content) {
    const std::string_view head = content.substr(0, headSize);
    return {isArchiveWith(content, ".amf") ||
                (file_text::withoutLeadingSpace(head).starts_with('<') && file_text::contains(head, "<amf")),
            {}};
}

Result<Model> readFormat(AmfFormat, ModelSource& source) {
    std::string content = source.content;
    if (isArchiveWith(source.content, ".amf")) {
        std::optional<std::string> xml = unzippedFile(source.content, ".amf");
        if (!xml) return Error{ErrorCode::fileDamaged, {}, "the archive can't be unpacked", {}};
        content = std::move(*xml);
    }
    pugi::xml_document document;
    if (Result<void> parsed = parse(content, document); !parsed) return std::move(parsed).error();
    Model model;
    model.format = "AMF";
    if (Result<void> taken = takeUnit(model, document.child("amf").attribute("unit").value(), source.request); !taken)
        return std::move(taken).error();
    return withScene(std::move(model), content, "amf");
}

FormatMatch matchFormat(PlyFormat, std::string_view content) {
    if (!content.starts_with("ply\n") && !content.starts_with("ply\r")) return {};
    return {true, missingOfPly(content)};
}

Result<Model> readFormat(PlyFormat, ModelSource& source) {
    return unitless(source, "PLY", "ply");
}

FormatMatch matchFormat(OffFormat, std::string_view content) {
    TextLines lines(content.substr(0, headSize));
    const std::string_view head = trimmed(lines.next().value_or(std::string_view()));
    for (const std::string_view name : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"})
        if (head == name || (head.starts_with(name) && file_text::isSpace(head[name.size()]))) return {true, {}};
    return {};
}

/// A file that ends in the middle of its faces would otherwise be read up to that point.
std::string missingOfOff(std::string_view content) {
    TextLines lines(content);
    const auto nextLine = [&]() -> std::string_view {
        auto line = lines.next();
        while (line && (trimmed(*line).empty() || trimmed(*line).starts_with('#'))) line = lines.next();
        return line ? trimmed(*line) : std::string_view();
    };
    std::string_view counts = firstWord(nextLine()).second;
    if (counts.empty()) counts = nextLine();
    const auto [places, behind] = firstWord(counts);
    const std::optional<double> vertices = parseNumber(places), faces = parseNumber(firstWord(behind).first);
    if (!vertices || !faces || *vertices < 0.0 || *faces < 0.0) return "the counts of places and faces";
    double rows = 0.0;
    while (rows < *vertices + *faces && !nextLine().empty()) ++rows;
    if (rows >= *vertices + *faces) return {};
    return formatShortest(rows) + " of " + formatShortest(*vertices + *faces) + " lines of places and faces";
}

Result<Model> readFormat(OffFormat, ModelSource& source) {
    if (std::string missing = missingOfOff(source.content); !missing.empty())
        return Error{ErrorCode::fileDamaged, {}, std::move(missing), {}};
    return unitless(source, "OFF", "off");
}

/// Lines of an OBJ file begin with words that no other text of a model has; it has at least one vertex and one face.
FormatMatch matchFormat(ObjFormat, std::string_view content) {
    if (content.substr(0, headSize).find('\0') != std::string_view::npos) return {};
    constexpr std::array<std::string_view, 18> known{"v",      "vn",  "vt",   "vp",   "f",      "l",
                                                     "p",      "o",   "g",    "s",    "mtllib", "usemtl",
                                                     "cstype", "deg", "curv", "surf", "parm",   "end"};
    bool place = false, face = false;
    TextLines lines(content);
    for (auto line = lines.next(); line && !(place && face); line = lines.next()) {
        const std::string_view word = firstWord(*line).first;
        if (word.empty() || word.starts_with('#')) continue;
        if (std::ranges::find(known, word) == known.end()) return {};
        place = place || word == "v";
        face = face || word == "f";
    }
    return {place && face, {}};
}

Result<Model> readFormat(ObjFormat, ModelSource& source) {
    Result<Model> model = unitless(source, "OBJ", "obj");
    TextLines lines(std::string_view(source.content).substr(0, headSize));
    for (auto line = lines.next(); model && line; line = lines.next())
        if (const auto [word, file] = firstWord(*line); word == "mtllib")
            addNote(*model, ImportNote::Kind::warning,
                    import_notes::fill(import_notes::coloursLeftOut, {std::string(file)}));
    return model;
}

} // namespace burin

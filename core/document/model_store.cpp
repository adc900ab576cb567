// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/base/compression.h"
#include "core/base/numbers.h"
#include "core/cad/file_unit.h"
#include "core/document/json_placement.h"
#include "core/document/mesh_blob.h"
#include "core/document/stores.h"

#include <array>
#include <utility>

namespace burin {

namespace {

using NoteName = std::pair<ImportNote::Kind, std::string_view>;
constexpr std::array<NoteName, 4> noteNames{
    NoteName{ImportNote::Kind::unit, "unit"}, NoteName{ImportNote::Kind::healing, "healing"},
    NoteName{ImportNote::Kind::warning, "warning"}, NoteName{ImportNote::Kind::leftOut, "left_out"}};

std::string_view nameOf(ImportNote::Kind kind) {
    for (const auto& [value, name] : noteNames)
        if (value == kind) return name;
    return "warning";
}

ImportNote::Kind kindOf(std::string_view text) {
    for (const auto& [value, name] : noteNames)
        if (name == text) return value;
    return ImportNote::Kind::warning;
}

/// The unit that the file states, with its length if another one is used: "inch (25.4 mm)".
std::string unitText(const Model& model) {
    if (!unitReplaced(model)) return model.lengthUnit;
    return model.lengthUnit + " (" + formatShortest(model.statedUnit) + " mm)";
}

void readUnit(std::string_view text, double scale, Model& model) {
    model.unitScale = scale;
    model.lengthUnit = cleanLine(text);
    model.statedUnit = model.lengthUnit == "none" ? 0.0 : scale;
    constexpr std::string_view before = " (", after = " mm)";
    const std::size_t begin = text.rfind(before);
    if (begin == std::string_view::npos || !text.ends_with(after)) return;
    text.remove_suffix(after.size());
    const std::optional<double> stated = parseNumber(text.substr(begin + before.size()));
    if (!stated || !(*stated > 0.0)) return;
    model.lengthUnit = cleanLine(text.substr(0, begin));
    model.statedUnit = *stated;
}

std::optional<std::int64_t> packed(const BodyColour& colour) {
    if (!colour) return std::nullopt;
    return std::int64_t{(*colour)[0]} << 16 | std::int64_t{(*colour)[1]} << 8 | std::int64_t{(*colour)[2]};
}

std::array<std::uint8_t, 3> unpacked(std::int64_t colour) {
    return {static_cast<std::uint8_t>(colour >> 16 & 0xff), static_cast<std::uint8_t>(colour >> 8 & 0xff),
            static_cast<std::uint8_t>(colour & 0xff)};
}

Result<void> storeBodies(Database& database, const std::vector<Body>& bodies) {
    std::int64_t position = 0;
    for (const Body& body : bodies) {
        const std::string box = encodeBox(body.box), mesh = encodeMesh(body.mesh) + encodeFaceColours(body.faceColours);
        if (Result<void> done = run(database, "INSERT INTO body VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)", position++,
                                    body.name, packed(body.colour), body.volume, body.area, BlobView{box},
                                    BlobView{mesh}, body.openEdges, body.faceCount);
            !done)
            return done;
    }
    return {};
}

Result<void> storeNotes(Database& database, const std::vector<ImportNote>& notes) {
    std::int64_t position = 0;
    for (const ImportNote& note : notes)
        if (Result<void> done =
                run(database, "INSERT INTO import_note VALUES(?, ?, ?)", position++, nameOf(note.kind), note.text);
            !done)
            return done;
    return {};
}

Result<void> loadBodies(Database& database, std::vector<Body>& bodies) {
    MeshesTogether together;
    Result<Statement> rows =
        Statement::prepare(database, "SELECT name, colour, volume, area, box, mesh, open_edges, face_count FROM body "
                                     "ORDER BY position");
    if (!rows) return std::move(rows).error();
    return forEachRow(*rows, [&]() -> Result<void> {
        Body body;
        body.name = cleanLine(rows->text(0));
        if (!rows->isNull(1)) body.colour = unpacked(rows->integer(1));
        body.volume = rows->real(2);
        body.area = rows->real(3);
        const std::optional<Box> box = decodeBox(rows->blob(4));
        std::optional<TriangleMesh> mesh = decodeMesh(rows->blob(5));
        if (!box || !mesh || !together.add(*mesh, rows->blob(5).size())) return damaged(database, "body " + body.name);
        std::optional<FaceColours> colours = decodeFaceColours(rows->blob(5), mesh->triangles.size());
        if (!colours) return damaged(database, "body " + body.name);
        body.box = *box;
        body.mesh = std::move(*mesh);
        body.faceColours = std::move(*colours);
        body.openEdges = static_cast<std::size_t>(rows->integer(6));
        body.faceCount = static_cast<std::size_t>(rows->integer(7));
        bodies.push_back(std::move(body));
        return {};
    });
}

Result<void> loadNotes(Database& database, std::vector<ImportNote>& notes) {
    Result<Statement> rows = Statement::prepare(database, "SELECT kind, text FROM import_note ORDER BY position");
    if (!rows) return std::move(rows).error();
    return forEachRow(*rows, [&]() -> Result<void> {
        notes.push_back({kindOf(rows->text(0)), cleanLine(rows->text(1))});
        return {};
    });
}

Result<Model> loadHead(Database& database) {
    Result<Statement> row = Statement::prepare(
        database, "SELECT source_file, format, length_unit, unit_scale, mesh_chord, brep, brep_placement FROM model");
    if (!row) return std::move(row).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return Error{ErrorCode::projectIncomplete, "model", "burin embed", database.subject()};
    Model model;
    model.sourceFile = cleanLine(row->text(0));
    model.format = cleanLine(row->text(1));
    readUnit(row->text(2), row->real(3), model);
    model.meshChord = row->real(4);
    std::optional<std::string> brep = decompress(row->blob(5), mostUnpacked(row->blob(5).size()));
    if (!brep) return damaged(database, "model");
    model.brep = std::move(*brep);
    if (const std::string_view text = row->text(6); !text.empty()) try {
            model.brepPlacement = placementOf(nlohmann::json::parse(text));
        } catch (const nlohmann::json::exception&) {
            return damaged(database, "model");
        }
    return model;
}

} // namespace

Error damaged(const Database& database, std::string part) {
    return {ErrorCode::fileDamaged, database.subject(), std::move(part), {}};
}

Result<void> storeModel(Database& database, const Model& model) {
    for (const char* table : {"DELETE FROM model", "DELETE FROM body", "DELETE FROM import_note"})
        if (Result<void> done = database.execute(table); !done) return done;
    const std::string brep = compress(model.brep);
    if (Result<void> done = run(database, "INSERT INTO model VALUES(1, ?, ?, ?, ?, ?, ?, ?)", model.sourceFile,
                                model.format, unitText(model), model.unitScale, model.meshChord, BlobView{brep},
                                isNone(model.brepPlacement) ? std::string() : jsonOf(model.brepPlacement).dump());
        !done)
        return done;
    if (Result<void> done = storeBodies(database, model.bodies); !done) return done;
    return storeNotes(database, model.notes);
}

Result<void> storeColours(Database& database, const std::vector<BodyColour>& colours) {
    std::int64_t position = 0;
    for (const BodyColour& colour : colours)
        if (Result<void> done =
                run(database, "UPDATE body SET colour = ? WHERE position = ?", packed(colour), position++);
            !done)
            return done;
    return {};
}

Result<Model> loadModel(Database& database) {
    Result<Model> model = loadHead(database);
    if (!model) return model;
    if (Result<void> done = loadBodies(database, model->bodies); !done) return std::move(done).error();
    if (Result<void> done = loadNotes(database, model->notes); !done) return std::move(done).error();
    return model;
}

} // namespace burin

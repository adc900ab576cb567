// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/mesh_blob.h"
#include "core/document/stores.h"
#include "core/document/surroundings_record.h"

#include "core/geometry/pose.h"

#include <utility>

namespace burin {

namespace {

/// Rows of `setup_setting`.
constexpr std::string_view axisMode = "axis_mode", travelPlacement = "travel", programTarget = "target",
                           programDraft = "program_draft", keptProgram = "kept_program";
/// Rows of `milling_setting`, for the whole job.
constexpr std::string_view guideButton = "guide_step_button", left = "left_at";

std::optional<BlobView> unlessEmpty(const std::string& blob) {
    return blob.empty() ? std::nullopt : std::optional(BlobView{blob});
}

Result<void> storeSetting(Database& database, std::string_view name, const std::string& text) {
    return run(database,
               "INSERT INTO milling_setting VALUES(?, ?) ON CONFLICT(name) DO UPDATE SET json = excluded.json", name,
               text);
}

Result<void> storeSetting(Database& database, SetupId setup, std::string_view name, const std::string& text) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    return run(database,
               "INSERT INTO setup_setting VALUES(?, ?, ?) "
               "ON CONFLICT(setup, name) DO UPDATE SET json = excluded.json",
               numberOf(setup), name, text);
}

/// Returns the text in the row of a bound statement; empty if it was never stored.
Result<std::optional<std::string>> textOf(Statement& row) {
    const Result<bool> found = row.step();
    if (!found) return found.error();
    if (!*found) return std::optional<std::string>();
    return std::optional(std::string(row.text(0)));
}

Result<std::optional<std::string>> loadSetting(Database& database, std::string_view name) {
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM milling_setting WHERE name = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(name); !bound) return std::move(bound).error();
    return textOf(*row);
}

Result<std::optional<std::string>> loadSetting(Database& database, SetupId setup, std::string_view name) {
    if (Result<void> known = requireSetup(database, setup); !known) return std::move(known).error();
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM setup_setting WHERE setup = ? AND name = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(setup), name); !bound) return std::move(bound).error();
    return textOf(*row);
}

/// Returns an empty text if it was never stored.
Result<std::string> loadText(Database& database, std::string_view name) {
    Result<std::optional<std::string>> text = loadSetting(database, name);
    if (!text) return std::move(text).error();
    return std::move(*text).value_or(std::string());
}

/// @param text as returned by loadSetting. @param read parses the JSON; returns nothing if it is damaged
template <class Value, class Read>
Result<Value> settingAs(Database& database, std::string_view name, const Result<std::optional<std::string>>& text,
                        Read read) {
    if (!text) return text.error();
    if (!*text) return Value{};
    std::optional<Value> value = read(**text);
    if (!value) return damaged(database, std::string(name));
    return std::move(*value);
}
template <class Value, class Read>
Result<Value> loadSettingAs(Database& database, std::string_view name, Read read) {
    return settingAs<Value>(database, name, loadSetting(database, name), read);
}
template <class Value, class Read>
Result<Value> loadSettingAs(Database& database, SetupId setup, std::string_view name, Read read) {
    return settingAs<Value>(database, name, loadSetting(database, setup, name), read);
}

/// Includes numbers that are not used for its kind.
bool allFinite(const Guide& guide) {
    return isFinite(guide.point) && isFinite(guide.direction) && std::isfinite(guide.distance) &&
           std::isfinite(guide.lead) && std::isfinite(guide.tilt);
}

std::optional<std::uint32_t> buttonFromJson(const std::string& text) {
    std::uint32_t button = 0;
    for (const char digit : text) {
        if (digit < '0' || digit > '9') return std::nullopt;
        button = 10 * button + static_cast<std::uint32_t>(digit - '0');
    }
    return button;
}

} // namespace

Result<void> storeObstacles(Database& database, SetupId setup, const std::vector<Obstacle>& obstacles) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    if (Result<void> done = run(database, "DELETE FROM obstacle WHERE setup = ?", numberOf(setup)); !done) return done;
    std::int64_t position = 0;
    for (const Obstacle& obstacle : obstacles) {
        if (Result<void> usable = checkObstacle(obstacle); !usable) return usable;
        const RecordWithBlob record = recordOf(obstacle);
        if (Result<void> done = run(database, "INSERT INTO obstacle VALUES(?, ?, ?, ?)", numberOf(setup), position++,
                                    record.json, unlessEmpty(record.blob));
            !done)
            return done;
    }
    return {};
}

Result<std::vector<Obstacle>> loadObstacles(Database& database, SetupId setup) {
    if (Result<void> known = requireSetup(database, setup); !known) return std::move(known).error();
    Result<Statement> rows =
        Statement::prepare(database, "SELECT json, mesh FROM obstacle WHERE setup = ? ORDER BY position");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    std::vector<Obstacle> obstacles;
    MeshesTogether together;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        std::optional<Obstacle> obstacle = obstacleFrom(rows->text(0), rows->blob(1));
        const auto* mesh = obstacle ? std::get_if<TriangleMesh>(&obstacle->shape) : nullptr;
        if (!obstacle || (mesh != nullptr && !together.add(*mesh, rows->blob(1).size())))
            return damaged(database, "obstacle " + std::to_string(obstacles.size() + 1));
        obstacles.push_back(std::move(*obstacle));
        return {};
    });
    if (!read) return std::move(read).error();
    return obstacles;
}

Result<void> storeAxisMode(Database& database, SetupId setup, const AxisMode& axis) {
    if (!(std::abs(glm::length(axis.direction) - 1.0) < 1e-6))
        return Error{ErrorCode::argumentInvalid, "axis", {}, "a vector of unit length"};
    return storeSetting(database, setup, axisMode, toJson(axis));
}

Result<AxisMode> loadAxisMode(Database& database, SetupId setup) {
    return loadSettingAs<AxisMode>(database, setup, axisMode, axisModeFromJson);
}

Result<void> storeTravelPlacement(Database& database, SetupId setup, const TravelPlacement& placement) {
    if (placement.zero && !isFinite(*placement.zero))
        return Error{ErrorCode::argumentInvalid, "travel", {}, "finite lengths"};
    return storeSetting(database, setup, travelPlacement, toJson(placement));
}

Result<TravelPlacement> loadTravelPlacement(Database& database, SetupId setup) {
    return loadSettingAs<TravelPlacement>(database, setup, travelPlacement, travelPlacementFromJson);
}

Result<void> storeProgramTarget(Database& database, SetupId setup, const ProgramTarget& target) {
    return storeSetting(database, setup, programTarget, toJson(target));
}

Result<void> storeProgramDraft(Database& database, SetupId setup, const std::string& text) {
    return storeSetting(database, setup, programDraft, programDraftToJson(text));
}
Result<void> storeLeftAt(Database& database, const std::string& json) {
    return storeSetting(database, left, json);
}
Result<std::string> loadLeftAt(Database& database) {
    return loadText(database, left);
}
Result<void> storeKeptProgram(Database& database, SetupId setup, const std::string& json) {
    return storeSetting(database, setup, keptProgram, json);
}
Result<std::string> loadKeptProgram(Database& database, SetupId setup) {
    Result<std::optional<std::string>> text = loadSetting(database, setup, keptProgram);
    if (!text) return std::move(text).error();
    return std::move(*text).value_or(std::string());
}
Result<std::string> loadProgramDraft(Database& database, SetupId setup) {
    return loadSettingAs<std::string>(database, setup, programDraft, programDraftFromJson);
}

Result<ProgramTarget> loadProgramTarget(Database& database, SetupId setup) {
    return loadSettingAs<ProgramTarget>(database, setup, programTarget, programTargetFromJson);
}

Result<void> storeGuides(Database& database, SetupId setup, const KeptGuides& kept) {
    if (kept.guides.size() > GuideSettings::capacity)
        return Error{ErrorCode::argumentInvalid, "guides", std::to_string(kept.guides.size()),
                     "0 to " + std::to_string(GuideSettings::capacity)};
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    if (Result<void> done = run(database, "DELETE FROM guide WHERE setup = ?", numberOf(setup)); !done) return done;
    std::int64_t position = 0;
    for (const Guide& guide : kept.guides) {
        if (Result<void> usable = checkGuide(guide); !usable) return usable;
        if (!allFinite(guide)) return Error{ErrorCode::argumentInvalid, "guide", {}, "finite numbers"};
        const RecordWithBlob record = recordOf(guide);
        if (Result<void> done = run(database, "INSERT INTO guide VALUES(?, ?, ?, ?)", numberOf(setup), position++,
                                    record.json, unlessEmpty(record.blob));
            !done)
            return done;
    }
    return storeSetting(database, guideButton, std::to_string(kept.stepButton));
}

Result<KeptGuides> loadGuides(Database& database, SetupId setup) {
    if (Result<void> known = requireSetup(database, setup); !known) return std::move(known).error();
    Result<Statement> rows =
        Statement::prepare(database, "SELECT json, curve FROM guide WHERE setup = ? ORDER BY position");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    KeptGuides kept;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        std::optional<GuideCurve> curve;
        std::optional<Guide> guide = guideFrom(rows->text(0), rows->blob(1), curve);
        if (!guide || kept.guides.size() == GuideSettings::capacity)
            return damaged(database, "guide " + std::to_string(kept.guides.size() + 1));
        if (curve) {
            kept.curves.push_back(std::make_shared<const GuideCurve>(std::move(*curve)));
            guide->curve = kept.curves.back().get();
        }
        kept.guides.push_back(*guide);
        return {};
    });
    if (!read) return std::move(read).error();
    const Result<std::uint32_t> button = loadSettingAs<std::uint32_t>(database, guideButton, buttonFromJson);
    if (!button) return button.error();
    kept.stepButton = *button;
    return kept;
}

} // namespace burin

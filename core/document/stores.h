// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/database.h"
#include "core/document/project.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// The functions that store and load the parts of a project as tables. A store runs within the transaction of its
/// caller and counts no change. Errors of reading: fileDamaged with the part as place, projectIncomplete; of writing:
/// those of Database.
namespace burin {

// model_store.cpp
Result<void> storeModel(Database& database, const Model& model);
Result<void> storeColours(Database& database, const std::vector<BodyColour>& colours); ///< of the bodies, in order
Result<Model> loadModel(Database& database);

// setup_store.cpp
/// Errors of all functions that take a setup's id: nameUnknown.
Result<SetupId> storeNewSetup(Database& database, const std::string& name);
Result<std::vector<SetupName>> loadSetups(Database& database);
Result<void> requireSetup(Database& database, SetupId id);
Result<void> storeSetup(Database& database, SetupId id, const Setup& setup); ///< argumentInvalid: not finite
Result<Setup> loadSetup(Database& database, SetupId id);
Result<Placement> loadPlacement(Database& database, SetupId id); ///< identity if nothing is embedded yet
Result<void> renameSetup(Database& database, SetupId id, const std::string& name);
Result<void> eraseSetup(Database& database, SetupId id); ///< argumentInvalid: something depends on it
/// @param id the setup of the materials; those used by other setups stay
Result<void> storeMaterials(Database& database, SetupId id, const std::vector<Property>& materials);
Result<std::vector<Property>> loadMaterials(Database& database);
Result<void> storeTool(Database& database, const Tool& tool);
Result<std::vector<Tool>> loadTools(Database& database);

// surroundings_store.cpp
Result<void> storeObstacles(Database& database, SetupId setup,
                            const std::vector<Obstacle>& obstacles); ///< those of checkObstacle
Result<std::vector<Obstacle>> loadObstacles(Database& database, SetupId setup);
Result<void> storeAxisMode(Database& database, SetupId setup,
                           const AxisMode& axis); ///< argumentInvalid: no unit length
Result<AxisMode> loadAxisMode(Database& database, SetupId setup);
Result<void> storeTravelPlacement(Database& database, SetupId setup,
                                  const TravelPlacement& placement); ///< argumentInvalid
Result<TravelPlacement> loadTravelPlacement(Database& database, SetupId setup);
Result<void> storeProgramTarget(Database& database, SetupId setup, const ProgramTarget& target);
Result<ProgramTarget> loadProgramTarget(Database& database, SetupId setup);
Result<void> storeLeftAt(Database& database, const std::string& json);
Result<std::string> loadLeftAt(Database& database);
Result<void> storeKeptProgram(Database& database, SetupId setup, const std::string& json);
Result<std::string> loadKeptProgram(Database& database, SetupId setup);
Result<void> storeProgramDraft(Database& database, SetupId setup, const std::string& text);
Result<std::string> loadProgramDraft(Database& database, SetupId setup);
Result<void> storeGuides(Database& database, SetupId setup,
                         const KeptGuides& kept); ///< those of checkGuide, argumentInvalid
Result<KeptGuides> loadGuides(Database& database, SetupId setup);

// take_store.cpp
Result<std::int64_t> storeTake(Database& database, const TakeInfo& info);
Result<std::vector<TakeInfo>> loadTakes(Database& database);
Result<Take> loadTake(Database& database, std::int64_t id);
Result<TakeOutline> loadTakeOutline(Database& database, std::int64_t id);
Result<void> visitSamples(Database& database, std::int64_t id, const SampleVisitor& visit);
Result<Sample> loadSample(Database& database, std::int64_t take, std::uint64_t index);
Result<void> eraseTake(Database& database, std::int64_t id);
Result<void> storeUndone(Database& database, std::int64_t take, const SampleRange& interval);
Result<void> eraseUndone(Database& database, std::int64_t take, const SampleRange& interval);
/// Returns the intervals within the first `samples` samples.
Result<std::vector<SampleRange>> loadTakenBack(Database& database, std::int64_t take, std::uint64_t samples);
Result<std::vector<SampleRange>> loadSwitchedOff(Database& database, std::int64_t take, std::uint64_t samples);
Result<void> storeSwitchedOff(Database& database, std::int64_t take, std::span<const SampleRange> off);
Result<void> hideTake(Database& database, std::int64_t id);
Result<void> showTake(Database& database, std::int64_t id);
/// SQL for the number of samples of `take`: where its last chunk ends, as chunks follow each other without a gap.
/// Counting all of them would read every page of a recording.
inline constexpr std::string_view sampleCountOfTake =
    "COALESCE((SELECT first + count FROM sample_chunk WHERE take = take.id ORDER BY first DESC LIMIT 1), 0)";
Result<void> eraseHiddenTakes(Database& database, std::optional<SetupId> setup = std::nullopt); ///< empty: of all
                                                                                                ///< setups
Result<void> storeMarkers(Database& database, SetupId setup, std::span<const TimeMarker> markers);
Result<std::vector<TimeMarker>> loadMarkers(Database& database, SetupId setup);
Result<void> renameTake(Database& database, std::int64_t take, const std::string& name);

// take_order_store.cpp
/// Returns the order of all takes of a setup, including removed ones.
Result<TakeOrder> loadTakeOrder(Database& database, SetupId setup);
/// Takes that `wanted` does not contain follow. Errors: nameUnknown (not a take of the setup), argumentInvalid (a take
/// occurs twice).
Result<void> storeTakeOrder(Database& database, SetupId setup, const TakeOrder& wanted);
/// Returns the first take in the chain of originals of a copy, even if that is removed or erased; 0: not a copy.
Result<std::int64_t> loadOriginal(Database& database, SetupId setup, std::int64_t take);
/// Removes a take that is erased from the order, and from the chains of originals: its copies become copies of its own
/// original. If it has none, they remain copies of it. A damaged row stays as it is, so that a project can be opened.
Result<void> forgetTake(Database& database, SetupId setup, std::int64_t take);
/// Returns the id of the copy. Errors: those of loadTakeOutline.
Result<std::int64_t> copyTake(Database& database, std::int64_t id);

// kept_store.cpp
Result<RecordedState> loadRecordedState(Database& database, SetupId setup);
/// Nothing is stored if the setup's state differs from `madeIn`.
Result<void> storeKept(Database& database, SetupId setup, const KeptWorkpiece& kept, const RecordedState& madeIn);
/// Those that are still valid, in order.
Result<std::vector<TakeMoment>> loadKeptMoments(Database& database, SetupId setup);
Result<KeptWorkpiece> loadKept(Database& database, SetupId setup, const TakeMoment& at);
Result<void> eraseKeptFrom(Database& database, std::int64_t take); ///< of this take and all takes recorded later

// generated_store.cpp
/// Stores new generated moves of a setup; returns their id. Errors: those of checkGenerated, nameUnknown (the setup).
Result<std::int64_t> storeGenerated(Database& database, const GeneratedMoves& moves, SetupId setup);
Result<std::vector<GeneratedInfo>> loadGenerated(Database& database);
Result<GeneratedMoves> loadGeneratedMoves(Database& database, std::int64_t id);
Result<void> eraseGenerated(Database& database, std::int64_t id);

// path_store.cpp
/// Errors: argumentInvalid (a path uses it).
Result<void> requireUnused(Database& database, PathSource source);
Result<std::int64_t> storePath(Database& database, const StoredPath& path); ///< as a new one; returns its id
Result<void> replacePath(Database& database, const StoredPath& path);
Result<void> erasePath(Database& database, std::int64_t id);
Result<void> restorePath(Database& database, const StoredPath& path); ///< with its id, as before it was erased
Result<std::vector<StoredPath>> loadPaths(Database& database);
Result<void> storeProgram(Database& database, const StoredProgram& program);
Result<std::vector<StoredProgram>> loadPrograms(Database& database);

/// A fault of the content: `part` can't be read.
Error damaged(const Database& database, std::string part);
/// Calls `read` for each row. Stops at the first error, of the statement or of `read`.
template <class Read>
Result<void> forEachRow(Statement& statement, Read read) {
    for (;;) {
        Result<bool> row = statement.step();
        if (!row) return std::move(row).error();
        if (!*row) return {};
        if (Result<void> done = read(); !done) return done;
    }
}

} // namespace burin

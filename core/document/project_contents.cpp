// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/document_state.h"
#include "core/document/project_impl.h"
#include "core/document/stores.h"

#include <utility>
#include <vector>

namespace burin {

namespace {

/// Returns the records of a list that belong to a setup.
template <class Record>
Result<std::vector<Record>> ofSetup(Result<std::vector<Record>> records, SetupId setup) {
    if (records) std::erase_if(*records, [setup](const Record& record) { return record.setup != setup; });
    return records;
}

StoredPath withSetup(StoredPath path, SetupId setup) {
    path.setup = setup;
    return path;
}

} // namespace

Result<void> Project::setModel(const Model& model) {
    return impl_->change([&](Database& database) { return storeModel(database, model); });
}
Result<void> Project::setBodyColours(const std::vector<BodyColour>& colours) {
    return impl_->change([&](Database& database) { return storeColours(database, colours); });
}
Result<Model> Project::model() const {
    return impl_->read(loadModel);
}
Result<std::shared_ptr<const Model>> Project::placedModel(SetupId id) const {
    using Shared = std::shared_ptr<const Model>;
    return impl_->read([id = impl_->meant(id)](Database& database) -> Result<Shared> {
        Result<Model> model = loadModel(database);
        if (!model) return std::move(model).error();
        const Result<Placement> placement = loadPlacement(database, id);
        if (!placement) return placement.error();
        return placed(std::make_shared<const Model>(std::move(*model)), *placement);
    });
}

Result<std::vector<SetupName>> Project::setups() const {
    return impl_->read(loadSetups);
}
Result<SetupId> Project::addSetup(const std::string& name) {
    return impl_->change([&](Database& database) { return storeNewSetup(database, name); });
}
Result<void> Project::nameSetup(SetupId id, const std::string& name) {
    return impl_->change([&, id = impl_->meant(id)](Database& database) { return renameSetup(database, id, name); });
}
Result<void> Project::removeSetup(SetupId id) {
    if (impl_->meant(id) == impl_->used)
        return Error{ErrorCode::argumentInvalid, "setup", std::to_string(numberOf(impl_->used)),
                     "a setup that is not in use"};
    return impl_->change([id](Database& database) { return eraseSetup(database, id); });
}
Result<void> Project::useSetup(SetupId id) {
    const SetupId wanted = impl_->meant(id);
    Result<void> known = impl_->read([wanted](Database& database) { return requireSetup(database, wanted); });
    if (known) impl_->used = wanted;
    return known;
}
SetupId Project::usedSetup() const noexcept {
    return impl_->used;
}
Result<void> Project::setSetup(const Setup& setup, SetupId id) {
    return impl_->change([&, id = impl_->meant(id)](Database& database) { return storeSetup(database, id, setup); });
}
Result<Setup> Project::setup(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadSetup(database, id); });
}

Result<void> Project::setMaterials(const std::vector<Property>& materials) {
    return impl_->change([&](Database& database) { return storeMaterials(database, impl_->used, materials); });
}
Result<std::vector<Property>> Project::materials() const {
    return impl_->read(loadMaterials);
}

Result<void> Project::setTool(const Tool& tool) {
    return impl_->change([&](Database& database) { return storeTool(database, tool); });
}
Result<std::vector<Tool>> Project::tools() const {
    return impl_->read(loadTools);
}

Result<void> Project::setObstacles(const std::vector<Obstacle>& obstacles, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeObstacles(database, id, obstacles); });
}
Result<std::vector<Obstacle>> Project::obstacles(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadObstacles(database, id); });
}

Result<void> Project::setAxisMode(const AxisMode& axis, SetupId id) {
    return impl_->change([&, id = impl_->meant(id)](Database& database) { return storeAxisMode(database, id, axis); });
}
Result<AxisMode> Project::axisMode(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadAxisMode(database, id); });
}

Result<void> Project::setTravelPlacement(const TravelPlacement& placement, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeTravelPlacement(database, id, placement); });
}
Result<TravelPlacement> Project::travelPlacement(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadTravelPlacement(database, id); });
}

Result<void> Project::setProgramTarget(const ProgramTarget& target, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeProgramTarget(database, id, target); });
}
Result<ProgramTarget> Project::programTarget(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadProgramTarget(database, id); });
}

Result<void> Project::setProgramDraft(const std::string& text, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeProgramDraft(database, id, text); });
}
Result<std::string> Project::programDraft(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadProgramDraft(database, id); });
}

Result<void> Project::setLeftAt(const std::string& json) {
    return impl_->note([&](Database& database) { return storeLeftAt(database, json); });
}
Result<std::string> Project::leftAt() const {
    return impl_->read(loadLeftAt);
}

Result<void> Project::setKeptProgram(const std::string& json, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeKeptProgram(database, id, json); });
}
Result<std::string> Project::keptProgram(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadKeptProgram(database, id); });
}

Result<std::int64_t> Project::jobDigest(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return burin::jobDigest(database, id); });
}

Result<void> Project::setGuides(const KeptGuides& guides, SetupId id) {
    return impl_->change([&, id = impl_->meant(id)](Database& database) { return storeGuides(database, id, guides); });
}
Result<KeptGuides> Project::guides(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadGuides(database, id); });
}

Result<std::vector<TakeInfo>> Project::takes(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return ofSetup(loadTakes(database), id); });
}

Result<TakeOrder> Project::takeOrder(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadTakeOrder(database, id); });
}
Result<void> Project::setTakeOrder(const TakeOrder& order, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeTakeOrder(database, id, order); });
}

Result<void> Project::setMarkers(std::span<const TimeMarker> markers, SetupId id) {
    return impl_->change(
        [&, id = impl_->meant(id)](Database& database) { return storeMarkers(database, id, markers); });
}
Result<std::vector<TimeMarker>> Project::markers(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadMarkers(database, id); });
}

Result<RecordedState> Project::recordedState(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadRecordedState(database, id); });
}
Result<void> Project::keepWorkpiece(const KeptWorkpiece& kept, const RecordedState& madeIn, SetupId id) {
    return impl_->note(
        [&, id = impl_->meant(id)](Database& database) { return storeKept(database, id, kept, madeIn); });
}
Result<std::vector<TakeMoment>> Project::keptMoments(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return loadKeptMoments(database, id); });
}
Result<KeptWorkpiece> Project::keptWorkpiece(const TakeMoment& at, SetupId id) const {
    return impl_->read([&, id = impl_->meant(id)](Database& database) { return loadKept(database, id, at); });
}

Result<std::vector<GeneratedInfo>> Project::generated(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return ofSetup(loadGenerated(database), id); });
}

Result<GeneratedMoves> Project::generatedMoves(std::int64_t id) const {
    return impl_->read([id](Database& database) { return loadGeneratedMoves(database, id); });
}

Result<std::int64_t> Project::addGenerated(const GeneratedMoves& moves) {
    const SetupId setup = impl_->meant(moves.info.setup);
    return impl_->change([&](Database& database) { return storeGenerated(database, moves, setup); });
}

Result<void> Project::removeGenerated(std::int64_t id) {
    return impl_->change([id](Database& database) { return eraseGenerated(database, id); });
}

Result<std::int64_t> Project::addPath(const StoredPath& path) {
    return impl_->change([&, meant = withSetup(path, impl_->meant(path.setup))](Database& database) {
        return storePath(database, meant);
    });
}
Result<void> Project::setPath(const StoredPath& path) {
    return impl_->change([&, meant = withSetup(path, impl_->meant(path.setup))](Database& database) {
        return replacePath(database, meant);
    });
}
Result<void> Project::removePath(std::int64_t id) {
    return impl_->change([&](Database& database) { return erasePath(database, id); });
}
Result<void> Project::restorePath(const StoredPath& path) {
    return impl_->change([&, meant = withSetup(path, impl_->meant(path.setup))](Database& database) {
        return burin::restorePath(database, meant);
    });
}
Result<std::vector<StoredPath>> Project::paths(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return ofSetup(loadPaths(database), id); });
}

Result<void> Project::addProgram(const StoredProgram& program) {
    StoredProgram meant = program;
    meant.setup = impl_->meant(program.setup);
    return impl_->change([&](Database& database) { return storeProgram(database, meant); });
}
Result<std::vector<StoredProgram>> Project::programs(SetupId id) const {
    return impl_->read([id = impl_->meant(id)](Database& database) { return ofSetup(loadPrograms(database), id); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/document_state.h"
#include "core/document/project_impl.h"
#include "core/document/stores.h"

namespace burin {

Result<std::vector<SetupName>> Project::setups() const {
    return impl_->read(loadSetups);
}
Result<SetupId> Project::addSetup(const std::string& name) {
    return impl_->change([&](Database& database) { return storeNewSetup(database, name); });
}
Result<void> Project::setSetup(const Setup& setup, SetupId id) {
    return impl_->change([&](Database& database) { return storeSetup(database, id, setup); });
}
Result<Setup> Project::setup(SetupId id) const {
    return impl_->read([id](Database& database) { return loadSetup(database, id); });
}

Result<void> Project::setMaterials(const std::vector<Property>& materials) {
    return impl_->change([&](Database& database) { return storeMaterials(database, materials); });
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
    return impl_->change([&](Database& database) { return storeObstacles(database, id, obstacles); });
}
Result<std::vector<Obstacle>> Project::obstacles(SetupId id) const {
    return impl_->read([id](Database& database) { return loadObstacles(database, id); });
}

Result<void> Project::setAxisMode(const AxisMode& axis, SetupId id) {
    return impl_->change([&](Database& database) { return storeAxisMode(database, id, axis); });
}
Result<AxisMode> Project::axisMode(SetupId id) const {
    return impl_->read([id](Database& database) { return loadAxisMode(database, id); });
}

Result<void> Project::setTravelPlacement(const TravelPlacement& placement, SetupId id) {
    return impl_->change([&](Database& database) { return storeTravelPlacement(database, id, placement); });
}
Result<TravelPlacement> Project::travelPlacement(SetupId id) const {
    return impl_->read([id](Database& database) { return loadTravelPlacement(database, id); });
}

Result<void> Project::setProgramTarget(const ProgramTarget& target, SetupId id) {
    return impl_->change([&](Database& database) { return storeProgramTarget(database, id, target); });
}
Result<ProgramTarget> Project::programTarget(SetupId id) const {
    return impl_->read([id](Database& database) { return loadProgramTarget(database, id); });
}

Result<void> Project::setProgramDraft(const std::string& text) {
    return impl_->change([&](Database& database) { return storeProgramDraft(database, text); });
}
Result<std::string> Project::programDraft() const {
    return impl_->read(loadProgramDraft);
}

Result<void> Project::setLeftAt(const std::string& json) {
    return impl_->note([&](Database& database) { return storeLeftAt(database, json); });
}
Result<std::string> Project::leftAt() const {
    return impl_->read(loadLeftAt);
}

Result<void> Project::setKeptProgram(const std::string& json) {
    return impl_->change([&](Database& database) { return storeKeptProgram(database, json); });
}
Result<std::string> Project::keptProgram() const {
    return impl_->read(loadKeptProgram);
}

Result<std::int64_t> Project::jobDigest() const {
    return impl_->read(burin::jobDigest);
}

Result<void> Project::setGuides(const KeptGuides& guides, SetupId id) {
    return impl_->change([&](Database& database) { return storeGuides(database, id, guides); });
}
Result<KeptGuides> Project::guides(SetupId id) const {
    return impl_->read([id](Database& database) { return loadGuides(database, id); });
}

Result<std::vector<GeneratedInfo>> Project::generated() const {
    return impl_->read(loadGenerated);
}

Result<GeneratedMoves> Project::generatedMoves(std::int64_t id) const {
    return impl_->read([id](Database& database) { return loadGeneratedMoves(database, id); });
}

Result<std::int64_t> Project::addGenerated(const GeneratedMoves& moves) {
    return impl_->change([&](Database& database) { return storeGenerated(database, moves); });
}

Result<void> Project::removeGenerated(std::int64_t id) {
    return impl_->change([id](Database& database) { return eraseGenerated(database, id); });
}

Result<std::int64_t> Project::addPath(const StoredPath& path) {
    return impl_->change([&](Database& database) { return storePath(database, path); });
}
Result<void> Project::setPath(const StoredPath& path) {
    return impl_->change([&](Database& database) { return replacePath(database, path); });
}
Result<void> Project::removePath(std::int64_t id) {
    return impl_->change([&](Database& database) { return erasePath(database, id); });
}
Result<void> Project::restorePath(const StoredPath& path) {
    return impl_->change([&](Database& database) { return burin::restorePath(database, path); });
}
Result<std::vector<StoredPath>> Project::paths() const {
    return impl_->read(loadPaths);
}

Result<void> Project::addProgram(const StoredProgram& program) {
    return impl_->change([&](Database& database) { return storeProgram(database, program); });
}
Result<std::vector<StoredProgram>> Project::programs() const {
    return impl_->read(loadPrograms);
}

} // namespace burin

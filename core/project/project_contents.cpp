// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/document_state.h"
#include "core/project/project_impl.h"
#include "core/project/stores.h"

namespace burin {

Result<void> Project::setSetup(const Setup& setup) {
    return impl_->change([&](Database& database) { return storeSetup(database, setup); });
}
Result<Setup> Project::setup() const {
    return impl_->read(loadSetup);
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

Result<void> Project::setObstacles(const std::vector<Obstacle>& obstacles) {
    return impl_->change([&](Database& database) { return storeObstacles(database, obstacles); });
}
Result<std::vector<Obstacle>> Project::obstacles() const {
    return impl_->read(loadObstacles);
}

Result<void> Project::setAxisMode(const AxisMode& axis) {
    return impl_->change([&](Database& database) { return storeAxisMode(database, axis); });
}
Result<AxisMode> Project::axisMode() const {
    return impl_->read(loadAxisMode);
}

Result<void> Project::setTravelPlacement(const TravelPlacement& placement) {
    return impl_->change([&](Database& database) { return storeTravelPlacement(database, placement); });
}
Result<TravelPlacement> Project::travelPlacement() const {
    return impl_->read(loadTravelPlacement);
}

Result<void> Project::setProgramTarget(const ProgramTarget& target) {
    return impl_->change([&](Database& database) { return storeProgramTarget(database, target); });
}
Result<ProgramTarget> Project::programTarget() const {
    return impl_->read(loadProgramTarget);
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

Result<void> Project::setGuides(const KeptGuides& guides) {
    return impl_->change([&](Database& database) { return storeGuides(database, guides); });
}
Result<KeptGuides> Project::guides() const {
    return impl_->read(loadGuides);
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// Copies everything except the bodies (notes, the path of the file): messages name it.
Model withoutBodies(const Model& model) {
    Model other;
    other.sourceFile = model.sourceFile;
    other.format = model.format;
    other.lengthUnit = model.lengthUnit;
    other.unitScale = model.unitScale;
    other.statedUnit = model.statedUnit;
    other.meshChord = model.meshChord;
    other.brepPlacement = model.brepPlacement;
    return other;
}

template <class Judge>
Model bodiesOf(const Model& model, const Setup& setup, Judge wanted) {
    Model chosen = withoutBodies(model);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (!wanted(roleOf(setup, i))) continue;
        chosen.bodies.push_back(model.bodies[i]);
        chosen.brepSolids.push_back(model.brepSolids.empty() ? static_cast<std::uint32_t>(i) : model.brepSolids[i]);
    }
    if (!chosen.bodies.empty()) chosen.brep = model.brep;
    return chosen;
}

} // namespace

BodyRole roleOf(const Setup& setup, std::size_t body) noexcept {
    return body < setup.roles.size() ? setup.roles[body] : BodyRole::part;
}

std::string nameOf(const Model& model, std::size_t body) {
    const std::string& name = model.bodies[body].name;
    return name.empty() ? "Body " + std::to_string(body + 1) : name;
}

std::vector<std::string> materialsUsed(const Setup& setup) {
    std::vector<std::string> ids;
    if (setup.form != StockForm::file) ids.push_back(setup.stockMaterial);
    const auto add = [&](const std::string& id) {
        if (!id.empty() && std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
    };
    for (const std::string& id : setup.bodyMaterials) add(id);
    for (const MaterialRegion& region : setup.regions) add(region.material);
    return ids;
}

std::vector<MaterialAmount> materialAmounts(const EmbeddedSetup& embedded) {
    return amountsOf(embedded.workpiece.properties(), embedded.untouched, embedded.workpiece.grid().unitVolume());
}

std::shared_ptr<const Model> protectedPart(std::shared_ptr<const Model> model, const Setup& setup) {
    const bool whole = std::ranges::all_of(setup.roles, isProtected);
    return whole ? std::move(model) : std::make_shared<const Model>(bodiesOf(*model, setup, isProtected));
}

Result<std::vector<Obstacle>> bodyFixtures(const Model& model, const Setup& setup) {
    const auto isFixture = [](BodyRole role) { return role == BodyRole::fixture; };
    if (std::ranges::none_of(setup.roles, isFixture)) return std::vector<Obstacle>{};
    std::vector<Obstacle> fixtures;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        if (!isFixture(roleOf(setup, i))) continue;
        Model one = withoutBodies(model);
        one.bodies.push_back(model.bodies[i]);
        Result<std::vector<Obstacle>> fixture = fixturesOf(one, nameOf(model, i), 0.0);
        if (!fixture) return fixture;
        fixtures.insert(fixtures.end(), fixture->begin(), fixture->end());
    }
    return fixtures;
}

} // namespace burin

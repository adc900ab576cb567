// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/part_update.h"

#include "core/cad/body_path.h"
#include "core/cad/file_unit.h"
#include "core/setup/setup.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// The body of the old part that each body of the new part replaces; empty: the body is new.
using Lineage = std::vector<std::optional<std::size_t>>;

using BodyKey = std::function<std::string(std::string_view path)>;

/// Pairs bodies that have no partner yet and whose keys are equal, in their order. Bodies with an empty key stay alone.
void pairBodies(const Model& before, const Model& after, const BodyKey& keyBefore, const BodyKey& keyAfter,
                std::vector<bool>& replaced, Lineage& lineage) {
    std::multimap<std::string, std::size_t> waiting; // equal keys keep their order
    for (std::size_t i = 0; i < before.bodies.size(); ++i)
        if (!replaced[i]) waiting.emplace(keyBefore(before.bodies[i].name), i);
    for (std::size_t i = 0; i < after.bodies.size(); ++i) {
        if (lineage[i]) continue;
        const std::string own = keyAfter(after.bodies[i].name);
        const auto same = waiting.lower_bound(own);
        if (own.empty() || same == waiting.end() || same->first != own) continue;
        lineage[i] = same->second;
        replaced[same->second] = true;
        waiting.erase(same);
    }
}

std::string wholePath(std::string_view path) {
    return std::string(path);
}

/// Without the assembly of the first level, whose name some CAD systems give a version number.
std::string pathBelowRoot(std::string_view path) {
    const std::string_view assembly = assemblyOf(path);
    const std::size_t root = assembly.empty() ? std::string_view::npos : path.find('/');
    return root == std::string_view::npos ? std::string() : std::string(path.substr(root + 1));
}

std::string ownName(std::string_view path) {
    return std::string(withoutInstance(lastElement(path)));
}

Lineage lineageOf(const Model& before, const Model& after) {
    Lineage lineage(after.bodies.size());
    std::vector<bool> replaced(before.bodies.size(), false);
    // Earlier versions of Burin knew no assemblies: a body had its own name alone, in which '/' was a letter.
    for (const auto& [keyBefore, keyAfter] :
         {std::pair<BodyKey, BodyKey>{wholePath, wholePath}, std::pair<BodyKey, BodyKey>{pathBelowRoot, pathBelowRoot},
          std::pair<BodyKey, BodyKey>{pathElement, ownName}, std::pair<BodyKey, BodyKey>{ownName, ownName}})
        pairBodies(before, after, keyBefore, keyAfter, replaced, lineage);
    const bool renamed = before.bodies.size() == 1 && after.bodies.size() == 1;
    if (renamed) lineage.front() = 0;
    return lineage;
}

bool isSameShape(const Body& a, const Body& b) {
    return a.mesh.vertices == b.mesh.vertices && a.mesh.triangles == b.mesh.triangles;
}

PartUpdate compared(const Model& before, const Model& after, const Lineage& lineage) {
    PartUpdate update;
    std::vector<bool> stays(before.bodies.size(), false);
    for (std::size_t i = 0; i < after.bodies.size(); ++i) {
        const std::string name = nameOf(after, i);
        if (!lineage[i])
            update.added.push_back(name);
        else if (!isSameShape(before.bodies[*lineage[i]], after.bodies[i]))
            update.changed.push_back(name);
        if (lineage[i]) stays[*lineage[i]] = true;
    }
    for (std::size_t i = 0; i < before.bodies.size(); ++i)
        if (!stays[i]) update.removed.push_back(nameOf(before, i));
    return update;
}

Model coloured(Model model, const Model& before, const Lineage& lineage) {
    for (std::size_t i = 0; i < lineage.size(); ++i)
        if (!model.bodies[i].colour && lineage[i]) model.bodies[i].colour = before.bodies[*lineage[i]].colour;
    return model;
}

/// Moves roles and materials to the new indices of their bodies.
void carry(Setup& setup, const Lineage& lineage) {
    const Setup before = setup;
    setup.roles.clear();
    setup.bodyMaterials.clear();
    for (const std::optional<std::size_t>& from : lineage) {
        setup.roles.push_back(from ? roleOf(before, *from) : BodyRole::part);
        setup.bodyMaterials.push_back(from && *from < before.bodyMaterials.size() ? before.bodyMaterials[*from]
                                                                                  : std::string());
    }
}

/// Whether the setup was milled, so that stock and zero stay. Errors: fileDamaged.
Result<bool> isMilled(const Project& project, SetupId id) {
    const Result<std::vector<TakeInfo>> takes = project.takes(id);
    if (!takes) return takes.error();
    const Result<std::vector<GeneratedInfo>> generated = project.generated(id);
    if (!generated) return generated.error();
    return !takes->empty() || !generated->empty();
}

/// Returns a setup with the new part. Errors: projectIncomplete (nothing is embedded in it yet).
Result<Setup> updatedSetup(const Project& project, SetupId id, const std::shared_ptr<const Model>& after,
                           const Lineage& lineage, PartUpdate& update) {
    Result<Setup> setup = project.setup(id);
    if (!setup) return setup;
    const Result<bool> milled = isMilled(project, id);
    if (!milled) return milled.error();
    carry(*setup, lineage);
    if (*milled && (setup->form == StockForm::box || setup->form == StockForm::cylinder)) setup->stated = true;
    const glm::dvec3 zero = setup->workOffset;
    Result<Setup> complete = placeStock(*placed(after, setup->placement), std::move(*setup));
    if (!complete || !*milled) return complete;
    update.stockStays = true;
    if (complete->workOffset != zero) { // it referred to the part
        complete->zero.on = ZeroReference::point;
        complete->zero.point = complete->workOffset = zero;
    }
    return complete;
}

} // namespace

Result<PartUpdate> updatePart(Project& project, const Model& model) {
    const Result<Model> before = project.model();
    if (!before) return before.error();
    const Lineage lineage = lineageOf(*before, model);
    const std::shared_ptr<const Model> after =
        placed(std::make_shared<const Model>(coloured(model, *before, lineage)), placementAsBefore(model, *before));
    PartUpdate update = compared(*before, *after, lineage);
    const Result<std::vector<SetupName>> setups = project.setups();
    if (!setups) return setups.error();
    std::vector<std::pair<SetupId, Setup>> updated; // nothing is changed before all of them are valid
    for (const SetupName& name : *setups) {
        Result<Setup> setup = updatedSetup(project, name.id, after, lineage, update);
        if (!setup && setup.error().code == ErrorCode::projectIncomplete) continue;
        if (!setup) return std::move(setup).error();
        updated.emplace_back(name.id, std::move(*setup));
    }
    if (Result<void> stored = project.setModel(*after); !stored) return stored.error();
    for (const auto& [id, setup] : updated)
        if (Result<void> stored = project.setSetup(setup, id); !stored) return stored.error();
    return update;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup_materials.h"

#include "core/setup/material_change.h"
#include "core/volume/runs/property_entry.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

const Property* ofStock(const StockVolume& volume, const std::string& id) {
    for (int i = 1; i < volume.materials().size(); ++i)
        if (const Property& material = volume.materials()[static_cast<PropertyIndex>(i)]; material.id == id)
            return &material;
    return nullptr;
}

/// Searches the project's materials first, then those of a stock from a file, then the library.
Result<Property> materialOf(const std::string& id, const std::vector<Property>& known, const StockVolume* volume) {
    const auto found = std::ranges::find(known, id, &Property::id);
    if (found != known.end()) return *found;
    const Property* own = volume ? ofStock(*volume, id) : nullptr;
    return own ? Result<Property>(*own) : loadMaterial(id);
}

/// Adds a property. Ids of a property list are unique; bodies with the same name are numbered.
Result<PropertyIndex> addNumbered(PropertyList& list, Property property) {
    const std::string id = property.id;
    for (int number = 2; entryOf(list, property.id); ++number) property.id = id + " " + std::to_string(number);
    return list.add(std::move(property));
}

/// Adds the entries of a setup one after the other.
class MaterialGatherer {
public:
    MaterialGatherer(const Setup& setup, const std::vector<Property>& known)
        : setup_(setup), known_(known), volume_(setup.form == StockForm::file ? setup.volume.get() : nullptr) {}

    Result<void> addStock() {
        if (volume_) return addVolume();
        const Result<PropertyIndex> index = milled(setup_.stockMaterial);
        if (!index) return index.error();
        materials_.stock = *index;
        return {};
    }

    Result<void> addBody(const Model& model, std::size_t body) {
        const BodyRole role = roleOf(setup_, body);
        Result<PropertyIndex> index = airProperty;
        if (isProtected(role)) index = guarded(model, body);
        if (role == BodyRole::insert) index = milled(materialOfBody(body));
        if (!index) return index.error();
        materials_.bodies.push_back(*index);
        return {};
    }

    Result<void> addRegion(const MaterialRegion& region) {
        const Result<PropertyIndex> index = region.grade ? graded(region) : milled(region.material);
        if (!index) return index.error();
        if (!region.grade) materials_.graded.emplace_back();
        materials_.regions.push_back(*index);
        return {};
    }

    SetupMaterials take() { return std::move(materials_); }

private:
    /// Adds the materials of a stock from a file. Unused materials are left out, except the base material of a used
    /// grade.
    Result<void> addVolume() {
        const PropertyList& list = volume_->materials();
        std::array<bool, 256> used{};
        for (int i = 1; i < list.size(); ++i) {
            const auto index = static_cast<PropertyIndex>(i);
            if (volume_->amounts().units[index] > 0) used[index] = used[list.baseOf(index)] = true;
        }
        for (int i = 1; i < list.size(); ++i) {
            const auto index = static_cast<PropertyIndex>(i);
            if (!used[index]) continue;
            Result<Property> material = machinable(list[index].id);
            if (!material) return material.error();
            const Result<PropertyIndex> added = materials_.list.add(*std::move(material));
            if (!added) return added.error();
            materials_.volume[index] = *added;
        }
        materials_.stock = materials_.volume[volume_->mainMaterial()];
        return {};
    }

    std::string materialOfBody(std::size_t body) const {
        const bool own = body < setup_.bodyMaterials.size() && !setup_.bodyMaterials[body].empty();
        return own ? setup_.bodyMaterials[body] : setup_.stockMaterial;
    }

    /// Returns a material that can be milled. It must produce a cutting force: without one it would be cut like air.
    Result<Property> machinable(const std::string& id) const {
        Result<Property> material = materialOf(id, known_, volume_);
        if (!material) return material;
        if (!(material->valueOr(specificCuttingEnergy, 0.0) > 0.0) && !(material->valueOr(kienzleForce, 0.0) > 0.0))
            return Error{ErrorCode::resourceInvalid, id, std::string(specificCuttingEnergy),
                         "a material that is milled needs a value above 0"};
        material->machinability = Machinability::machinable;
        return material;
    }

    Result<PropertyIndex> milled(const std::string& id) {
        if (const auto standing = entryOf(materials_.list, id)) return *standing;
        Result<Property> material = machinable(id);
        if (!material) return material.error();
        return materials_.list.add(*std::move(material));
    }

    Result<PropertyIndex> guarded(const Model& model, std::size_t body) {
        Result<Property> material = materialOf(materialOfBody(body), known_, volume_);
        if (!material) return material.error();
        material->machinability = Machinability::isProtected;
        material->id += " (" + nameOf(model, body) + ")";
        material->name += " (" + nameOf(model, body) + ")";
        if (model.bodies[body].colour) material->colour = *model.bodies[body].colour;
        return addNumbered(materials_.list, *std::move(material));
    }

    Result<PropertyIndex> graded(const MaterialRegion& region) {
        Result<Property> material = machinable(region.material);
        if (!material) return material.error();
        material->id += " (" + region.name + ")";
        material->name += " (" + region.name + ")";
        if (region.grade->value == specificCuttingEnergy) { // Kienzle's law would override it
            material->values.erase(std::string(kienzleForce));
            material->values.erase(std::string(kienzleExponent));
        }
        const Result<PropertyIndex> base = addNumbered(materials_.list, *std::move(material));
        if (!base) return base;
        Result<Grading> grading = gradingOf(region, setup_.stock, setup_.voxel);
        if (!grading) return grading.error();
        Result<GradedMaterial> grades =
            addGrades(materials_.list, *base, region.grade->value, *std::move(grading), region.grade->entries);
        if (!grades) return grades.error();
        materials_.graded.emplace_back(*std::move(grades));
        return base;
    }

    const Setup& setup_;
    const std::vector<Property>& known_;
    const StockVolume* volume_;
    SetupMaterials materials_;
};

} // namespace

Result<SetupMaterials> setupMaterials(const Model& model, const Setup& setup, const std::vector<Property>& known) {
    MaterialGatherer gatherer(setup, known);
    if (Result<void> added = gatherer.addStock(); !added) return std::move(added).error();
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (Result<void> added = gatherer.addBody(model, i); !added) return std::move(added).error();
    for (const MaterialRegion& region : setup.regions)
        if (Result<void> added = gatherer.addRegion(region); !added) return std::move(added).error();
    return gatherer.take();
}

Result<PropertyList> propertyListOf(const Model& model, const Setup& setup, const std::vector<Property>& materials) {
    Result<SetupMaterials> gathered = setupMaterials(model, setup, materials);
    if (!gathered) return std::move(gathered).error();
    return std::move(gathered->list);
}

std::vector<std::string> idsOf(const PropertyList& list) {
    std::vector<std::string> ids;
    for (int i = 0; i < list.size(); ++i) ids.push_back(list[static_cast<PropertyIndex>(i)].id);
    return ids;
}

} // namespace burin

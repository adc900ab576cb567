// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_file.h"

#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/cutting/material_card.h"
#include "core/cutting/material_library.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace burin {

namespace {

/// A unit as FreeCAD writes it, and its size in Burin's unit.
struct CardUnit {
    std::string_view text;
    double size;
};
constexpr std::array speedUnits{CardUnit{"m/min", 1.0}, CardUnit{"mm/min", 1e-3},   CardUnit{"m/s", 60.0},
                                CardUnit{"mm/s", 0.06}, CardUnit{"ft/min", 0.3048}, CardUnit{"sfm", 0.3048}};
constexpr std::array pressureUnits{CardUnit{"N/mm^2", 1.0}, CardUnit{"MPa", 1.0}, CardUnit{"kPa", 1e-3},
                                   CardUnit{"Pa", 1e-6},    CardUnit{"GPa", 1e3}, CardUnit{"N/m^2", 1e-6}};
constexpr std::array densityUnits{CardUnit{"kg/m^3", 1e-3}, CardUnit{"g/cm^3", 1.0}, CardUnit{"kg/mm^3", 1e6},
                                  CardUnit{"kg/dm^3", 1.0}};
constexpr std::array plainUnits{CardUnit{"", 1.0}};

/// Values that milling needs and a card may lack, as conservative estimates.
struct Filling {
    std::string_view name, unit;
    double value;
};
constexpr std::array fillings{Filling{radialForceRatio, "1", 0.4}, Filling{chipLoadPerDiameter, "1", 0.003},
                              Filling{plungeFeedRatio, "1", 0.3}, Filling{surfaceSpeed, "m/min", 50.0}};

constexpr std::string_view fillingSource = "not in the FreeCAD material card; a careful estimate";

class CardReader {
public:
    CardReader(MaterialCard card, std::string origin) : card_(std::move(card)), origin_(std::move(origin)) {}

    Result<ReadMaterial> read(const std::string& id) {
        if (Result<void> named = readName(id); !named) return std::move(named).error();
        if (Result<void> values = readValues(); !values) return std::move(values).error();
        fill();
        if (Result<void> sound = checkMaterial(result_.material, origin_); !sound) return std::move(sound).error();
        result_.format = "FreeCAD";
        return std::move(result_);
    }

private:
    Error wrong(std::string_view key, std::string why) const {
        return {ErrorCode::resourceInvalid, origin_, std::string(key), std::move(why)};
    }

    const std::string* text(std::string_view key) const {
        const auto found = card_.values.find(key);
        return found == card_.values.end() ? nullptr : &found->second;
    }

    Result<void> readName(const std::string& id) {
        const std::string* name = text("Name");
        if (name == nullptr || name->empty()) return wrong("Name", "has to be there");
        result_.material.name = *name;
        result_.material.id = id.empty() ? resourceIdFrom(*name) : id;
        result_.material.colour = {150, 150, 150};
        return {};
    }

    /// Reads a number followed by a unit. A number without unit is in the first one.
    template <std::size_t count>
    Result<void> readValue(std::string_view key, const std::array<CardUnit, count>& units, std::string_view name,
                           std::string_view unit, bool estimate = false) {
        const std::string* written = text(key);
        if (written == nullptr || written->empty()) return {};
        const NumberWithUnit quantity = numberWithUnit(*written);
        if (!quantity.value) return wrong(key, "is no number: " + *written);
        const auto found = std::ranges::find(units, quantity.unit, &CardUnit::text);
        if (found == units.end() && !quantity.unit.empty())
            return wrong(key, "is in a unit that is not known: " + quantity.unit);
        const double size = found == units.end() ? units.front().size : found->size;
        set(name, *quantity.value * size, unit, std::string(key), estimate);
        return {};
    }

    void set(std::string_view name, double value, std::string_view unit, const std::string& key, bool estimate) {
        std::string source = "FreeCAD material card";
        if (const std::string* author = text("Author"); author != nullptr) source += " (" + *author + ")";
        result_.material.values[std::string(name)] = {value, std::string(unit), source + ", " + key, estimate};
    }

    Result<void> readValues() {
        // The speed of carbide has precedence; if there is none, that of high speed steel is used.
        for (Result<void> done : {readValue("SurfaceSpeedHSS", speedUnits, "surface_speed_hss", "m/min"),
                                  readValue("SurfaceSpeedHSS", speedUnits, surfaceSpeed, "m/min"),
                                  readValue("SurfaceSpeedCarbide", speedUnits, surfaceSpeed, "m/min"),
                                  readValue("UnitCuttingForce", pressureUnits, kienzleForce, "N/mm^2"),
                                  readValue("ChipThicknessExponent", plainUnits, kienzleExponent, "1"),
                                  readValue("Density", densityUnits, density, "g/cm^3"), readHardness(), readPower()})
            if (!done) return done;
        addEnergy();
        return {};
    }

    Result<void> readHardness() {
        const std::string* written = text("Hardness");
        if (written == nullptr) return {};
        const NumberWithUnit quantity = numberWithUnit(*written);
        if (!quantity.value) return {}; // "soft": words, on which no value depends
        const std::string* units = text("HardnessUnits");
        set("hardness", *quantity.value, units != nullptr && !units->empty() ? *units : "1", "Hardness", false);
        return {};
    }

    /// Older cards: power per removal rate, in kW min per cm³ or J per mm³; their stated unit, a volume per time, can't
    /// be intended.
    Result<void> readPower() {
        const std::string* written = text("Kp");
        if (written == nullptr || text("UnitCuttingForce") != nullptr) return {};
        const NumberWithUnit quantity = numberWithUnit(*written);
        if (!quantity.value) return wrong("Kp", "is no number: " + *written);
        set(specificCuttingEnergy, *quantity.value, "J/mm^3", "Kp, read as J/mm^3", true);
        result_.notes.push_back("Kp = " + *written + " was read as a specific cutting energy in J/mm^3.");
        return {};
    }

    /// Adds the specific cutting energy at a chip of 0.05 mm, for the force that is felt.
    void addEnergy() {
        const Property& material = result_.material;
        if (!material.values.contains(kienzleForce) || !material.values.contains(kienzleExponent)) return;
        constexpr double chip = 0.05, perJoule = 1000.0;
        const double energy =
            material.valueOr(kienzleForce, 0.0) * std::pow(chip, -material.valueOr(kienzleExponent, 0.0)) / perJoule;
        set(specificCuttingEnergy, energy, "J/mm^3", "UnitCuttingForce and ChipThicknessExponent at a chip of 0.05 mm",
            false);
    }

    void fill() {
        for (const Filling& each : fillings) {
            if (result_.material.values.contains(each.name)) continue;
            NamedValue& filled = result_.material.values[std::string(each.name)];
            filled.value = each.value;
            filled.unit = each.unit;
            filled.source = fillingSource;
            filled.estimate = true;
            result_.notes.push_back("The card has no " + std::string(each.name) + ": an estimate was filled in.");
        }
        if (!result_.material.values.contains(density))
            result_.notes.emplace_back("The card has no density: no mass is known.");
    }

    MaterialCard card_;
    std::string origin_;
    ReadMaterial result_;
};

} // namespace

Result<ReadMaterial> materialFromText(std::string_view text, const std::string& origin, const std::string& id) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos) return Error{ErrorCode::fileEmpty, origin, {}, {}};
    if (text[first] == '{') {
        Result<Property> material = propertyFromJson(text, origin);
        if (!material) return std::move(material).error();
        if (!id.empty()) material->id = id;
        material->machinability = Machinability::machinable;
        material->base.clear();
        if (Result<void> sound = checkMaterial(*material, origin); !sound) return std::move(sound).error();
        return ReadMaterial{std::move(*material), "Burin", {}};
    }
    Result<MaterialCard> card = readMaterialCard(text, origin);
    if (!card) return std::move(card).error();
    return CardReader(std::move(*card), origin).read(id);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/base/staged_file.h"
#include "core/cutting/calibration.h"
#include "core/document/companions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <ctime>

namespace burin {

namespace {

using nlohmann::json;

struct CalibrateArguments {
    std::string forces, material, law = "edge", projection = "teeth", like;
    bool onWorkpiece = false, replace = false, dryRun = false;
};

/// A calibration with the material that it makes.
struct Calibrated {
    MaterialCalibration calibration;
    Property material;
    std::string file; ///< that it was written to; empty: none
};

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc);
    return text.data();
}

CalibrationOptions optionsOf(const CalibrateArguments& arguments) {
    CalibrationOptions options;
    options.law = arguments.law == "kienzle" ? ChipLaw::kienzle
                  : arguments.law == "edge"  ? ChipLaw::edge
                                             : ChipLaw::constant;
    options.projection = arguments.projection == "teeth" ? ForceProjection::turningTeeth : ForceProjection::feedAndAxis;
    options.forcesOnWorkpiece = arguments.onWorkpiece;
    return options;
}

/// In the order of the file, each once; only the one that is wanted.
Result<std::vector<std::string>> materialsOf(const std::vector<ForceRecord>& records, const std::string& wanted) {
    std::vector<std::string> materials;
    std::string known;
    for (const ForceRecord& record : records) {
        if (std::find(materials.begin(), materials.end(), record.material) != materials.end()) continue;
        materials.push_back(record.material);
        known += (known.empty() ? "" : ", ") + record.material;
    }
    if (wanted.empty()) return materials;
    if (std::find(materials.begin(), materials.end(), wanted) == materials.end())
        return Error{ErrorCode::nameUnknown, "material", wanted, known};
    return std::vector<std::string>{wanted};
}

/// What the calibrated material has beside K and Kr: the material of that id, or the one that it is said to be like.
/// @param written false: nobody will read those other values
Result<Property> basisOf(const std::string& id, const std::string& like, bool written) {
    if (like.empty()) {
        Result<Property> known = loadMaterial(id);
        if (known || known.error().code != ErrorCode::nameUnknown) return known;
        if (!written) return Property{};
        return Error{ErrorCode::argumentInvalid, "material", id, "a material that is known, or --like MATERIAL"};
    }
    Result<Property> model = loadMaterial(like);
    if (!model || like == id) return model;
    for (auto& [name, value] : model->values) {
        value.source = "taken over from " + like + ": " + value.source;
        value.estimate = true;
    }
    model->name = id;
    return model;
}

Result<Calibrated> calibrated(const std::vector<ForceRecord>& records, const std::string& id,
                              const CalibrateArguments& arguments) {
    Result<MaterialCalibration> calibration = calibrate(records, id, optionsOf(arguments), arguments.forces);
    if (!calibration) return calibration.error();
    const Result<Property> basis = basisOf(id, arguments.like, !arguments.dryRun);
    if (!basis) return basis.error();
    const std::string evidence = std::filesystem::path(arguments.forces).filename().string() + ", " + today();
    Property material = calibratedMaterial(*basis, *calibration, evidence);
    return Calibrated{std::move(*calibration), std::move(material), {}};
}

json jsonOf(const Confidence& confidence) {
    return {{"value", confidence.value}, {"low", confidence.low}, {"high", confidence.high}};
}

json jsonOf(const Calibrated& entry) {
    const MaterialCalibration& c = entry.calibration;
    json leftOut = json::array(), residuals = json::array();
    for (const LeftOut& record : c.leftOut) leftOut.push_back({{"line", record.line}, {"reason", record.reason}});
    for (const Residual& record : c.residuals)
        residuals.push_back({{"line", record.line}, {"tangential_n", record.tangential}, {"radial_n", record.radial}});
    json answer{{"material", c.material},
                {"records", c.records},
                {"records_used", c.residuals.size()},
                {"left_out", leftOut},
                {"residuals", residuals},
                {"tangential_noise_n", c.tangentialNoise},
                {"radial_noise_n", c.radialNoise},
                {"chip_thickness_mm", {c.chipLow, c.chipHigh}},
                {"specific_cutting_energy_j_mm3", jsonOf(c.specificEnergy)},
                {"specific_cutting_energy_at_chip_mm", c.chip},
                {"radial_force_ratio", jsonOf(c.radialRatio)},
                {"library_file", entry.file.empty() ? json(nullptr) : json(entry.file)}};
    if (c.options.law == ChipLaw::edge) {
        answer["tangential_edge_force_n_mm"] = jsonOf(c.edgeForce);
        answer["radial_edge_force_n_mm"] = jsonOf(c.radialEdgeForce);
    }
    if (c.options.law == ChipLaw::kienzle) {
        answer["kienzle_kc11_n_mm2"] = jsonOf(c.kienzleForce);
        answer["kienzle_mc"] = jsonOf(c.kienzleExponent);
    }
    return answer;
}

std::string textOf(const Calibrated& entry) {
    const MaterialCalibration& c = entry.calibration;
    std::string text = c.material + ": " + std::to_string(c.residuals.size()) + " of " + std::to_string(c.records) +
                       " records, noise " + formatFixed(c.tangentialNoise, 3) + " N tangential, " +
                       formatFixed(c.radialNoise, 3) + " N radial";
    text += "\n  K        " + textOf(c.specificEnergy) + " J/mm^3, chips of " + formatFixed(c.chip, 4) + " mm";
    if (c.options.law == ChipLaw::kienzle)
        text += "\n  kc1.1    " + textOf(c.kienzleForce) + " N/mm^2\n  mc       " + textOf(c.kienzleExponent);
    text += "\n  Kr       " + textOf(c.radialRatio);
    if (c.options.law == ChipLaw::edge)
        text += "\n  Kte      " + textOf(c.edgeForce) + " N/mm\n  Kre      " + textOf(c.radialEdgeForce) + " N/mm";
    for (const LeftOut& record : c.leftOut)
        text += "\n  line " + std::to_string(record.line) + " left out: " + record.reason;
    return text + "\n  " + (entry.file.empty() ? "not written (--dry-run)" : entry.file);
}

/// Writes the materials to the user's library, all or none, once all ids may be used.
Result<void> keepMaterials(std::vector<Calibrated>& materials, const CalibrateArguments& arguments) {
    for (Calibrated& entry : materials) {
        const Result<std::filesystem::path> file = userMaterialFile(entry.material.id, arguments.replace);
        if (!file) return file.error();
        const std::array<std::filesystem::path, 1> output{*file};
        if (Result<void> free = checkDistinct("FORCES", arguments.forces, output); !free) return free;
        if (Result<void> free = checkOutput("material", *file, {}); !free) return free;
        entry.file = file->string();
    }
    std::vector<StagedFile> files;
    for (const Calibrated& entry : materials) {
        const std::filesystem::path file = entry.file;
        std::error_code failed;
        std::filesystem::create_directories(file.parent_path(), failed);
        if (failed) return writeError(file, failed.value());
        Result<StagedFile> staged = StagedFile::containing(file, toJson(entry.material));
        if (!staged) return std::move(staged).error();
        files.push_back(std::move(*staged));
    }
    return putInPlace(files);
}

int runCalibrate(const CalibrateArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.forces);
    if (!text) return context.fail(text.error());
    const Result<std::vector<ForceRecord>> records = parseForceRecords(*text, arguments.forces);
    if (!records) return context.fail(records.error());
    const Result<std::vector<std::string>> ids = materialsOf(*records, arguments.material);
    if (!ids) return context.fail(ids.error());

    std::vector<Calibrated> materials;
    for (const std::string& id : *ids) {
        Result<Calibrated> one = calibrated(*records, id, arguments);
        if (!one) return context.fail(one.error());
        materials.push_back(std::move(*one));
    }
    if (!arguments.dryRun)
        if (const Result<void> kept = keepMaterials(materials, arguments); !kept) return context.fail(kept.error());
    json list = json::array();
    std::string words;
    for (Calibrated& entry : materials) {
        list.push_back(jsonOf(entry));
        words += (words.empty() ? "" : "\n") + textOf(entry);
    }
    context.answer({{"forces", std::filesystem::absolute(arguments.forces).lexically_normal().string()},
                    {"projection", arguments.projection},
                    {"chip_law", arguments.law},
                    {"confidence_level", CalibrationOptions{}.confidence},
                    {"materials", list}},
                   words);
    return 0;
}

std::string columnHelp() {
    const auto joined = [](bool required) {
        std::string text;
        for (const std::string_view name : forceRecordColumns(required))
            text += (text.empty() ? "" : ", ") + std::string(name);
        return text;
    };
    return "FORCES is CSV with one row a cut, or a sample of one (column cut), and the columns\n  " + joined(true) +
           "\nand, where they are needed,\n  " + joined(false) +
           ".\nForces are means over whole turns; axis from tip to holder; any frame. Columns called note… are for "
           "people.";
}

} // namespace

void registerCalibrate(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<CalibrateArguments>();
    CLI::App* command = program.add_subcommand(
        "calibrate", "Fit K, Kr and edge forces of materials to measured forces and keep them as your own");
    command->add_option("FORCES", arguments->forces, "Force records (.csv)")->required();
    command->add_option("--material", arguments->material, "Only this one of the materials in the file");
    command
        ->add_option("--law", arguments->law,
                     "edge: K and the force of the edge, Kte and Kre; constant: K alone; kienzle: K falling with the "
                     "chip's thickness")
        ->check(CLI::IsMember({"edge", "constant", "kienzle"}))
        ->capture_default_str();
    command
        ->add_option(
            "--projection", arguments->projection,
            "teeth: resolved for turning teeth, for forces of a dynamometer; paper: tangential against the feed, "
            "radial along the axis, for what the hand feels")
        ->check(CLI::IsMember({"teeth", "paper"}))
        ->capture_default_str();
    command->add_flag("--on-workpiece", arguments->onWorkpiece, "The forces are those on the workpiece");
    command->add_option("--like", arguments->like, "Material that gives a new one its other values");
    command->add_flag("--replace", arguments->replace, "Replace a material of that name");
    command->add_flag("--dry-run", arguments->dryRun, "Fit and report, but write nothing");
    command->footer(columnHelp());
    addJsonFlag(*command, context);
    command->callback([arguments, &context, &status] { status = runCalibrate(*arguments, context); });
}

} // namespace burin

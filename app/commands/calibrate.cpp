// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/base/staged_file.h"
#include "core/cutting/calibrated_materials.h"
#include "core/document/companions.h"
#include "ui/messages/details.h"

#include <array>

namespace burin {

namespace {

using nlohmann::json;

struct CalibrateArguments {
    std::string forces, material, law = "edge", projection = "teeth", like;
    bool onWorkpiece = false, replace = false, dryRun = false;
};

/// A calibration with the file to which its material was written; empty: none.
struct Calibrated {
    CalibratedMaterial made;
    std::string file;
};

CalibrationOptions optionsOf(const CalibrateArguments& arguments) {
    CalibrationOptions options;
    options.law = arguments.law == "kienzle" ? ChipLaw::kienzle
                  : arguments.law == "edge"  ? ChipLaw::edge
                                             : ChipLaw::constant;
    options.projection = arguments.projection == "teeth" ? ForceProjection::turningTeeth : ForceProjection::feedAndAxis;
    options.forcesOnWorkpiece = arguments.onWorkpiece;
    return options;
}

json jsonOf(const Confidence& confidence) {
    return {{"value", confidence.value}, {"low", confidence.low}, {"high", confidence.high}};
}

json jsonOf(const Calibrated& entry) {
    const MaterialCalibration& c = entry.made.calibration;
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
    const MaterialCalibration& c = entry.made.calibration;
    std::string text =
        worded(BURIN_TEXT("Command", "%1: %2 of %3 records, noise %4 N tangential, %5 N radial"),
               {c.material, std::to_string(c.residuals.size()), std::to_string(c.records),
                formatFixed(c.tangentialNoise, 3), formatFixed(c.radialNoise, 3)}) +
        "\n  K        " +
        worded(BURIN_TEXT("Command", "%1 J/mm^3, chips of %2 mm"), {textOf(c.specificEnergy), formatFixed(c.chip, 4)});
    if (c.options.law == ChipLaw::kienzle)
        text += "\n  kc1.1    " + textOf(c.kienzleForce) + " N/mm^2\n  mc       " + textOf(c.kienzleExponent);
    text += "\n  Kr       " + textOf(c.radialRatio);
    if (c.options.law == ChipLaw::edge)
        text += "\n  Kte      " + textOf(c.edgeForce) + " N/mm\n  Kre      " + textOf(c.radialEdgeForce) + " N/mm";
    for (const LeftOut& record : c.leftOut)
        text += "\n  " + worded(BURIN_TEXT("Command", "line %1 left out: %2"),
                                {std::to_string(record.line), detailText(record.reason).toStdString()});
    return text + "\n  " + (entry.file.empty() ? worded(BURIN_TEXT("Command", "not written (--dry-run)")) : entry.file);
}

/// Writes the materials to the user's library, all or none, after checking all ids.
Result<void> keepMaterials(std::vector<Calibrated>& materials, const CalibrateArguments& arguments) {
    for (Calibrated& entry : materials) {
        const Result<std::filesystem::path> file = userMaterialFile(entry.made.material.id, arguments.replace);
        if (!file) return file.error();
        const std::array<std::filesystem::path, 1> output{*file};
        if (Result<void> free = checkDistinct("FORCES", arguments.forces, output); !free) return free;
        if (Result<void> free = checkOutput("material", *file, {}); !free) return free;
        entry.file = file->string();
    }
    std::vector<StagedFile> files;
    for (const Calibrated& entry : materials) {
        const std::filesystem::path file = entry.file;
        if (Result<void> made = makeFolderOf(file); !made) return std::move(made).error();
        Result<StagedFile> staged = StagedFile::containing(file, toJson(entry.made.material));
        if (!staged) return std::move(staged).error();
        files.push_back(std::move(*staged));
    }
    return putInPlace(files);
}

/// If no material to start from is given, the error suggests an option of this command.
Error withOptionNamed(Error error, const CalibrateArguments& arguments) {
    if (error.code == ErrorCode::argumentInvalid && error.subject == "material" && arguments.like.empty())
        error.detail = worded(BURIN_TEXT("Command", "a known material, or --like MATERIAL"));
    return error;
}

int runCalibrate(const CalibrateArguments& arguments, CommandContext& context) {
    Result<std::vector<CalibratedMaterial>> made = calibrateMaterials(
        {arguments.forces, arguments.material, arguments.like, optionsOf(arguments), !arguments.dryRun});
    if (!made) return context.fail(withOptionNamed(std::move(made).error(), arguments));
    std::vector<Calibrated> materials;
    for (CalibratedMaterial& one : *made) materials.push_back({std::move(one), {}});
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
    return worded(
        BURIN_TEXT("Help", "FORCES is CSV with one row per cut, or per sample of a cut (column cut), and the columns\n "
                           " %1\nand, where they are needed,\n  %2.\nForces are means over whole revolutions; the axis "
                           "points from tip to holder; any frame. Columns named note… are ignored."),
        {joined(true), joined(false)});
}

} // namespace

void registerCalibrate(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<CalibrateArguments>();
    const CommandParser command = program.command(
        "calibrate",
        BURIN_TEXT("Help",
                   "Fit K, Kr and edge forces of materials to measured forces and add them to your own library"));
    command.positional(BURIN_TEXT("Argument", "FORCES"), arguments->forces, BURIN_TEXT("Help", "Force records (.csv)"))
        .required();
    command.option("--material", arguments->material, BURIN_TEXT("Help", "Only this one of the materials in the file"));
    command
        .option(
            "--law", arguments->law,
            BURIN_TEXT("Help",
                       "edge: K and the force of the edge, Kte and Kre; constant: K alone; kienzle: K falling with the "
                       "chip's thickness"))
        .choices({"edge", "constant", "kienzle"})
        .showDefault();
    command
        .option("--projection", arguments->projection,
                BURIN_TEXT("Help", "teeth: resolved for rotating teeth, for forces of a dynamometer; paper: tangential "
                                   "against the feed, radial along the axis, for the force that the hand feels"))
        .choices({"teeth", "paper"})
        .showDefault();
    command.flag("--on-workpiece", arguments->onWorkpiece,
                 BURIN_TEXT("Help", "The measured forces act on the workpiece, not on the tool"));
    command.option("--like", arguments->like,
                   BURIN_TEXT("Help", "Material from which a new one takes its other values"));
    command.flag("--replace", arguments->replace, BURIN_TEXT("Help", "Replace a material of that name"));
    command.flag("--dry-run", arguments->dryRun, BURIN_TEXT("Help", "Fit and report, but write nothing"));
    command.footer(columnHelp());
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runCalibrate(*arguments, context); });
}

} // namespace burin

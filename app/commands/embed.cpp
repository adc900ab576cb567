// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/numbers.h"
#include "core/base/steps.h"
#include "core/cad/import.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/setup/setup.h"

#include <CLI/CLI.hpp>

#include <array>

namespace burin {

namespace {

struct EmbedArguments {
    std::string model, output;
    double voxel = 0.5, margin = 5.0, stlUnit = 1.0;
    std::string stock = "box", material = "aluminium-6061";
    std::vector<std::string> bodyMaterials;
    SurroundingsArguments around;
    bool replace = false, overrides = false;
};

/// "BODY=NAME" for each body that differs. Errors: argumentInvalid, nameUnknown.
Result<std::vector<std::string>> bodyMaterials(const EmbedArguments& arguments, const Model& model) {
    std::vector<std::string> materials(model.bodies.size());
    for (const std::string& pair : arguments.bodyMaterials) {
        const std::size_t equals = pair.rfind('=');
        if (equals == std::string::npos) return Error{ErrorCode::argumentInvalid, "--body-material", pair, "BODY=NAME"};
        const std::string name = pair.substr(0, equals);
        bool found = false;
        std::string known;
        for (std::size_t i = 0; i < model.bodies.size(); ++i) {
            known += (known.empty() ? "" : ", ") + model.bodies[i].name;
            if (model.bodies[i].name != name) continue;
            materials[i] = pair.substr(equals + 1);
            found = true;
        }
        if (!found) return Error{ErrorCode::nameUnknown, "body", name, known};
    }
    return materials;
}

Result<std::vector<Property>> materialsOf(const Setup& setup) {
    std::vector<Property> materials;
    std::vector<std::string> ids{setup.stockMaterial};
    for (const std::string& id : setup.bodyMaterials)
        if (!id.empty() && std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    for (const std::string& id : ids) {
        Result<Property> material = loadMaterial(id);
        if (!material) return std::move(material).error();
        materials.push_back(std::move(*material));
    }
    return materials;
}

/// What a hand recorded is not replaced unless somebody says so. A file that can't be opened is for the saving to
/// judge.
Result<void> mayBeReplaced(const EmbedArguments& arguments) {
    std::error_code unreached;
    if (arguments.replace || !std::filesystem::exists(arguments.output, unreached)) return {};
    const Result<Project> standing = Project::openForReading(arguments.output);
    if (!standing) return {};
    const Result<std::vector<TakeInfo>> takes = standing->takes();
    if (!takes || takes->empty()) return {};
    return Error{ErrorCode::argumentInvalid, "--output", arguments.output,
                 "another name, or --replace: the project there holds recordings, " + std::to_string(takes->size())};
}

/// The model and the fixtures: none of them is where the project, or what Burin keeps beside it, will be.
Result<void> checkPlaces(const EmbedArguments& arguments) {
    std::vector<std::filesystem::path> inputs{arguments.model};
    inputs.insert(inputs.end(), arguments.around.fixtures.begin(), arguments.around.fixtures.end());
    if (Result<void> free = checkOutput("--output", arguments.output, inputs); !free) return free;
    const std::array<std::filesystem::path, 1> output{arguments.output};
    for (const std::filesystem::path& input : inputs)
        if (Result<void> free = checkDistinct(input == arguments.model ? "MODEL" : "--fixture", input, output); !free)
            return free;
    return {};
}

int runEmbed(const EmbedArguments& arguments, CommandContext& context) {
    if (const Result<void> free = checkPlaces(arguments); !free) return context.fail(free.error());
    if (const Result<void> allowed = mayBeReplaced(arguments); !allowed) return context.fail(allowed.error());
    if (arguments.stock != "box")
        return context.fail({ErrorCode::notSupported, "--stock " + arguments.stock, "--stock box", {}});
    ImportOptions options;
    options.stlUnit = arguments.stlUnit;
    context.stage("Importing");
    const Result<Model> model = importModel(arguments.model, options, context.progress());
    if (!model) return context.fail(model.error());

    Setup wanted;
    wanted.voxel = arguments.voxel;
    wanted.marginLow = wanted.marginHigh = glm::dvec3(arguments.margin);
    wanted.stockMaterial = arguments.material;
    Result<std::vector<std::string>> perBody = bodyMaterials(arguments, *model);
    if (!perBody) return context.fail(perBody.error());
    wanted.bodyMaterials = std::move(*perBody);
    const Result<Setup> setup = placeStock(*model, wanted);
    if (!setup) return context.fail(setup.error());
    const Result<std::vector<Property>> materials = materialsOf(*setup);
    if (!materials) return context.fail(materials.error());

    const Result<std::vector<Obstacle>> obstacles =
        obstaclesOf(arguments.around, arguments.stlUnit, context.progress());
    if (!obstacles) return context.fail(obstacles.error());
    const Result<AxisMode> axis = axisModeOf(arguments.around.axis.empty() ? "fixed" : arguments.around.axis);
    if (!axis) return context.fail(axis.error());
    const Result<TravelPlacement> travel =
        travelPlacementOf(arguments.around.travel.empty() ? "middle" : arguments.around.travel);
    if (!travel) return context.fail(travel.error());

    context.stage("Embedding");
    const Result<EmbeddedSetup> embedded = embed(*model, *setup, *materials, context.progress());
    if (!embedded) return context.fail(embedded.error());

    const std::vector<std::string> warnings = doubtsOf(*model, *embedded);
    if (const std::string refusal = unprotected(*embedded); !refusal.empty() && !arguments.overrides) {
        context.answer({{"project", nullptr}, {"warnings", warnings}}, "not made" + textOfDoubts(warnings));
        context.message(refusal);
        return static_cast<int>(ErrorClass::checkFailed);
    }

    context.stage("Saving");
    Result<ProjectChange> project = ProjectChange::create(arguments.output);
    if (!project) return context.fail(project.error());
    const Result<void> saved =
        inOrder([&] { return (*project)->setModel(*model); }, [&] { return (*project)->setSetup(*setup); },
                [&] { return (*project)->setMaterials(*materials); },
                [&] { return (*project)->setObstacles(*obstacles); }, [&] { return (*project)->setAxisMode(*axis); },
                [&] { return (*project)->setTravelPlacement(*travel); }, [&] { return project->save(); });
    if (!saved) return context.fail(saved.error());
    tellKeptEarlier(context, **project);

    const glm::ivec3 voxels = embedded->workpiece.grid().count();
    const nlohmann::json answer{{"project", std::filesystem::absolute(arguments.output).lexically_normal().string()},
                                {"stock_box_mm", jsonOf(setup->stock)},
                                {"voxel_mm", setup->voxel},
                                {"voxels", {voxels.x, voxels.y, voxels.z}},
                                {"memory_mb", static_cast<double>(embedded->workpiece.reservedBytes()) / 1e6},
                                {"part_volume_mm3", embedded->partVolume},
                                {"model_volume_mm3", model->volume()},
                                {"stock_volume_mm3", embedded->stockVolume},
                                {"work_offset_mm", burin::jsonOf(setup->workOffset)},
                                {"material", setup->stockMaterial},
                                {"axis", jsonOf(*axis)},
                                {"obstacles", jsonOf(*obstacles)},
                                {"warnings", warnings}};
    std::string text = "part " + formatFixed(embedded->partVolume, 1) + " mm^3 in stock " +
                       formatFixed(embedded->stockVolume, 1) + " mm^3, " + std::to_string(voxels.x) + " x " +
                       std::to_string(voxels.y) + " x " + std::to_string(voxels.z) + " voxels of " +
                       formatShortest(setup->voxel) + " mm";
    context.answer(answer, text + textOfDoubts(warnings));
    return 0;
}

} // namespace

void registerEmbed(CLI::App& program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<EmbedArguments>();
    CLI::App* command = program.add_subcommand("embed", "Embed a CAD model in stock and make a project of it");
    command->add_option("MODEL", arguments->model, "STEP, IGES, BREP or STL file")->required();
    command->add_option("-o,--output", arguments->output, "Project file to write (.burin)")->required();
    command->add_flag("--replace", arguments->replace, "Replace a project that holds recordings");
    command->add_flag("--override", arguments->overrides,
                      "Make the project even if bodies are too small for the voxels to be protected");
    command->add_option("--voxel", arguments->voxel, "Edge of a voxel, mm")->capture_default_str();
    command->add_option("--stock", arguments->stock, "Shape of the stock: box")->capture_default_str();
    command->add_option("--margin", arguments->margin, "Stock around the part on every side, mm")
        ->capture_default_str();
    command->add_option("--material", arguments->material, "Material of the stock")->capture_default_str();
    command->add_option("--body-material", arguments->bodyMaterials, "Material of a body: BODY=NAME; may be repeated");
    command->add_option("--stl-unit", arguments->stlUnit, "Millimetres per unit of an STL file")
        ->check(CLI::Range(1e-6, 1e6))
        ->capture_default_str();
    addSurroundings(*command, arguments->around);
    addJsonFlag(*command, context);
    command->callback([arguments, &context, &status] { status = runEmbed(*arguments, context); });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/assembly_report.h"
#include "app/command.h"
#include "app/placing_arguments.h"
#include "app/report.h"
#include "app/stock_arguments.h"
#include "app/surroundings.h"
#include "app/unit_argument.h"
#include "app/volume_files.h"
#include "app/wording.h"
#include "app/zero_arguments.h"
#include "core/base/numbers.h"
#include "core/base/steps.h"
#include "core/cad/import.h"
#include "core/document/companions.h"
#include "core/document/project_change.h"
#include "core/job/job_paths.h"
#include "core/job/stock_file.h"
#include "core/setup/setup.h"

#include <array>

namespace burin {

namespace {

struct EmbedArguments {
    std::string model, output;
    double voxel = 0.5, fileUnit = 1.0;
    StockArguments stock;
    SurroundingsArguments around;
    PlacingArguments placing;
    ZeroArguments zero;
    std::string mirror, unit;
    std::vector<std::string> colours;
    bool replace = false, overrides = false;
};

Result<std::vector<Property>> materialsOf(const Setup& setup) {
    std::vector<Property> materials;
    for (const std::string& id : materialsUsed(setup)) {
        Result<Property> material = loadMaterial(id);
        if (!material) return std::move(material).error();
        materials.push_back(std::move(*material));
    }
    return materials;
}

Result<void> addStockFile(const EmbedArguments& arguments, Setup& setup, CommandContext& context) {
    if (arguments.stock.file.empty()) {
        if (setup.form != StockForm::file) return {};
        return Error{ErrorCode::argumentInvalid, "--stock", "file", worded(BURIN_TEXT("Command", "--stock-file FILE"))};
    }
    context.stage(BURIN_TEXT("Command", "Reading the stock"));
    StockFileRequest request{arguments.stock.file, arguments.stock.table, arguments.voxel, {}, {}};
    request.import.fileUnit = arguments.fileUnit;
    Result<Property> material = loadMaterial(arguments.stock.material);
    if (!material) return std::move(material).error();
    request.material = std::move(*material);
    Result<StockFile> stock = readStockFile(request, context.progress());
    if (!stock) return withTableOption(std::move(stock).error(), "--stock-table");
    if (!stock->unitKnown) tellUnknownUnit(arguments.stock.file, context);
    setup.volume = std::move(stock->volume);
    return {};
}

/// Refuses to replace a project with recordings unless --replace is given. A file that cannot be opened is left to the
/// check when saving.
Result<void> mayBeReplaced(const EmbedArguments& arguments) {
    std::error_code unreached;
    if (arguments.replace || !std::filesystem::exists(arguments.output, unreached)) return {};
    const Result<Project> standing = Project::openForReading(arguments.output);
    if (!standing) return {};
    const Result<std::vector<SourceInfo>> sources = sourcesOf(*standing);
    if (!sources || sources->empty()) return {};
    return Error{
        ErrorCode::argumentInvalid, "--output", arguments.output,
        worded(BURIN_TEXT("Command", "another file, or --replace (recordings and passes in the project there: %1)"),
               {std::to_string(sources->size())})};
}

const char* optionOf(const std::filesystem::path& input, const EmbedArguments& arguments) {
    if (input == arguments.model) return "MODEL";
    if (input == arguments.stock.file) return "--stock-file";
    return input == arguments.stock.table ? "--stock-table" : "--fixture";
}

/// Checks that model, stock and fixtures are not where the project, or files that Burin keeps next to it, will be
/// written.
Result<void> checkPlaces(const EmbedArguments& arguments) {
    std::vector<std::filesystem::path> inputs;
    if (!arguments.model.empty()) inputs.emplace_back(arguments.model);
    for (const std::string& file : {arguments.stock.file, arguments.stock.table})
        if (!file.empty()) inputs.emplace_back(file);
    inputs.insert(inputs.end(), arguments.around.fixtures.begin(), arguments.around.fixtures.end());
    if (Result<void> free = checkOutput("--output", arguments.output, inputs); !free) return free;
    const std::array<std::filesystem::path, 1> output{arguments.output};
    for (const std::filesystem::path& input : inputs)
        if (Result<void> free = checkDistinct(optionOf(input, arguments), input, output); !free) return free;
    return {};
}

/// The model as in its file, or mirrored. Free carving needs none.
Result<Model> modelOf(const EmbedArguments& arguments, CommandContext& context) {
    if (arguments.model.empty()) {
        if (arguments.stock.freeCarving) return Model{};
        return Error{
            ErrorCode::argumentInvalid, "MODEL", {}, worded(BURIN_TEXT("Command", "a model file, or --free-carving"))};
    }
    ImportOptions options;
    options.fileUnit = arguments.fileUnit;
    if (Result<void> applied = applyUnit(arguments.unit, options); !applied) return std::move(applied).error();
    context.stage(BURIN_TEXT("Command", "Importing"));
    Result<Model> model = importModel(arguments.model, options, context.progress());
    if (!model) return model;
    if (Result<void> coloured = setColours(arguments.colours, *model); !coloured) return std::move(coloured).error();
    if (arguments.mirror.empty()) return model;
    const int axis = arguments.mirror.front() - 'x'; // the parser accepts x, y and z only
    auto whole = std::make_shared<const Model>(std::move(*model));
    return *placed(whole, mirroredAcross(axis, whole->box().centre()));
}

int runEmbed(const EmbedArguments& arguments, CommandContext& context) {
    if (const Result<void> free = checkPlaces(arguments); !free) return context.fail(free.error());
    if (const Result<void> allowed = mayBeReplaced(arguments); !allowed) return context.fail(allowed.error());
    Result<Model> imported = modelOf(arguments, context);
    if (!imported) return context.fail(imported.error());
    const auto whole = std::make_shared<const Model>(std::move(*imported));
    Setup asked;
    asked.voxel = arguments.voxel;
    const Result<Placement> placement = placingOf(arguments.placing, whole, context.progress());
    if (!placement) return context.fail(placement.error());
    asked.placement = *placement;
    const std::shared_ptr<const Model> model = placed(whole, *placement);
    Result<Setup> wanted = withStock(std::move(asked), arguments.stock, *model);
    if (!wanted) return context.fail(wanted.error());
    if (const Result<void> added = addStockFile(arguments, *wanted, context); !added)
        return context.fail(added.error());
    const Result<ProgramZero> zero = changedZero({}, arguments.zero, *model, context.progress());
    if (!zero) return context.fail(zero.error());
    wanted->zero = *zero;
    const Result<Setup> setup = placeStock(*model, *wanted);
    if (!setup) return context.fail(setup.error());
    const Result<std::vector<Property>> materials = materialsOf(*setup);
    if (!materials) return context.fail(materials.error());

    const Result<std::vector<Obstacle>> obstacles =
        obstaclesOf(arguments.around, arguments.fileUnit, context.progress());
    if (!obstacles) return context.fail(obstacles.error());
    const Result<AxisMode> axis = axisModeOf(arguments.around.axis.empty() ? "fixed" : arguments.around.axis);
    if (!axis) return context.fail(axis.error());
    const Result<TravelPlacement> travel =
        travelPlacementOf(arguments.around.travel.empty() ? "middle" : arguments.around.travel);
    if (!travel) return context.fail(travel.error());

    context.stage(BURIN_TEXT("Command", "Embedding"));
    const Result<EmbeddedSetup> embedded = embed(*model, *setup, *materials, context.progress());
    if (!embedded) return context.fail(embedded.error());

    const std::vector<std::string> warnings = doubtsOf(*model, *embedded);
    if (const std::string refusal = unprotected(*embedded); !refusal.empty() && !arguments.overrides) {
        context.answer({{"project", nullptr}, {"warnings", warnings}},
                       worded(BURIN_TEXT("Command", "no project was made")) + textOfDoubts(*model, *embedded));
        context.message(refusal);
        return static_cast<int>(ErrorClass::checkFailed);
    }

    context.stage(BURIN_TEXT("Command", "Saving"));
    Result<ProjectChange> project = ProjectChange::create(arguments.output);
    if (!project) return context.fail(project.error());
    const Result<void> saved =
        inOrder([&] { return (*project)->setModel(*whole); }, [&] { return (*project)->setSetup(*setup); },
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
                                {"zero", burin::jsonOf(setup->zero)},
                                {"work_offset_mm", burin::jsonOf(setup->workOffset)},
                                {"placement", burin::jsonOf(setup->placement)},
                                {"material", setup->stockMaterial},
                                {"stock_form", idOf(setup->form)},
                                {"free_carving", setup->freeCarving},
                                {"roles", jsonOfRoles(*model, *setup)},
                                {"assemblies", jsonOfAssemblies(*model)},
                                {"materials", jsonOfMaterials(*embedded)},
                                {"graded", jsonOfGradings(*embedded)},
                                {"axis", jsonOf(*axis)},
                                {"obstacles", jsonOf(*obstacles)},
                                {"warnings", warnings}};
    const std::string text =
        worded(BURIN_TEXT("Command", "part %1 mm^3 in stock %2 mm^3, %3 x %4 x %5 voxels of %6 mm"),
               {formatFixed(embedded->partVolume, 1), formatFixed(embedded->stockVolume, 1), std::to_string(voxels.x),
                std::to_string(voxels.y), std::to_string(voxels.z), formatShortest(setup->voxel)});
    context.answer(answer, text + textOfRoles(*model, *setup) + textOfMaterials(*setup, *embedded) +
                               textOfDoubts(*model, *embedded));
    return 0;
}

} // namespace

void registerEmbed(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<EmbedArguments>();
    const CommandParser command =
        program.command("embed", BURIN_TEXT("Help", "Embed a CAD model in stock and make a project"));
    command.positional(
        BURIN_TEXT("Argument", "MODEL"), arguments->model,
        BURIN_TEXT("Help",
                   "STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file; with --free-carving it may be left out"));
    command.option("-o,--output", arguments->output, BURIN_TEXT("Help", "Project file to write (.burin)")).required();
    command.flag("--replace", arguments->replace, BURIN_TEXT("Help", "Replace a project that holds recordings"));
    command.flag("--override", arguments->overrides,
                 BURIN_TEXT("Help", "Make the project even if bodies are too small for the voxels to be protected"));
    command.option("--voxel", arguments->voxel, BURIN_TEXT("Help", "Edge of a voxel, mm")).showDefault();
    addStock(command, arguments->stock);
    addPlacing(command, arguments->placing);
    command
        .option("--mirror", arguments->mirror,
                BURIN_TEXT("Help",
                           "Mirror the part across x, y or z first. It is then another part than the one in the file"))
        .choices({"x", "y", "z"});
    command
        .option("--file-unit,--stl-unit", arguments->fileUnit,
                BURIN_TEXT("Help", "Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)"))
        .range(1e-6, 1e6)
        .showDefault();
    addUnit(command, arguments->unit);
    command
        .option("--colour", arguments->colours,
                BURIN_TEXT("Help", "Colour of a body, or of all bodies of an assembly: BODY=#RRGGBB; may be repeated"))
        .oneAtATime();
    addZero(command, arguments->zero);
    addSurroundings(command, arguments->around);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runEmbed(*arguments, context); });
}

} // namespace burin

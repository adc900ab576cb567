// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/stock_arguments.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/cad/body_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace burin {

namespace {

constexpr std::string_view axisNames = "xyz";

std::optional<int> axisOf(const std::string& name) {
    const std::size_t axis = name.size() == 1 ? axisNames.find(name) : std::string_view::npos;
    return axis == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(axis));
}

/// Splits "NAME=TEXT" at the given position of '='.
std::optional<std::pair<std::string, std::string>> pairOf(const std::string& text, std::size_t equals) {
    if (equals == std::string::npos || equals == 0) return std::nullopt;
    return std::pair(text.substr(0, equals), text.substr(equals + 1));
}

/// The names that an argument may mean: those of the bodies, but not too many.
std::string knownBodies(const Model& model) {
    constexpr std::size_t mostNames = 20;
    std::string known;
    for (std::size_t i = 0; i < std::min(model.bodies.size(), mostNames); ++i)
        known += (known.empty() ? "" : ", ") + nameOf(model, i);
    return model.bodies.size() > mostNames ? known + ", …" : known;
}

/// Calls use(body, value) for each "BODY=VALUE". A name shared by several bodies refers to all of them, and so does the
/// path of an assembly.
Result<void> forBodies(const char* option, const std::vector<std::string>& pairs, const Model& model,
                       const std::function<Result<void>(std::size_t body, const std::string& value)>& use) {
    for (const std::string& text : pairs) {
        const auto pair = pairOf(text, text.rfind('='));
        if (!pair) return wrongArgument(option, text, BURIN_TEXT("Command", "BODY=NAME"));
        const std::vector<std::size_t> bodies = bodiesNamed(model, pair->first);
        if (bodies.empty()) return Error{ErrorCode::nameUnknown, "body", pair->first, knownBodies(model)};
        for (const std::size_t body : bodies)
            if (Result<void> used = use(body, pair->second); !used) return used;
    }
    return {};
}

/// "#RRGGBB", sRGB; empty for any other text.
BodyColour colourOf(const std::string& text) {
    constexpr std::string_view digits = "0123456789abcdefABCDEF";
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of(digits, 1) != std::string::npos) return {};
    const auto channel = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16));
    };
    return std::array{channel(1), channel(3), channel(5)};
}

Result<void> setRoles(Setup& setup, const StockArguments& arguments, const Model& model) {
    return forBodies("--role", arguments.roles, model, [&](std::size_t body, const std::string& id) -> Result<void> {
        const std::optional<BodyRole> role = bodyRoleFromId(id);
        if (!role)
            return wrongArgument("--role", id,
                                 BURIN_TEXT("Command", "part, stock, insert, protected-insert, fixture or ignored"));
        setup.roles.resize(model.bodies.size(), BodyRole::part);
        setup.roles[body] = *role;
        return {};
    });
}

Result<void> setForm(Setup& setup, const StockArguments& arguments) {
    setup.form = stockFormFromId(arguments.form).value_or(StockForm::box); // the parser accepts no other
    const std::optional<int> axis = axisOf(arguments.axis);
    const std::optional<glm::dvec3> direction = vectorOf(arguments.axis);
    if (!axis && !direction)
        return wrongArgument("--stock-axis", arguments.axis, BURIN_TEXT("Command", "x, y, z, or X,Y,Z"));
    setup.cylinder.axis = direction.value_or(glm::dvec3(0.0));
    if (axis) setup.cylinder.axis[*axis] = 1.0;
    if (!arguments.box.empty()) {
        const std::optional<std::vector<double>> box = numbersOf(arguments.box, 6);
        if (!box)
            return wrongArgument(
                "--stock-box", arguments.box,
                BURIN_TEXT("Command", "X0,Y0,Z0,X1,Y1,Z1 in mm, each of the last three above its counterpart"));
        setup.form = StockForm::box;
        setup.stated = true;
        setup.stock = {{(*box)[0], (*box)[1], (*box)[2]}, {(*box)[3], (*box)[4], (*box)[5]}};
    }
    if (!arguments.file.empty()) setup.form = StockForm::file;
    if (!arguments.cylinder.empty()) {
        const std::optional<std::vector<double>> bar = numbersOf(arguments.cylinder, 8);
        if (!bar)
            return wrongArgument("--stock-cylinder", arguments.cylinder,
                                 BURIN_TEXT("Command",
                                            "X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT in mm: middle of an end face, direction "
                                            "of the axis, radius and height"));
        setup.form = StockForm::cylinder;
        setup.stated = true;
        setup.cylinder = {{(*bar)[0], (*bar)[1], (*bar)[2]}, {(*bar)[3], (*bar)[4], (*bar)[5]}, (*bar)[6], (*bar)[7]};
    }
    return {};
}

Result<MaterialRegion> layerOf(const std::string& text) {
    const TextId allowed = BURIN_TEXT(
        "Command", "NAME=MATERIAL,AXIS,FROM,TO: x, y or z, and two positions in mm, of which one may be left out");
    const auto pair = pairOf(text, text.find('='));
    if (!pair) return wrongArgument("--layer", text, allowed);
    const std::vector<std::string> parts = partsOf(pair->second, ',');
    if (parts.size() != 4) return wrongArgument("--layer", text, allowed);
    MaterialRegion layer;
    layer.name = pair->first;
    layer.material = parts[0];
    const std::optional<int> axis = axisOf(parts[1]);
    if (!axis) return wrongArgument("--layer", text, allowed);
    layer.axis = *axis;
    for (auto [part, plane] : {std::pair(parts[2], &layer.from), std::pair(parts[3], &layer.to)}) {
        if (part.empty()) continue;
        const std::optional<double> number = parseNumber(part);
        if (!number) return wrongArgument("--layer", text, allowed);
        *plane = *number;
    }
    return layer;
}

/// "LAYER:VALUE=TEXT". Errors: argumentInvalid, nameUnknown.
Result<std::string> gradeOf(const char* option, const std::string& text, TextId allowed, Setup& setup,
                            RegionGrade*& grade) {
    const auto pair = pairOf(text, text.find('='));
    const std::size_t colon = pair ? pair->first.rfind(':') : std::string::npos;
    if (colon == std::string::npos) return wrongArgument(option, text, allowed);
    const std::string name = pair->first.substr(0, colon);
    const auto layer = std::ranges::find(setup.regions, name, &MaterialRegion::name);
    if (layer == setup.regions.end()) {
        std::string known;
        for (const MaterialRegion& region : setup.regions) known += (known.empty() ? "" : ", ") + region.name;
        return Error{ErrorCode::nameUnknown, "layer", name, known};
    }
    layer->grade.emplace();
    layer->grade->value = pair->first.substr(colon + 1);
    grade = &*layer->grade;
    return pair->second;
}

Result<void> setTable(const std::string& text, RegionGrade& grade, const Error& refused) {
    const std::size_t colon = text.find(':');
    const std::optional<int> axis = axisOf(text.substr(0, colon));
    if (colon == std::string::npos || !axis) return refused;
    grade.axis = *axis;
    for (const std::string& line : partsOf(text.substr(colon + 1), ';')) {
        const std::optional<std::vector<double>> numbers = numbersOf(line, 2);
        if (!numbers) return refused;
        grade.table.push_back({(*numbers)[0], (*numbers)[1]});
    }
    return {};
}

Result<void> setLayers(Setup& setup, const StockArguments& arguments) {
    for (const std::string& text : arguments.layers) {
        Result<MaterialRegion> layer = layerOf(text);
        if (!layer) return std::move(layer).error();
        setup.regions.push_back(std::move(*layer));
    }
    for (const std::string& text : arguments.grades) {
        RegionGrade* grade = nullptr;
        const Result<std::string> formula =
            gradeOf("--grade", text, BURIN_TEXT("Command", "LAYER:VALUE=FORMULA of X, Y and Z"), setup, grade);
        if (!formula) return formula.error();
        grade->formula = *formula;
        grade->entries = arguments.bands;
    }
    for (const std::string& text : arguments.gradeTables) {
        const TextId allowed = BURIN_TEXT("Command", "LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…");
        RegionGrade* grade = nullptr;
        const Result<std::string> table = gradeOf("--grade-table", text, allowed, setup, grade);
        if (!table) return table.error();
        grade->entries = arguments.bands;
        if (Result<void> set = setTable(*table, *grade, wrongArgument("--grade-table", text, allowed)); !set)
            return set;
    }
    return {};
}

std::string massText(const MaterialAmount& amount) {
    return amount.mass ? formatFixed(*amount.mass, 2) + " g" : worded(BURIN_TEXT("Command", "mass not known"));
}

} // namespace

void addStock(CommandParser command, StockArguments& arguments) {
    command.option("--stock", arguments.form, BURIN_TEXT("Help", "Shape of the stock: box, cylinder, solids or file"))
        .choices({"box", "cylinder", "solids", "file"})
        .showDefault();
    command.option("--stock-box", arguments.box,
                   BURIN_TEXT("Help", "Box of the stock whatever the part: X0,Y0,Z0,X1,Y1,Z1, mm"));
    command.option("--stock-cylinder", arguments.cylinder,
                   BURIN_TEXT("Help", "Round stock whatever the part: X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT, mm"));
    command
        .option("--stock-axis", arguments.axis,
                BURIN_TEXT("Help", "Axis of a cylinder around the part: x, y, z, or X,Y,Z"))
        .showDefault();
    command.option("--stock-file", arguments.file,
                   BURIN_TEXT("Help", "Stock as a file has it: a volume file (.srle), a voxel array (NRRD, or raw data "
                                      "with a JSON header), or a model whose solids are of --material"));
    command.option("--stock-table", arguments.table,
                   BURIN_TEXT("Help", "JSON table of the materials that the values of a voxel array mean"));
    command.option("--margin", arguments.margin, BURIN_TEXT("Help", "Stock around the part on every side, mm"))
        .showDefault();
    command.option("--material", arguments.material, BURIN_TEXT("Help", "Material of the stock")).showDefault();
    const auto addList = [&](const char* option, std::vector<std::string>& list, TextId help) {
        command.option(option, list, help).oneAtATime();
    };
    addList("--role", arguments.roles,
            BURIN_TEXT("Help",
                       "Role of a body, or of all bodies of an assembly (by its path): BODY=part, stock, insert, "
                       "protected-insert, fixture or ignored; may be repeated"));
    addList("--body-material", arguments.bodyMaterials,
            BURIN_TEXT("Help", "Material of a body, or of all bodies of an assembly: BODY=NAME; may be repeated"));
    addList("--layer", arguments.layers,
            BURIN_TEXT("Help", "Layer of the stock: NAME=MATERIAL,AXIS,FROM,TO, mm; a later one has the place; may be "
                               "repeated"));
    addList(
        "--grade", arguments.grades,
        BURIN_TEXT("Help", "Value of a layer that changes: LAYER:VALUE=FORMULA of X, Y and Z, mm; may be repeated"));
    addList(
        "--grade-table", arguments.gradeTables,
        BURIN_TEXT("Help", "The same by a table: LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…; may be repeated"));
    command
        .option("--bands", arguments.bands,
                BURIN_TEXT("Help", "Bands that the values of a graded layer are sorted into"))
        .range(1, maximumGrades)
        .showDefault();
    command.flag("--free-carving", arguments.freeCarving,
                 BURIN_TEXT("Help", "No part is needed: nothing pushes the tool back"));
}

Result<Setup> withStock(Setup setup, const StockArguments& arguments, const Model& model) {
    setup.marginLow = setup.marginHigh = glm::dvec3(arguments.margin);
    setup.stockMaterial = arguments.material;
    setup.freeCarving = arguments.freeCarving;
    setup.bodyMaterials.resize(model.bodies.size());
    const Result<void> materials = forBodies("--body-material", arguments.bodyMaterials, model,
                                             [&](std::size_t body, const std::string& id) -> Result<void> {
                                                 setup.bodyMaterials[body] = id;
                                                 return {};
                                             });
    if (!materials) return materials.error();
    if (Result<void> set = setRoles(setup, arguments, model); !set) return std::move(set).error();
    if (Result<void> set = setForm(setup, arguments); !set) return std::move(set).error();
    if (Result<void> set = setLayers(setup, arguments); !set) return std::move(set).error();
    return setup;
}

Result<void> setColours(const std::vector<std::string>& colours, Model& model) {
    return forBodies("--colour", colours, model, [&](std::size_t body, const std::string& text) -> Result<void> {
        const BodyColour colour = colourOf(text);
        if (!colour) return wrongArgument("--colour", text, BURIN_TEXT("Command", "#RRGGBB, such as #3070c0"));
        model.bodies[body].colour = colour;
        return {};
    });
}

nlohmann::json jsonOfLayers(const Setup& setup) {
    const auto plane = [](double at) { return std::isfinite(at) ? nlohmann::json(at) : nlohmann::json(); };
    nlohmann::json list = nlohmann::json::array();
    for (const MaterialRegion& layer : setup.regions)
        list.push_back({{"name", layer.name},
                        {"material", layer.material},
                        {"axis", std::string(1, axisNames[static_cast<std::size_t>(layer.axis)])},
                        {"from_mm", plane(layer.from)},
                        {"to_mm", plane(layer.to)},
                        {"graded", layer.grade ? nlohmann::json(layer.grade->value) : nlohmann::json()}});
    return list;
}

nlohmann::json jsonOfRoles(const Model& model, const Setup& setup) {
    nlohmann::json roles = nlohmann::json::object();
    for (std::size_t i = 0; i < model.bodies.size(); ++i) roles[nameOf(model, i)] = idOf(roleOf(setup, i));
    return roles;
}

std::string textOfStock(const Model& model, const Setup& setup) {
    std::string text;
    if (setup.form != StockForm::box)
        text += "\n  " + worded(BURIN_TEXT("Command", "form     %1"),
                                {setup.volume && setup.form == StockForm::file ? setup.volume->name()
                                                                               : std::string(idOf(setup.form))});
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        if (const BodyRole role = roleOf(setup, i); role != BodyRole::part)
            text +=
                "\n  " + worded(BURIN_TEXT("Command", "role     %1: %2"), {nameOf(model, i), std::string(idOf(role))});
    const auto plane = [](double at) { return std::isfinite(at) ? formatShortest(at) : std::string("…"); };
    for (const MaterialRegion& layer : setup.regions)
        text += "\n  " +
                worded(BURIN_TEXT("Command", "layer    %1: %2, %3 from %4 to %5 mm"),
                       {layer.name, layer.material, std::string(1, axisNames[static_cast<std::size_t>(layer.axis)]),
                        plane(layer.from), plane(layer.to)});
    return text;
}

nlohmann::json jsonOfMaterials(const EmbeddedSetup& embedded) {
    nlohmann::json list = nlohmann::json::array();
    for (const MaterialAmount& amount : materialAmounts(embedded))
        list.push_back({{"id", amount.id},
                        {"name", amount.name},
                        {"protected", amount.isProtected},
                        {"volume_mm3", amount.volume},
                        {"mass_g", amount.mass ? nlohmann::json(*amount.mass) : nlohmann::json()}});
    return list;
}

nlohmann::json jsonOfGradings(const EmbeddedSetup& embedded) {
    nlohmann::json list = nlohmann::json::array();
    for (const RegionGrading& grading : embedded.gradings)
        list.push_back({{"layer", grading.region},
                        {"value", grading.value},
                        {"unit", grading.unit},
                        {"low", grading.low},
                        {"high", grading.high},
                        {"bands", grading.bands},
                        {"error", grading.error}});
    return list;
}

std::string textOfMaterials(const Setup& setup, const EmbeddedSetup& embedded) {
    std::string text;
    if (const bool one = setup.roles.empty() && setup.regions.empty() && setup.form != StockForm::file; !one)
        for (const MaterialAmount& amount : materialAmounts(embedded))
            text += "\n" + worded(amount.isProtected ? BURIN_TEXT("Command", "  %1: %2 mm^3, %3, protected")
                                                     : BURIN_TEXT("Command", "  %1: %2 mm^3, %3"),
                                  {resourceName(amount.name), formatFixed(amount.volume, 1), massText(amount)});
    for (const RegionGrading& grading : embedded.gradings)
        text += "\n" + worded(BURIN_TEXT("Command", "  %1: %2 from %3 to %4 %5 in %6 bands, each place within %7 %5"),
                              {grading.region, grading.value, formatShortest(grading.low), formatShortest(grading.high),
                               grading.unit, std::to_string(grading.bands), formatShortest(grading.error)});
    if (embedded.partVolume == 0.0)
        text += "\n" + worded(BURIN_TEXT("Command", "free carving: there is no part, so nothing pushes the tool back"));
    return text;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/library_command.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/cutting/material_file.h"
#include "core/cutting/material_library.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace burin {

namespace {

using nlohmann::json;

json briefOf(const Property& material) {
    const auto value = [&](std::string_view name) {
        const auto found = material.values.find(name);
        return found == material.values.end() ? json() : json(found->second.value);
    };
    const bool estimated =
        std::ranges::any_of(material.values, [](const auto& entry) { return entry.second.estimate; });
    return {{"id", material.id},
            {"name", material.name},
            {"own", !isShippedMaterial(material.id)},
            {"specific_cutting_energy_j_mm3", value(specificCuttingEnergy)},
            {"density_g_cm3", value(density)},
            {"estimates", estimated}};
}

int listMaterials(const LibraryArguments&, CommandContext& context) {
    json materials = json::array();
    std::string text;
    int status = 0;
    for (const std::string& id : materialIds()) {
        const Result<Property> material = loadMaterial(id);
        if (!material) { // the others can still be used
            status = context.fail(material.error());
            continue;
        }
        materials.push_back(briefOf(*material));
        const auto energy = material->values.find(specificCuttingEnergy);
        text += (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
                worded(isShippedMaterial(id) ? BURIN_TEXT("Command", "shipped  K %1 J/mm^3  %2")
                                             : BURIN_TEXT("Command", "own      K %1 J/mm^3  %2"),
                       {energy == material->values.end() ? "-" : formatShortest(energy->second.value),
                        resourceName(material->name)});
    }
    if (status == 0) context.answer({{"materials", materials}}, text);
    return status;
}

int showMaterial(const LibraryArguments& arguments, CommandContext& context) {
    const Result<Property> material = loadMaterial(arguments.id);
    if (!material) return context.fail(material.error());
    std::string text = toJson(*material);
    text.pop_back(); // `answer` adds the line end
    context.answer(json::parse(text), text);
    return 0;
}

int keepMaterial(const ReadMaterial& read, bool replace, CommandContext& context) {
    const Result<std::filesystem::path> file = saveMaterial(read.material, replace);
    if (!file) return context.fail(file.error());
    json answer = briefOf(read.material);
    answer["file"] = file->string();
    answer["format"] = read.format;
    answer["notes"] = read.notes;
    std::string text = read.material.id + ": " + file->string();
    for (const std::string& note : read.notes) text += "\n  " + note;
    context.answer(answer, text);
    return 0;
}

int addMaterial(const LibraryArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    const Result<ReadMaterial> read = materialFromText(*text, arguments.file);
    if (!read) return context.fail(read.error());
    return keepMaterial(*read, arguments.replace, context);
}

int copyMaterial(const LibraryArguments& arguments, CommandContext& context) {
    const Result<Property> material = loadMaterial(arguments.id);
    if (!material) return context.fail(material.error());
    const std::string& name = arguments.name.empty() ? arguments.newId : arguments.name;
    return keepMaterial({copyOf(*material, arguments.newId, name), "Burin", {}}, arguments.replace, context);
}

int deleteMaterial(const LibraryArguments& arguments, CommandContext& context) {
    if (const Result<void> removed = removeMaterial(arguments.id); !removed) return context.fail(removed.error());
    context.answer({{"removed", arguments.id}}, worded(BURIN_TEXT("Command", "%1: removed"), {arguments.id}));
    return 0;
}

} // namespace

void registerMaterials(CommandParser program, CommandContext& context, int& status) {
    registerLibrary(
        program, context, status,
        {"materials",
         BURIN_TEXT("Help", "List and show materials; copy, add and delete your own. Every value states its source or "
                            "that it is an estimate"),
         BURIN_TEXT("Help", "List all materials with their specific cutting energies"),
         BURIN_TEXT("Help", "Print the file of a material (JSON), in the form that add reads"),
         BURIN_TEXT("Help", "Add a material to your own; what a card lacks is filled with estimates and told"),
         BURIN_TEXT("Help", "Material file (JSON), or material card of FreeCAD (.FCMat)"),
         BURIN_TEXT("Help", "Copy a material to one of your own"), BURIN_TEXT("Help", "Material to copy"),
         BURIN_TEXT("Help", "Delete one of your own materials"),
         BURIN_TEXT("Help", "Replace a material that has this ID already"), BURIN_TEXT("Help", "Material"),
         &listMaterials, &showMaterial, &addMaterial, &copyMaterial, &deleteMaterial});
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/library_command.h"
#include "app/report.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/machine/machine_library.h"

namespace burin {

namespace {

using nlohmann::json;

int runList(const LibraryArguments&, CommandContext& context) {
    json machines = json::array();
    std::string text;
    int status = 0;
    for (const std::string& id : machineIds()) {
        const Result<MachineProfile> machine = loadMachine(id);
        if (!machine) { // the others can still be used
            status = context.fail(machine.error());
            continue;
        }
        machines.push_back(jsonOf(*machine));
        text +=
            (text.empty() ? "" : "\n") + id + std::string(id.size() < 20 ? 20 - id.size() : 1, ' ') +
            worded(isTypicalMachine(id) ? BURIN_TEXT("Command", "typical  %1") : BURIN_TEXT("Command", "own      %1"),
                   {resourceName(machine->name)});
    }
    if (status == 0) context.answer({{"machines", machines}}, text);
    return status;
}

int runShow(const LibraryArguments& arguments, CommandContext& context) {
    const Result<MachineProfile> machine = loadMachine(arguments.id);
    if (!machine) return context.fail(machine.error());
    std::string text = toJson(*machine);
    text.pop_back(); // `answer` adds the line end
    context.answer(json::parse(text), text);
    return 0;
}

int keep(const MachineProfile& machine, bool replace, CommandContext& context) {
    const Result<std::filesystem::path> file = saveMachine(machine, replace);
    if (!file) return context.fail(file.error());
    json answer = jsonOf(machine);
    answer["file"] = file->string();
    context.answer(answer, machine.id + ": " + file->string());
    return 0;
}

int runAdd(const LibraryArguments& arguments, CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    const Result<MachineProfile> machine = machineFromJson(*text, arguments.file);
    if (!machine) return context.fail(machine.error());
    return keep(*machine, arguments.replace, context);
}

int runCopy(const LibraryArguments& arguments, CommandContext& context) {
    const Result<MachineProfile> machine = loadMachine(arguments.id);
    if (!machine) return context.fail(machine.error());
    return keep(copyOf(*machine, arguments.newId, arguments.name.empty() ? arguments.newId : arguments.name),
                arguments.replace, context);
}

int runRemove(const LibraryArguments& arguments, CommandContext& context) {
    if (const Result<void> removed = removeMachine(arguments.id); !removed) return context.fail(removed.error());
    context.answer({{"removed", arguments.id}}, worded(BURIN_TEXT("Command", "%1: removed"), {arguments.id}));
    return 0;
}

} // namespace

void registerMachines(CommandParser program, CommandContext& context, int& status) {
    registerLibrary(program, context, status,
                    {"machines",
                     BURIN_TEXT("Help", "List and show machines; copy, add and delete your own. The machines that "
                                        "Burin is shipped with have typical values of their class: copy one and enter "
                                        "those of your machine"),
                     BURIN_TEXT("Help", "List all machines with their names; typical: shipped with Burin"),
                     BURIN_TEXT("Help", "Print the file of a machine (JSON), in the form that add reads"),
                     BURIN_TEXT("Help", "Add a machine to your own; every value is checked"),
                     BURIN_TEXT("Help", "Machine file (JSON)"), BURIN_TEXT("Help", "Copy a machine to one of your own"),
                     BURIN_TEXT("Help", "Machine to copy"), BURIN_TEXT("Help", "Delete one of your own machines"),
                     BURIN_TEXT("Help", "Replace your machine of this ID"), BURIN_TEXT("Help", "Machine"), &runList,
                     &runShow, &runAdd, &runCopy, &runRemove});
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The user's tool libraries, as far as ToolController changes them.
#include "ui/workbench/tool_controller.h"
#include "ui/workbench/undo_refusal.h"
#include "ui/workbench/value_command.h"

namespace burin {

std::string ToolController::addTools(std::vector<Tool> tools, const std::string& library) {
    std::string first;
    if (refusedDuringUndo(desk_, *this, tr("import of tools"))) return first;
    desk_.undo.beginMacro(tr("import of tools"));
    if (library != ownLibrary && !libraries_.contains(library)) pushRenaming(tr("new tool library"), {{}, library});
    for (Tool& tool : tools) {
        tool.id = burin::freeId(tools_, tool.id);
        addTool(tool, library);
        if (first.empty()) first = tool.id;
    }
    desk_.undo.endMacro();
    return first;
}

void ToolController::moveTool(const std::string& id, const std::string& library) {
    const std::optional<Tool> tool = itemOf(library_, id);
    if (tool) push(tr("moving a tool to another library"), {id, tool}, current().id, library);
}

Result<void> ToolController::addLibrary(const std::string& name) {
    if (Result<void> free = checkNewLibrary(name); !free) return free;
    if (desk_.undo.busy()) return undoUnderWay(tr("new tool library"));
    pushRenaming(tr("new tool library"), {{}, name});
    return {};
}

Result<void> ToolController::renameLibrary(const std::string& from, const std::string& to) {
    if (from == to) return {};
    if (Result<void> free = checkNewLibrary(to); !free) return free;
    if (desk_.undo.busy()) return undoUnderWay(tr("name of a tool library"));
    pushRenaming(tr("name of a tool library"), {from, to});
    return {};
}

void ToolController::deleteLibrary(const std::string& name) {
    if (refusedDuringUndo(desk_, *this, tr("deleting a tool library"))) return;
    desk_.undo.beginMacro(tr("deleting a tool library"));
    const std::vector<Tool> tools = library_; // deleting one changes it
    for (const Tool& tool : tools)
        if (libraries_.isIn(tool.id, name)) deleteTool(tool.id);
    pushRenaming(tr("deleting a tool library"), {name, {}});
    desk_.undo.endMacro();
}

Result<void> ToolController::checkNewLibrary(const std::string& name) const {
    if (Result<void> valid = checkLibraryName(name); !valid) return valid;
    if (!libraries_.contains(name)) return {};
    return Error{ErrorCode::argumentInvalid, "library", name, "a name that no library has yet"};
}

void ToolController::pushRenaming(const QString& text, const Renaming& wanted) {
    desk_.undo.push(new ValueCommand<Renaming>(text, -1, {wanted.to, wanted.from}, wanted,
                                               [this](const Renaming& renaming) { rename(renaming); }));
}

void ToolController::rename(const Renaming& renaming) {
    const Result<void> done = renaming.from.empty() ? addToolLibrary(renaming.to)
                              : renaming.to.empty() ? removeToolLibrary(renaming.from)
                                                    : renameToolLibrary(renaming.from, renaming.to);
    if (!done) emit failed(done.error());
    readLibraries();
    emit changed();
}

void ToolController::readLibraries() {
    Result<ToolLibraries> libraries = loadToolLibraries();
    if (!libraries) emit failed(libraries.error());
    libraries_ = libraries ? std::move(*libraries) : ToolLibraries{};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/tool_controller.h"

#include "core/base/resource_folder.h"
#include "core/tool/tool_library.h"
#include "ui/workbench/undo_refusal.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace burin {

namespace {

constexpr const char* defaultTool = "ball-6";

void sortTools(std::vector<Tool>& tools) {
    std::ranges::sort(tools, {}, [](const Tool& tool) {
        return std::tuple<CutterType, double, std::string_view>(tool.cutter.type, tool.cutter.diameter, tool.id);
    });
}

std::vector<Tool> toolLibrary() {
    std::vector<Tool> tools;
    for (const std::string& id : toolIds())
        if (Result<Tool> tool = loadTool(id)) tools.push_back(std::move(*tool));
    sortTools(tools);
    return tools;
}

/// Reads the file of one tool again; the others stay as they were read. Reading all of them takes 0.07 ms each, which
/// would add up when a library of hundreds is imported.
void readAgain(std::vector<Tool>& tools, const std::string& id) {
    std::erase_if(tools, [&](const Tool& tool) { return tool.id == id; });
    if (Result<Tool> tool = loadTool(id)) tools.push_back(std::move(*tool));
    sortTools(tools);
}

bool same(const std::optional<Tool>& one, const std::optional<Tool>& other) {
    return one.has_value() == other.has_value() && (!one || toJson(*one) == toJson(*other));
}

} // namespace

ToolController::ToolController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    load({}, {});
}

const Tool& ToolController::current() const {
    static const Tool none;
    return current_ < tools_.size() ? tools_[current_] : none;
}

void ToolController::setLocked(bool locked) {
    if (locked == locked_) return;
    locked_ = locked;
    emit changed();
}

std::optional<CuttingConditions> ToolController::conditionsIn(const Property& material,
                                                              const MachineProfile& machine) const {
    if (tools_.empty()) return std::nullopt;
    const Result<CuttingConditions> conditions =
        cuttingConditions(current(), material, machine.maximumSpindleSpeed, machine.maximumFeed);
    return conditions ? std::optional(*conditions) : std::nullopt;
}

void ToolController::choose(const std::string& id) {
    if (locked_ || id == current().id) return;
    desk_.undo.push(new ValueCommand<std::string>(tr("tool"), -1, current().id, id,
                                                  [this](const std::string& value) { apply(value); }));
}

void ToolController::show(const std::string& id) {
    const auto found = std::ranges::find(tools_, id, &Tool::id);
    if (found == tools_.end() || id == current().id) return;
    current_ = static_cast<std::size_t>(found - tools_.begin());
    emit changed();
    emit chosen();
}

void ToolController::apply(const std::string& id) {
    const auto found = std::ranges::find(tools_, id, &Tool::id);
    if (found == tools_.end()) return;
    current_ = static_cast<std::size_t>(found - tools_.begin());
    store([tool = *found](Project& project) { return project.setTool(tool); });
    emit changed();
    emit chosen();
}

std::string ToolController::freeId(const QString& name) const {
    QString plain; // without accents
    for (const QChar letter : name.normalized(QString::NormalizationForm_D))
        if (!letter.isMark()) plain += letter;
    const std::string id = resourceIdFrom(plain.toStdString());
    return burin::freeId(tools_, id.empty() ? "tool" : id);
}

void ToolController::shape(const ToolShapeRequest& request) {
    if (locked_ || shaping()) return;
    desk_.tasks.start(
        TaskKind::tool, tr("Making a tool of %1").arg(QString::fromStdString(request.flutes.filename().string())),
        [request](Progress& progress) { return shapedTool(request, progress); },
        [this](const Result<ShapedTool>& made) {
            if (!made) {
                if (made.error().code != ErrorCode::cancelled) emit failed(made.error());
            } else if (!locked_ && !refusedDuringUndo(desk_, *this, tr("new tool"))) { // a recording may have begun
                push(tr("new tool"), {made->tool.id, made->tool}, made->tool.id, std::string(ownLibrary));
                emit shaped(*made);
            }
            emit changed();
        });
    emit changed();
}

std::vector<Holder> ToolController::holders() {
    std::vector<Holder> holders;
    for (const std::string& id : holderIds())
        if (Result<Holder> holder = loadHolder(id)) holders.push_back(std::move(*holder));
    return holders;
}

std::vector<Property> ToolController::materials() {
    std::vector<Property> materials;
    for (const std::string& id : materialIds())
        if (Result<Property> material = loadMaterial(id)) materials.push_back(std::move(*material));
    return materials;
}

bool ToolController::milledWith(const std::string& id) const {
    return std::ranges::find(milledWith_, id) != milledWith_.end();
}

std::string ToolController::copyTool(const Tool& tool, const QString& name, const std::string& library) {
    if (refusedDuringUndo(desk_, *this, tr("copy of a tool"))) return tool.id;
    const std::string id = burin::freeId(tools_, tool.id + "-copy");
    Tool copy = copyOf(tool, id, name.toStdString());
    copy.number = freeToolNumber(tools_);
    push(tr("copy of a tool"), {id, copy}, current().id, library);
    return id;
}

void ToolController::keepTool(const Tool& tool) {
    push(tr("values of a tool"), {tool.id, tool}, current().id, libraries_.libraryOf(tool.id));
}

void ToolController::addTool(const Tool& tool, const std::string& library) {
    push(tr("new tool"), {tool.id, tool}, current().id, library);
}

void ToolController::deleteTool(const std::string& id) {
    push(tr("deleting a tool"), {id, std::nullopt}, id == current().id ? std::string(defaultTool) : current().id,
         std::string(ownLibrary));
}

void ToolController::push(const QString& text, const OwnFile<Tool>& wanted, const std::string& inSpindle,
                          const std::string& library) {
    if (refusedDuringUndo(desk_, *this, text)) return;
    const OwnTool before{{wanted.id, itemOf(library_, wanted.id)}, current().id, libraries_.libraryOf(wanted.id)};
    desk_.undo.push(new ValueCommand<OwnTool>(text, -1, before, {wanted, inSpindle, library},
                                              [this](const OwnTool& own) { keep(own); }));
}

/// Tools that takes were milled with stay unchanged in the project.
void ToolController::keep(const OwnTool& own) {
    if (const Result<void> done = write(own.file, saveTool, removeTool); !done) {
        emit failed(done.error());
        return;
    }
    if (const Result<void> put = putTool(own.file.id, own.file.item ? own.library : std::string(ownLibrary)); !put)
        emit failed(put.error());
    readLibraries();
    const std::string before = current().id;
    const bool changes = !milledWith(own.file.id) && !same(itemOf(tools_, own.file.id), own.file.item);
    readAgain(library_, own.file.id);
    if (changes) {
        std::erase_if(tools_, [&](const Tool& tool) { return tool.id == own.file.id; });
        if (own.file.item) tools_.push_back(*own.file.item);
        sortTools(tools_);
    }
    const auto found = std::ranges::find(tools_, before, &Tool::id);
    current_ = found == tools_.end() ? 0 : static_cast<std::size_t>(found - tools_.begin());
    if (own.inSpindle != before || (changes && own.file.id == before))
        apply(own.inSpindle);
    else
        emit changed();
}

void ToolController::load(const std::vector<Tool>& own, const std::string& last) {
    readLibraries();
    library_ = toolLibrary();
    tools_ = library_;
    for (const Tool& tool : own) { // as they were when used, whatever the library contains now
        const auto same = std::ranges::find(tools_, tool.id, &Tool::id);
        if (same == tools_.end())
            tools_.push_back(tool);
        else
            *same = tool;
    }
    const std::string wanted = !last.empty() ? last : own.empty() ? defaultTool : own.back().id;
    const auto found = std::ranges::find(tools_, wanted, &Tool::id);
    current_ = found == tools_.end() ? 0 : static_cast<std::size_t>(found - tools_.begin());
    emit changed();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/tool_controller.h"

#include "ui/workbench/value_command.h"

#include <algorithm>

namespace burin {

namespace {

constexpr const char* defaultTool = "ball-6";

std::vector<Tool> toolLibrary() {
    std::vector<Tool> tools;
    for (const std::string& id : toolIds())
        if (Result<Tool> tool = loadTool(id)) tools.push_back(std::move(*tool));
    std::ranges::stable_sort(tools, [](const Tool& a, const Tool& b) {
        return std::pair(a.cutter.type, a.cutter.diameter) < std::pair(b.cutter.type, b.cutter.diameter);
    });
    return tools;
}

} // namespace

ToolController::ToolController(const Desk& desk, QObject* parent) : Controller(desk, parent), tools_(toolLibrary()) {
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

void ToolController::load(const std::vector<Tool>& own, const std::string& last) {
    tools_ = toolLibrary();
    for (const Tool& tool : own) { // as they were when they were used, whatever the library says now
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

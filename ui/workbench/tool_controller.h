// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/job/tool_shape.h"
#include "core/machine/machine_profile.h"
#include "core/tool/holder_library.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"
#include "ui/workbench/controller.h"
#include "ui/workbench/own_file.h"

#include <optional>

namespace burin {

/// The tool in the spindle, chosen from the library.
class ToolController final : public Controller {
    Q_OBJECT
public:
    ToolController(const Desk& desk, QObject* parent);

    const std::vector<Tool>& tools() const noexcept { return tools_; }
    const Tool& current() const;
    bool locked() const noexcept { return locked_; }
    void setLocked(bool locked); ///< a recording runs
    /// What the tables say for this tool in a material on a machine; nothing where the material lacks what it takes.
    std::optional<CuttingConditions> conditionsIn(const Property& material, const MachineProfile& machine) const;

    void show(const std::string& id);   ///< as a project was left; no entry of the undo stack, nothing is stored
    void choose(const std::string& id); ///< an entry of the undo stack
    /// What a project holds. @param last the tool of its newest recording; empty: none
    void load(const std::vector<Tool>& own, const std::string& last);

    /// The tools that Burin is shipped with and the user's own, which are the user's, not the project's.
    const std::vector<Tool>& library() const noexcept { return library_; }
    static std::vector<Holder> holders(); ///< that there are; those whose files are damaged are not among them
    // Entries of the undo stack.
    /// @return its id: that of the original with "-copy" and, where needed, a number
    std::string copyTool(const Tool& tool, const QString& name);
    void keepTool(const Tool& tool); ///< one of the user's own, new or changed
    /// New ones, as one entry of the undo stack; an id that there is gets a number behind it. @return the first one's
    std::string keepTools(std::vector<Tool> tools);
    void deleteTool(const std::string& id); ///< one of the user's own
    /// Takes were milled with them: the project keeps them as they were. @param ids may have one several times
    void setMilledWith(std::vector<std::string> ids) { milledWith_ = std::move(ids); }
    bool milledWith(const std::string& id) const;

    bool shaping() const { return desk_.tasks.running(TaskKind::tool); }
    /// Makes a tool of models beside the window's work, adds it to the user's own and takes it into the spindle: an
    /// entry of the undo stack.
    void shape(const ToolShapeRequest& request);
    /// An id of a file that no tool has yet. @param name what the user calls it
    std::string freeId(const QString& name) const;

signals:
    void chosen();
    void shaped(const ShapedTool& tool);

private:
    struct OwnTool {
        OwnFile<Tool> file;
        std::string inSpindle; ///< then, by id
    };
    void apply(const std::string& id);
    void push(const QString& text, const OwnFile<Tool>& wanted, const std::string& inSpindle);
    void keep(const OwnTool& own);

    std::vector<Tool> library_;
    std::vector<Tool> tools_; ///< the library and, before its tools, the project's own
    std::vector<std::string> milledWith_;
    std::size_t current_ = 0;
    bool locked_ = false;
};

} // namespace burin

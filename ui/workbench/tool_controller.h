// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/job/tool_shape.h"
#include "core/machine/machine_profile.h"
#include "core/tool/holder_library.h"
#include "core/tool/tool.h"
#include "core/tool/tool_libraries.h"
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
    void setLocked(bool locked); ///< while a recording is running
    /// The tables' values for this tool in a material on a machine; empty if the material lacks required values.
    std::optional<CuttingConditions> conditionsIn(const Property& material, const MachineProfile& machine) const;

    void show(const std::string& id);   ///< as the project was last left; no entry of the undo stack, nothing is stored
    void choose(const std::string& id); ///< an entry of the undo stack
    /// Loads the tools of a project. @param last the tool of its newest recording; empty: none
    void load(const std::vector<Tool>& own, const std::string& last);

    /// The tools shipped with Burin and the user's own, which belong to the user, not to the project.
    const std::vector<Tool>& library() const noexcept { return library_; }
    static std::vector<Holder> holders();     ///< all available; damaged files are left out
    static std::vector<Property> materials(); ///< the same for materials
    // Entries of the undo stack.
    /// @param library that the copy is put into
    /// @return id of the copy: that of the original with "-copy" and, if needed, a number
    std::string copyTool(const Tool& tool, const QString& name, const std::string& library);
    void keepTool(const Tool& tool);                            ///< one of the user's own, changed
    void addTool(const Tool& tool, const std::string& library); ///< a new one of the user's own
    /// Adds new tools as one entry of the undo stack; an existing id gets a number appended.
    /// @param library that they are put into; made if it does not exist @return the id of the first
    std::string addTools(std::vector<Tool> tools, const std::string& library);
    void moveTool(const std::string& id, const std::string& library); ///< one of the user's own
    void deleteTool(const std::string& id);                           ///< one of the user's own

    /// The user's libraries, as they were last read.
    const ToolLibraries& libraries() const noexcept { return libraries_; }
    // Entries of the undo stack, unless they fail. Errors: those of checkLibraryName; argumentInvalid (a library with
    // this name exists).
    Result<void> addLibrary(const std::string& name);
    Result<void> renameLibrary(const std::string& from, const std::string& to);
    void deleteLibrary(const std::string& name); ///< with its tools
    /// Takes were milled with these tools: the project keeps them unchanged. @param ids may contain duplicates
    void setMilledWith(std::vector<std::string> ids) { milledWith_ = std::move(ids); }
    bool milledWith(const std::string& id) const;

    bool shaping() const { return desk_.tasks.running(TaskKind::tool); }
    /// Makes a tool from models in the background, adds it to the user's own and loads it into the spindle: an entry of
    /// the undo stack.
    void shape(const ToolShapeRequest& request);
    /// An id of a file that no tool has yet. @param name given by the user
    std::string freeId(const QString& name) const;

signals:
    void chosen();
    void shaped(const ShapedTool& tool);

private:
    struct OwnTool {
        OwnFile<Tool> file;
        std::string inSpindle; ///< id of the tool in the spindle at that time
        std::string library;   ///< that the tool is in
    };
    /// A library gets another name. An empty name: it does not exist.
    struct Renaming {
        std::string from, to;
    };
    void apply(const std::string& id);
    void push(const QString& text, const OwnFile<Tool>& wanted, const std::string& inSpindle,
              const std::string& library);
    void keep(const OwnTool& own);
    void readLibraries();
    Result<void> checkNewLibrary(const std::string& name) const;
    void pushRenaming(const QString& text, const Renaming& wanted);
    void rename(const Renaming& renaming);

    std::vector<Tool> library_;
    ToolLibraries libraries_;
    std::vector<Tool> tools_; ///< the library, in which the project's tools take precedence
    std::vector<std::string> milledWith_;
    std::size_t current_ = 0;
    bool locked_ = false;
};

} // namespace burin

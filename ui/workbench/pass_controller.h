// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/computed_pass.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A pass as requested by the user.
struct RequestedPass {
    PassRequest request;
    std::vector<std::int64_t> leads;     ///< takes whose strokes become lines of the request
    std::optional<std::int64_t> instead; ///< the pass of the path in force that it replaces
};

/// Computes passes of the tool in force in the background and adds each as the last source of the tool's path.
class PassController final : public Controller {
    Q_OBJECT
public:
    PassController(const Desk& desk, WorkpieceController& workpiece, PathController& path, const ToolController& tools,
                   std::shared_ptr<KeptLeads> leads, QObject* parent);

    bool busy() const { return wanted_.has_value() || desk_.tasks.running(TaskKind::pass); }
    /// Whether the workpiece is ready for the tool in force, and no pass is being computed.
    bool possible() const;
    /// Computes a pass; it becomes an entry of the undo stack when complete, errors are reported by `failed`. Does
    /// nothing unless `possible`. Can be cancelled as a task. If the workpiece changes meanwhile, it is started again
    /// after the change.
    void compute(const RequestedPass& wanted);
    /// Adds the moves of a program (G-code or cutter locations) as the last sources of the paths of its tools: the tool
    /// in force if it calls one number, else the project's tools by their numbers. An entry of the undo stack; errors
    /// are reported by `failed`. Can be cancelled as a task. Does nothing unless `possible`.
    /// @param file for messages and names @param dialect by id
    void addProgram(std::string text, const std::string& file, const std::string& dialect);
    void forget(); ///< another project
    /// The pass computed last, for the tool in force; null if there is none or it belongs to another tool.
    const ComputedPass* newest() const;

signals:
    void programAdded(const ProgramPasses& passes);

private:
    struct Matter;
    bool ready() const; ///< `possible`, except that a pass may be under way
    void goOn();
    void readProgram(std::string text, const std::string& file, const std::string& dialect,
                     const std::vector<Tool>& tools);
    void run(Matter matter);
    void end();

    WorkpieceController& workpiece_;
    PathController& path_;
    const ToolController& tools_;
    std::shared_ptr<KeptLeads> leads_;
    std::shared_ptr<Progress> reading_;   ///< of takes; null: never begun
    std::optional<RequestedPass> wanted_; ///< until it is computed, cancelled or impossible
    std::string tool_;                    ///< id of the tool that it is for
    std::shared_ptr<const ComputedPass> newest_;
    bool asked_ = false; ///< the project is being read
    quint64 loads_ = 0;
};

} // namespace burin

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

/// A pass as the user wants it.
struct WantedPass {
    PassRequest request;
    std::vector<std::int64_t> leads;     ///< takes whose strokes are added to the request's lines
    std::optional<std::int64_t> instead; ///< the pass of the path in force whose place it takes
};

/// Computes passes of the tool in force in the background and makes each the last source of its path.
class PassController final : public Controller {
    Q_OBJECT
public:
    PassController(const Desk& desk, WorkpieceController& workpiece, PathController& path, const ToolController& tools,
                   QObject* parent);

    bool busy() const { return wanted_.has_value() || desk_.tasks.running(TaskKind::pass); }
    /// The workpiece stands with the tool in force, and no pass is being computed.
    bool possible() const;
    /// An entry of the undo stack once it is there; `failed` says why there is none. Nothing happens where it is not
    /// possible. Can be cancelled as a task. Where the workpiece changes meanwhile it begins again behind that.
    void compute(const WantedPass& wanted);
    /// Makes what a program, G-code or cutter locations, mills the last sources of its tools' paths: with the tool in
    /// force where it calls one number, else with the project's by their numbers. An entry of the undo stack; `failed`
    /// says why there is none. Can be cancelled as a task. Nothing happens where it is not possible.
    /// @param file for messages and names @param dialect by id
    void addProgram(std::string text, const std::string& file, const std::string& dialect);
    void forget(); ///< another project
    /// The pass computed last, for the tool in force; null: none, or it is another tool's.
    const ComputedPass* newest() const;

signals:
    void programAdded(const ProgramPasses& passes);

private:
    struct Matter;
    bool ready() const; ///< nothing but a pass under way could hinder one
    void goOn();
    void readProgram(std::string text, const std::string& file, const std::string& dialect,
                     const std::vector<Tool>& tools);
    void run(Matter matter);
    void end();

    WorkpieceController& workpiece_;
    PathController& path_;
    const ToolController& tools_;
    std::optional<WantedPass> wanted_; ///< until it is there, cancelled or impossible
    std::string tool_;                 ///< that it is for, by id
    std::shared_ptr<const ComputedPass> newest_;
    bool asked_ = false; ///< the project is
    quint64 loads_ = 0;
};

} // namespace burin

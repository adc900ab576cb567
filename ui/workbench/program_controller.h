// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/project/program_job.h"
#include "ui/workbench/bench_controller.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/target_controller.h"

#include <filesystem>
#include <memory>

namespace burin {

/// The program: posted, read back and checked in the background. Only what passed its check leaves the house, or what
/// the user gave a reason for.
class ProgramController final : public Controller {
    Q_OBJECT
public:
    ProgramController(const Desk& desk, BenchController& bench, PathController& path, const TargetController& target,
                      QObject* parent);

    /// The newest one; null: none yet.
    const std::shared_ptr<const CheckedProgram>& program() const noexcept { return program_; }
    /// Text of a program that the project held when it was opened, until a new one is posted.
    const QString& storedText() const noexcept { return storedText_; }
    /// The text was changed by hand since it was checked.
    bool edited() const noexcept { return edited_; }
    /// What the control may not take of the text as it is.
    const std::vector<LintMark>& lint() const noexcept { return lint_; }
    double gougeTolerance() const noexcept { return gougeTolerance_; } ///< mm
    const std::optional<Error>& problem() const noexcept { return problem_; }
    bool outdated() const noexcept { return outdated_; }
    bool busy() const { return desk_.tasks.running(TaskKind::program); }
    bool refused() const noexcept { return program_ && !program_->released() && !outdated_ && !edited_; }
    bool exportable() const noexcept { return program_ && program_->released() && !outdated_ && !edited_; }

    void post(const QString& name); ///< @param name of the program
    /// Gives a refused program, posted or written by hand, the reason why it is wanted; an entry of the undo stack.
    void overrideCheck(const QString& name, const QString& reason);
    /// The text as the user wrote it; no program to be exported until it is checked. The editor has an undo of its own;
    /// whatever takes the text's place then is an entry of the undo stack.
    void editText(const QString& text);
    void checkText(const QString& name); ///< @param name of the program
    void setGougeTolerance(double millimetres);
    void exportTo(const std::filesystem::path& file);
    void pathChanged();   ///< what was posted is no longer the path
    void targetChanged(); ///< what was posted is for another machine or control

    void load(const std::vector<StoredProgram>& programs);

signals:
    void exported(const QString& file);

private:
    void take(const StoredProgram& posted, Result<CheckedProgram> outcome);
    /// What the panel shows: a checked program, and the text, which may have been edited since.
    struct Shown {
        std::shared_ptr<const CheckedProgram> program;
        QString text;
        bool edited = false;
    };
    ProgramRequest request(const QString& name) const;
    void show(const Shown& shown);
    void change(const Shown& next);
    void keep(const StoredProgram& posted, const CheckedProgram& program);
    void lintText();
    void becomeOutdated();

    BenchController& bench_;
    PathController& path_;
    const TargetController& target_;
    std::shared_ptr<const CheckedProgram> program_;
    QString storedText_;
    std::vector<LintMark> lint_;
    bool edited_ = false;
    double gougeTolerance_ = 0.02;
    std::optional<Error> problem_;
    bool outdated_ = true;
};

} // namespace burin

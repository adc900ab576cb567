// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "core/job/kept_program.h"
#include "core/job/restart_job.h"
#include "ui/workbench/path_controller.h"
#include "ui/workbench/target_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>
#include <set>

namespace burin {

/// The program: posted, read back and checked in the background. Only what passed its check leaves the house, or what
/// the user gave a reason for.
class ProgramController final : public Controller {
    Q_OBJECT
public:
    ProgramController(const Desk& desk, WorkpieceController& workpiece, PathController& path,
                      const TargetController& target, QObject* parent);

    /// The newest one; null: none yet.
    const std::shared_ptr<const CheckedProgram>& program() const noexcept { return program_; }
    /// Text of a program that the project held when it was opened, until a new one is posted.
    const QString& storedText() const noexcept { return storedText_; }
    /// The text was changed by hand since it was checked.
    bool edited() const noexcept { return edited_; }
    /// What the control may not take of the text as it is.
    const std::vector<LintMark>& lint() const noexcept { return lint_; }
    double gougeTolerance() const noexcept { return gougeTolerance_; } ///< mm
    /// mm, as VerifyRequest::excessTolerance; 0: what is left is not judged.
    double excessTolerance() const noexcept { return excessTolerance_; }
    const std::optional<Error>& problem() const noexcept { return problem_; }
    /// There is none, or something that it was made of is not as it was.
    bool outdated() const;
    /// One is made or checked, or will be as soon as the workpiece has changed.
    bool busy() const { return reading_ || interrupted_ || desk_.tasks.running(TaskKind::program); }
    /// A path of the job belongs into the program; all do until the user leaves one out.
    bool includes(std::int64_t path) const { return !leftOut_.contains(path); }
    bool refused() const noexcept { return program_ && !program_->released() && !outdated() && !edited_; }
    bool exportable() const noexcept { return program_ && program_->released() && !outdated() && !edited_; }

    /// There is a path that belongs into it, and that of the tool in force is up to date.
    bool postable() const;
    void post(const QString& name); ///< all paths of the job that belong into it. @param name of the program
    void include(std::int64_t path, bool wanted);
    /// What headers call the setup (setupTitle, core/job/setup_title.h).
    void setSetupName(std::string name) { setupName_ = std::move(name); }
    /// Gives a refused program, posted or written by hand, the reason why it is exported; an entry of the undo stack.
    void overrideCheck(const QString& name, const QString& reason);
    /// The text as the user wrote it; no program to be exported until it is checked. The editor has an undo of its own;
    /// whatever takes the text's place then is an entry of the undo stack.
    void editText(const QString& text);
    /// Another text in its place, such as a program of somebody else; an entry of the undo stack. It is unchecked.
    void openText(const QString& text);
    /// What is typed while it is checked stays, unchecked; what the check gave is dropped then. So it is with `post`.
    void checkText(const QString& name); ///< @param name of the program
    void setGougeTolerance(double millimetres);
    void setExcessTolerance(double millimetres);
    void exportTo(const std::filesystem::path& file);
    /// There is a program whose rest can be made: one that was checked and that nobody changed since.
    bool restartable() const {
        return program_ && !edited_ && workpiece_.milling() && !workpiece_.changing() && !busy();
    }
    /// Makes the rest of the program from a line of its text on, and checks it on the stock that is left then; ends
    /// with `restarted` or `failed`. The program itself stays as it is. @param name of the rest
    void restart(std::uint32_t line, const QString& name);
    /// Writes the rest of a program. @param reason why, though its check refused it: it and what was found stand in its
    /// header then; without one nothing that was refused is written.
    void exportRestart(const std::filesystem::path& file, const RestartedProgram& rest, const QString& reason = {});

    /// @return whether there was something to keep
    bool keepDraft(); ///< of what the user wrote and nobody checked: now, not in a moment

    /// @param draft text that was edited and not checked; empty: none
    /// @param kept the one that was checked last: it is believed as long as all that it was judged by is as it was
    void load(const std::vector<StoredProgram>& programs, const std::string& draft,
              const std::optional<ReopenedProgram>& kept = {});

signals:
    void exported(const QString& file);
    void restarted(const std::shared_ptr<const burin::RestartedProgram>& rest);
    void restartExported(std::uint32_t line, const QString& file);
    void textWanted(); ///< who has text that was not told yet tells it now

private:
    /// What a program is made of, besides its text: with anything else it would be another one.
    struct Basis {
        quint64 paths = 0; ///< version of paths and workpiece
        std::string dialect;
        NcUnits units = NcUnits::millimetre;
        double gougeTolerance = 0.0, excessTolerance = 0.0; ///< mm
        std::set<std::int64_t> leftOut;
        bool operator==(const Basis&) const = default;
    };
    Basis basis() const;
    /// Of a program that the project kept from an earlier session.
    struct Reopened {
        KeptProgram kept;
        bool upToDate = false; ///< all that it was judged by is as it was
    };
    /// What a program that is made in the background was asked for.
    struct Asked {
        StoredProgram posted;
        Basis basis;
        std::uint64_t judged = 0; ///< `judgedBasis` of the project then
        quint64 text = 0;         ///< version of the text then
        bool byHand = false;      ///< as below
    };
    void take(const Asked& asked, Result<CheckedProgram> outcome);
    /// What the panel shows: a checked program, and the text, which may have been edited since.
    struct Shown {
        std::shared_ptr<const CheckedProgram> program;
        QString text;
        bool edited = false;
        Basis basis;
        bool byHand = false;                  ///< the user wrote in the text: it can't be posted anew
        std::uint64_t judged = 0;             ///< as above
        std::shared_ptr<Reopened> reopened{}; ///< null: it is of this session
    };
    std::vector<StoredPath> postedPaths() const;
    using Matters = std::vector<PathMatter>;
    ProgramRequest request(const QString& name) const;
    StoredProgram stored(const ProgramRequest& request) const;
    /// @param then gets the matters, and `judgedBasis`
    void read(const std::vector<StoredPath>& paths, std::function<void(Matters, std::uint64_t)> then);
    void postPaths(Matters matters, const ProgramRequest& wanted, const Asked& asked);
    void check(Matters matters, ProgramRequest wanted, const Asked& asked);
    void show(const Shown& shown);
    void change(const Shown& next);
    void keep(const StoredProgram& posted, const CheckedProgram& program);
    void lintText();
    void storeDraft();
    void storeProgram();
    Shown shown() const;
    void takeKept(const ReopenedProgram& kept);
    void judgeReopened();
    void stop();
    void goOn();

    WorkpieceController& workpiece_;
    PathController& path_;
    const TargetController& target_;
    std::shared_ptr<const CheckedProgram> program_;
    QString storedText_;
    std::vector<LintMark> lint_;
    bool edited_ = false, byHand_ = false, reading_ = false;
    Basis basis_;                        ///< of the program in force
    std::uint64_t judged_ = 0;           ///< `judgedBasis` of that one
    std::shared_ptr<Reopened> reopened_; ///< null: it is of this session
    QTimer judgeSoon_;
    std::function<void()> asked_;       ///< what the user asked for last: asks for it once more
    std::function<void()> interrupted_; ///< the same where a change of the workpiece came in between; null: none did
    quint64 generation_ = 0;            ///< of what is read for a program
    quint64 textVersion_ = 0;
    std::set<std::int64_t> leftOut_;
    QTimer draftDue_; ///< the project follows the typing a moment later
    std::string setupName_;
    double gougeTolerance_ = 0.02, excessTolerance_ = 0.1;
    std::optional<Error> problem_;
};

} // namespace burin

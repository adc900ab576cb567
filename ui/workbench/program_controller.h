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

/// The program: posted, read back and checked in the background. Only a program that passed its check, or for which the
/// user stated a reason, can be exported.
class ProgramController final : public Controller {
    Q_OBJECT
public:
    ProgramController(const Desk& desk, WorkpieceController& workpiece, PathController& path,
                      const TargetController& target, QObject* parent);

    /// The newest program; null: none yet.
    const std::shared_ptr<const CheckedProgram>& program() const noexcept { return program_; }
    /// Text of the program that the project held when it was opened, until a new one is posted.
    const QString& storedText() const noexcept { return storedText_; }
    /// Whether the text was edited by hand since it was checked.
    bool edited() const noexcept { return edited_; }
    /// Parts of the present text that the control may not accept.
    const std::vector<LintMark>& lint() const noexcept { return lint_; }
    double gougeTolerance() const noexcept { return gougeTolerance_; } ///< mm
    /// mm, as VerifyRequest::excessTolerance; 0: excess is not judged.
    double excessTolerance() const noexcept { return excessTolerance_; }
    const std::optional<Error>& problem() const noexcept { return problem_; }
    /// Whether there is no program, or something that it was made from has changed.
    bool outdated() const;
    /// The newest program, if neither it nor anything that it was made from has changed since the check, and its
    /// workpiece exists; else null.
    std::shared_ptr<const CheckedProgram> upToDate() const;
    /// Whether a program is being made or checked, or will be as soon as the workpiece has changed.
    bool busy() const { return reading_ || interrupted_ || desk_.tasks.running(TaskKind::program); }
    /// Whether a path of the job is part of the program; all are until the user excludes one.
    bool includes(std::int64_t path) const { return !leftOut_.contains(path); }
    bool refused() const noexcept { return program_ && !program_->released() && !outdated() && !edited_; }
    bool exportable() const noexcept { return program_ && program_->released() && !outdated() && !edited_; }

    /// Whether at least one path is included, and the path of the tool in force is up to date.
    bool postable() const;
    void post(const QString& name); ///< Posts all included paths of the job. @param name of the program
    void include(std::int64_t path, bool wanted);
    /// Sets the name of the setup in headers (setupTitle, core/job/setup_title.h).
    void setSetupName(std::string name) { setupName_ = std::move(name); }
    /// States the reason why a refused program, posted or written by hand, is exported; an entry of the undo stack.
    void overrideCheck(const QString& name, const QString& reason);
    /// Sets the text as edited by the user; it can't be exported until it is checked. The editor has an undo of its
    /// own; any later replacement of the text is an entry of the undo stack.
    void editText(const QString& text);
    /// Replaces the text, for example by that of a foreign program; an entry of the undo stack. The new text is
    /// unchecked.
    void openText(const QString& text);
    /// Text typed during the check is kept, unchecked; the result of the check is then discarded. The same applies to
    /// `post`.
    void checkText(const QString& name); ///< @param name of the program
    void setGougeTolerance(double millimetres);
    void setExcessTolerance(double millimetres);
    void exportTo(const std::filesystem::path& file);
    /// Whether the program can be restarted from a line: it was checked and not edited since.
    bool restartable() const {
        return program_ && !edited_ && workpiece_.milling() && !workpiece_.changing() && !busy();
    }
    /// Makes the remaining program from a line of its text on, and checks it on the stock that is left at that line;
    /// ends with `restarted` or `failed`. The program itself is not changed. @param name of the remaining program
    void restart(std::uint32_t line, const QString& name);
    /// Writes the remaining program. @param reason why it is exported although its check refused it: the reason and the
    /// findings are written to its header. A refused program without a reason is not written.
    void exportRestart(const std::filesystem::path& file, const RestartedProgram& rest, const QString& reason = {});

    /// @return whether there was something to store
    bool keepDraft(); ///< stores text that was edited and not checked, at once instead of after a delay

    /// @param draft text that was edited and not checked; empty: none
    /// @param kept the program that was checked last: its verdict holds as long as everything that it was judged by is
    /// unchanged
    void load(const std::vector<StoredProgram>& programs, const std::string& draft,
              const std::optional<ReopenedProgram>& kept = {});

signals:
    void exported(const QString& file);
    void restarted(const std::shared_ptr<const burin::RestartedProgram>& rest);
    void restartExported(std::uint32_t line, const QString& file);
    void textRequested(); ///< receivers with text not passed on yet must pass it on now

private:
    /// What a program is made from, besides its text: if any of it changes, the program is out of date.
    struct Basis {
        quint64 paths = 0; ///< version of paths and workpiece
        std::string dialect;
        NcUnits units = NcUnits::millimetre;
        double gougeTolerance = 0.0, excessTolerance = 0.0; ///< mm
        std::set<std::int64_t> leftOut;
        bool operator==(const Basis&) const = default;
    };
    Basis basis() const;
    /// State of a program that the project kept from an earlier session.
    struct Reopened {
        KeptProgram kept;
        bool upToDate = false; ///< whether everything that it was judged by is unchanged
    };
    /// The circumstances in which a program was requested.
    struct Asked {
        StoredProgram posted;
        Basis basis;
        std::uint64_t judged = 0; ///< `judgedBasis` of the project at that time
        quint64 text = 0;         ///< version of the text at that time
        bool byHand = false;      ///< as below
    };
    void take(const Asked& asked, Result<CheckedProgram> outcome);
    /// What the panel shows: a checked program, and the text, which may have been edited since.
    struct Shown {
        std::shared_ptr<const CheckedProgram> program;
        QString text;
        bool edited = false;
        Basis basis;
        bool byHand = false;                  ///< the user edited the text: it can't be posted again
        std::uint64_t judged = 0;             ///< as above
        std::shared_ptr<Reopened> reopened{}; ///< null: made in this session
    };
    std::vector<StoredPath> postedPaths() const;
    using Matters = std::vector<PathMatter>;
    ProgramRequest request(const QString& name) const;
    std::shared_ptr<KeptCheck> kept();
    StoredProgram stored(const ProgramRequest& request) const;
    /// @param strokes whether what was recorded is read as well @param then gets the matters and `judgedBasis`
    void read(const std::vector<StoredPath>& paths, bool strokes, std::function<void(Matters, std::uint64_t)> then);
    /// The same with strokes only where a path has to be evaluated: the others come as the view shows them.
    void readWhatIsNeeded(const std::vector<StoredPath>& paths, quint64 version,
                          const std::function<void(Matters, std::uint64_t)>& then);
    bool takeEvaluated(Matters& matters, quint64 version) const;
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
    std::uint64_t judged_ = 0;           ///< `judgedBasis` of the program in force
    std::shared_ptr<Reopened> reopened_; ///< null: made in this session
    QTimer judgeSoon_;
    std::shared_ptr<KeptCheck> kept_; ///< of the checks on `keptOn_`; null: none
    std::weak_ptr<MillingContext> keptOn_;
    std::function<void()> asked_;       ///< repeats the user's last request
    std::function<void()> interrupted_; ///< the same, set if a change of the workpiece interrupted it; null: none did
    quint64 generation_ = 0;            ///< of reading the project for a program
    quint64 textVersion_ = 0;
    std::set<std::int64_t> leftOut_;
    QTimer draftDue_; ///< the project is updated a moment after typing
    std::string setupName_;
    double gougeTolerance_ = 0.02, excessTolerance_ = 0.1;
    std::optional<Error> problem_;
};

} // namespace burin

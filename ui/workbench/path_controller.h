// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/project/job_paths.h"
#include "ui/workbench/bench_controller.h"

#include <memory>
#include <optional>

namespace burin {

/// The job's paths, one for each tool: all recordings made with it, with their edits. That of the tool in force is
/// evaluated in the background; a change while it is evaluated replaces that evaluation.
class PathController final : public Controller {
    Q_OBJECT
public:
    PathController(const Desk& desk, BenchController& bench, QObject* parent);

    /// Of the tool in force; null: it has none yet.
    const StoredPath* stored() const;
    /// What the job mills with, a path for each tool, in the order in which they were made.
    std::vector<StoredPath> jobPaths() const;
    /// The tool of one of them, by id; empty: it is none.
    std::string toolOf(std::int64_t path) const;
    /// Tools that have recordings and no path, by id.
    std::vector<std::string> toolsWithoutPath() const;
    /// The tool in force has recordings.
    bool hasTakes() const;
    /// Of the newest evaluation that went well; null: none yet.
    const std::shared_ptr<const EvaluatedPath>& evaluated() const noexcept { return evaluated_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< of the newest evaluation
    bool outdated() const noexcept { return outdated_; }
    bool busy() const { return reading_ || interrupted_ || desk_.tasks.running(TaskKind::path); }
    /// A path that the project holds is evaluated as soon as the workpiece stands.
    bool waiting() const { return stored() != nullptr && !evaluated_ && bench_.embedding(); }
    /// Counts changes of edits, takes and what stands around, of any path: what was posted before is out of date.
    quint64 version() const noexcept { return version_; }

    void makeNew();                                       ///< the edits of the main job; undone where there was a path
    void changeEdit(std::size_t index, const Edit& edit); ///< an entry of the undo stack; evaluates it
    /// Entries of the undo stack; each evaluates the path. A new edit comes as late as the order of edits allows.
    /// @return its place
    std::size_t addEdit(const Edit& edit);
    void removeEdit(std::size_t index);
    void moveEdit(std::size_t from, std::size_t to);
    /// What the user chose of the path: edits that are added are meant for it. Nothing: for all of it.
    const std::optional<TakeStretch>& selection() const noexcept { return selection_; }
    void select(const Moment& moment);   ///< this one moment
    void selectTo(const Moment& moment); ///< everything from what was chosen to there; of one take
    void clearSelection();
    /// Moves a place of the path. Once more at the same place: the edit that is there moves it by so much more.
    /// @param by mm; @param along the part's surface, or freely
    void movePlace(const Moment& moment, const glm::dvec3& by, MovePoints::Along along);
    /// Puts a stroke that was drawn in the selection's stead. @param places mm, setup frame, at least two
    void replaceSelection(const std::vector<glm::dvec3>& places);
    void evaluate();
    void takesChanged(const std::vector<TakeInfo>& takes); ///< what was evaluated may be no longer what was recorded
    void benchChanged();                                   ///< links may go other ways, feeds be others
    void useTool(const std::string& id);                   ///< the tool in force

    void load(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes);

signals:
    void evaluatedAnew();
    void versionChanged();

private:
    struct Recorded {
        std::vector<Take> takes;
        Tool tool;
    };
    void push(const QString& text, std::vector<Edit> edits);
    void apply(std::int64_t path, const std::vector<Edit>& edits);
    void countVersion();
    void forgetEvaluation();
    void readTakes();
    void keepKnown(const StoredPath& path);
    void take(PathMatter matter);
    void evaluateMatter();
    void take(Result<EvaluatedPath> outcome);

    BenchController& bench_;
    std::vector<StoredPath> paths_; ///< all of the project
    std::vector<TakeInfo> recorded_;
    std::string tool_; ///< in force, by id
    std::optional<TakeStretch> selection_;
    std::shared_ptr<const EvaluatedPath> evaluated_;
    std::optional<Error> problem_;
    std::shared_ptr<const Recorded> matter_; ///< of the path in force; null: to be read again
    quint64 generation_ = 0;                 ///< of the recordings and the tool in force
    quint64 version_ = 0;
    quint64 loads_ = 0; ///< of projects
    bool outdated_ = true, reading_ = false;
    bool interrupted_ = false; ///< an evaluation was abandoned, as the bench changes
};

} // namespace burin

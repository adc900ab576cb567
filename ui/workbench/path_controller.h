// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/evaluate.h"
#include "ui/workbench/bench_controller.h"

#include <memory>
#include <optional>

namespace burin {

/// The path: all recordings made with the tool in force, with their edits, evaluated in the background. A change while
/// it is evaluated replaces that evaluation.
class PathController final : public Controller {
    Q_OBJECT
public:
    PathController(const Desk& desk, BenchController& bench, QObject* parent);

    const std::optional<StoredPath>& stored() const noexcept { return stored_; }
    /// Of the newest evaluation that went well; null: none yet.
    const std::shared_ptr<const EvaluatedPath>& evaluated() const noexcept { return evaluated_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< of the newest evaluation
    bool outdated() const noexcept { return outdated_; }
    bool busy() const { return reading_ || interrupted_ || desk_.tasks.running(TaskKind::path); }
    /// A path that the project holds is evaluated as soon as the workpiece stands.
    bool waiting() const { return stored_ && !evaluated_ && bench_.embedding(); }

    void makeNew();                                       ///< with the edits of the main job; evaluates it
    void changeEdit(std::size_t index, const Edit& edit); ///< an entry of the undo stack; evaluates it
    /// Entries of the undo stack; each evaluates the path. A new edit comes as late as the order of edits allows.
    void addEdit(const Edit& edit);
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
    void takesChanged(); ///< what was evaluated may be no longer what was recorded

    void load(const std::vector<StoredPath>& paths);

signals:
    void evaluatedAnew();

private:
    using Takes = std::shared_ptr<const std::vector<Take>>;
    void push(const QString& text, std::vector<Edit> edits);
    void apply(const std::vector<Edit>& edits);
    void readTakes();
    void evaluateTakes(const Takes& takes);
    void take(Result<EvaluatedPath> outcome);

    BenchController& bench_;
    std::optional<StoredPath> stored_;
    std::optional<TakeStretch> selection_;
    std::shared_ptr<const EvaluatedPath> evaluated_;
    std::optional<Error> problem_;
    Takes takes_;            ///< as they were read; null: to be read again
    std::string takesTool_;  ///< id of the tool that they were made with
    quint64 generation_ = 0; ///< of the recordings
    bool outdated_ = true, reading_ = false;
    bool interrupted_ = false; ///< an evaluation was abandoned, as the bench changes
};

} // namespace burin

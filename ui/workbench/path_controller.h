// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "core/job/program_path.h"
#include "ui/workbench/job_evaluation.h"
#include "ui/workbench/tool_controller.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace burin {

/// A pass that was computed again.
struct ReplacedPass {
    GeneratedMoves moves;
    std::int64_t instead = 0; ///< id of the pass whose position it takes
};

/// The job's paths, one for each tool: all recordings made with it, with their edits. They are evaluated in the
/// background; a change while a path is being evaluated restarts its evaluation. Edits apply to the path of the tool in
/// force.
class PathController final : public Controller {
    Q_OBJECT
public:
    PathController(const Desk& desk, WorkpieceController& workpiece, const ToolController& tools, QObject* parent);

    /// Path of the tool in force; null if it has none or nothing is milled with it.
    const StoredPath* stored() const;
    /// The paths of the job, one for each tool, in the order of milling.
    std::vector<StoredPath> jobPaths() const;
    /// All paths of the setup, also those that the job does not mill.
    const std::vector<StoredPath>& all() const noexcept { return paths_; }
    /// Id of the tool of a path; empty if it is not one of the job's paths.
    std::string toolOf(std::int64_t path) const;
    /// Ids of the tools that have recordings but no path.
    std::vector<std::string> toolsWithoutPath() const;
    std::vector<std::string> toolsThatMilled() const; ///< ordered by first use
    /// Whether any path contains computed passes: part and stock must not change then.
    bool hasPasses() const { return !generatedInUse().empty(); }
    /// Whether the tool in force has recordings.
    bool hasTakes() const;
    /// Result of the newest successful evaluation; null: none yet.
    std::shared_ptr<const EvaluatedPath> evaluated() const { return evaluation_.evaluated(inForce()); }
    std::optional<Error> problem() const; ///< of the newest evaluation
    bool outdated() const { return !evaluation_.isCurrent(inForce()); }
    bool busy() const { return making_ || evaluation_.busy(inForce()); }
    /// Whether a path of the project is evaluated as soon as the workpiece is ready.
    bool waiting() const { return stored() != nullptr && !evaluated() && workpiece_.embedding(); }
    /// Current evaluation of any of the job's paths on top of those before it; null if still to be done.
    std::shared_ptr<const EvaluatedPath> current(std::int64_t path) const;
    /// Ids of tools whose paths come before that of the tool in force and can't be evaluated; they are treated as not
    /// milled.
    std::vector<std::string> toolsMissingBefore() const;
    /// The newest evaluations of the other tools' paths, in the order in which they are milled.
    std::vector<std::shared_ptr<const EvaluatedPath>> others() const;
    /// Counts changes of edits, takes, fixtures and limits, of any path: programs posted before are out of date.
    quint64 version() const noexcept { return version_; }

    /// Creates paths for the tool in force and all others that have recordings and no path, with the edits of the main
    /// job; if the tool in force has a path, resets its edits to these. An entry of the undo stack.
    void makeNew();
    /// Adds a computed pass as the last source of its tool's path, or of a new path. An entry of the undo stack.
    /// @param tool of the pass; it is added to the project @param instead the pass of that path that it replaces
    void addPass(const GeneratedMoves& moves, const Tool& tool, std::optional<std::int64_t> instead = std::nullopt);
    /// Replaces passes of its tool's path. One entry of the undo stack.
    void replacePasses(const std::vector<ReplacedPass>& passes, const Tool& tool);
    /// Adds the passes of a program as the last sources of the paths of their tools, or of new paths. An entry of the
    /// undo stack.
    void addProgram(const std::vector<ProgramPass>& passes);
    /// The path of a take's tool, whether it mills the take or not; null if there is none. It mills a copy of a take
    /// only if the user requests that.
    const StoredPath* pathFor(std::int64_t take) const;
    bool isMilled(std::int64_t take) const; ///< whether that path mills the take
    /// Adds a copy of a take to that path as its last source, or removes it unless it is the only source. An entry of
    /// the undo stack.
    void millTake(std::int64_t take, bool milled);
    /// Passes of the path in force, in its order.
    std::vector<GeneratedInfo> passes() const;
    void removePass(
        std::int64_t id); ///< of the path in force; a path without sources is removed. An entry of the undo stack.
    /// Moves a pass of the path in force before the source that precedes it. An entry of the undo stack.
    void movePassUp(std::int64_t id);
    void changeEdit(std::size_t index, const Edit& edit); ///< an entry of the undo stack; evaluates the path
    /// Entries of the undo stack; each evaluates the path. A new edit is inserted as late as the order of edits allows.
    /// @return its index; the number of edits if it was refused
    std::size_t addEdit(const Edit& edit);
    void removeEdit(std::size_t index);
    void moveEdit(std::size_t from, std::size_t to);
    /// The part of the path that the user selected, to which new edits apply. Empty: they apply to the whole path.
    const std::optional<SourceInterval>& selection() const noexcept { return selection_; }
    void select(const Moment& moment);   ///< selects a single moment
    void selectTo(const Moment& moment); ///< extends the selection to `moment`, of the same take
    void clearSelection();
    /// The point that the user looks at, as the worst one of an edit, or the selection. Empty: neither. Source 0: a
    /// point without a moment.
    const std::optional<SourceInterval>& pointed() const noexcept { return pointed_ ? pointed_ : selection_; }
    bool pointsElsewhere() const noexcept { return pointed_.has_value(); } ///< than to the selection
    /// Points at a moment and keeps the selection.
    void pointAt(const Moment& moment);
    /// Inserts a point into the path and selects it.
    void insertPoint(const InsertPoint& edit);
    /// Moves a point that an edit inserted. @param index of the edit @param by mm
    void moveInserted(std::size_t index, const glm::dvec3& by);
    /// Moves a point of the path. Moving the same point again adds to the existing edit.
    /// @param by mm @param along the part's surface, or freely
    void movePlace(const Moment& moment, const glm::dvec3& by, MovePoints::Along along);
    /// Replaces the selection by a drawn stroke. @param places mm, setup frame, at least two
    void replaceSelection(const std::vector<glm::dvec3>& places);
    void evaluate();
    /// Called when recordings have changed: results may no longer match the recordings, or match them again.
    /// @param all takes of the project @param standing those whose strokes were not all undone
    /// @param newestStrokes as returned by MillController::newestStrokes
    void takesChanged(const std::vector<TakeInfo>& all, const std::vector<TakeInfo>& standing,
                      const std::map<std::int64_t, std::uint64_t>& newestStrokes);
    void forgetTake(std::int64_t take);  ///< no path mills it any more; the project has stored that, or is about to
    void recordingBegins();              ///< nothing is evaluated during milling by hand
    void workpieceRemade();              ///< links and feeds may change
    void useTool(const std::string& id); ///< the tool in force

    void load(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes,
              const std::vector<GeneratedInfo>& generated);

signals:
    void evaluatedAnew(); ///< for the path of the tool in force
    /// JobEvaluation::firstResult
    void firstResult(const std::shared_ptr<const burin::EvaluatedPath>& path);
    void othersChanged();
    void versionChanged();

private:
    std::int64_t inForce() const;                            ///< id of its path; 0: none
    const StoredPath* pathOf(const std::string& tool) const; ///< null if it has none
    void dropChoice();
    void updateJob();
    void push(const QString& text, std::vector<Edit> edits);
    void apply(std::int64_t path, const std::vector<Edit>& edits);
    void countVersion();
    bool isMilledWith(const std::string& tool) const;
    std::vector<GeneratedInfo> generatedInUse() const;
    /// Moves that are added as a source of their tool's path.
    struct NewSource {
        GeneratedMoves moves;
        Tool tool;
        std::function<StoredPath(StoredPath path, std::int64_t source)> into; ///< called on the project's thread
    };
    struct ChangedPath {
        StoredPath before, after; ///< `before` without an id: the path is new
    };
    struct AddedSources;
    void addSources(const QString& text, std::vector<NewSource> added);
    void keepSources(const QString& text, const AddedSources& added, const SharedStep& step);
    void learn(const std::vector<GeneratedInfo>& sources);
    void applySources(std::int64_t path, const std::vector<PathSource>& sources);
    RecordedKey recordedKey(const std::string& tool) const;
    void followRecordings();
    void keepNew(const std::vector<StoredPath>& paths, const std::vector<GeneratedInfo>& sources,
                 const SharedStep& step);
    void setPresent(const std::vector<StoredPath>& paths, bool present);
    void keepTakes(const StoredPath& path);

    WorkpieceController& workpiece_;
    const ToolController& tools_;
    JobEvaluation evaluation_;
    std::optional<Error> notMade_;    ///< why no path could be made for the tool in force
    std::vector<StoredPath> paths_;   ///< all of the project
    std::vector<SourceInfo> sources_; ///< all of the project
    std::vector<GeneratedInfo> generated_;
    std::vector<TakeInfo> standing_; ///< those with strokes in effect: a tool without them has no path
    std::string tool_;               ///< in force, by id
    std::optional<SourceInterval> selection_, pointed_;
    std::map<std::int64_t, std::uint64_t> newestStrokes_;
    quint64 version_ = 0, newestVersion_ = 0;
    std::map<RecordedKey, quint64> versions_; ///< since edits, fixtures or limits were last changed
    quint64 loads_ = 0;                       ///< number of projects loaded
    bool making_ = false;
};

} // namespace burin

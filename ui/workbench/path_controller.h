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

/// The job's paths, one for each tool: all recordings made with it, with their edits. They are evaluated in the
/// background; a change while a path is evaluated replaces that evaluation. What is edited is the path of the tool in
/// force.
class PathController final : public Controller {
    Q_OBJECT
public:
    PathController(const Desk& desk, WorkpieceController& workpiece, const ToolController& tools, QObject* parent);

    /// Of the tool in force; null: it has none, or nothing is milled with it.
    const StoredPath* stored() const;
    /// What the job mills with, a path for each tool, in the order of milling.
    std::vector<StoredPath> jobPaths() const;
    /// The tool of one of them, by id; empty: it is none.
    std::string toolOf(std::int64_t path) const;
    /// Tools that have recordings and no path, by id.
    std::vector<std::string> toolsWithoutPath() const;
    std::vector<std::string> toolsThatMilled() const; ///< by when they first did
    /// Any path is made of computed passes: part and stock have to stay as they are.
    bool hasPasses() const { return !generatedInUse().empty(); }
    /// The tool in force has recordings.
    bool hasTakes() const;
    /// Of the newest evaluation that went well; null: none yet.
    std::shared_ptr<const EvaluatedPath> evaluated() const { return evaluation_.evaluated(inForce()); }
    std::optional<Error> problem() const; ///< of the newest evaluation
    bool outdated() const { return !evaluation_.isCurrent(inForce()); }
    bool busy() const { return making_ || evaluation_.busy(inForce()); }
    /// A path that the project holds is evaluated as soon as the workpiece stands.
    bool waiting() const { return stored() != nullptr && !evaluated() && workpiece_.embedding(); }
    /// Of any of the job's paths, as it is now and behind those that it comes after; null: still to be done.
    std::shared_ptr<const EvaluatedPath> current(std::int64_t path) const;
    /// Tools whose paths come before that of the tool in force and can't be evaluated, by id: it counts them as not
    /// milled.
    std::vector<std::string> toolsMissingBefore() const;
    /// The newest evaluations of the other tools' paths, in the order in which they are milled.
    std::vector<std::shared_ptr<const EvaluatedPath>> others() const;
    /// Counts changes of edits, takes and what stands around, of any path: what was posted before is out of date.
    quint64 version() const noexcept { return version_; }

    /// With the edits of the main job, of the tool in force and of all others that have recordings and no path; where
    /// the tool in force has one, its edits are these again. An entry of the undo stack.
    void makeNew();
    /// Keeps a computed pass as the last source of its tool's path, or of a new one. An entry of the undo stack.
    /// @param tool that it is for; the project gets it @param instead the pass of that path whose place it takes
    void addPass(const GeneratedMoves& moves, const Tool& tool, std::optional<std::int64_t> instead = std::nullopt);
    /// Keeps what a program mills as the last sources of its tools' paths, or of new ones. An entry of the undo stack.
    void addProgram(const std::vector<ProgramPass>& passes);
    /// Those of the path in force, in its order.
    std::vector<GeneratedInfo> passes() const;
    void removePass(
        std::int64_t id); ///< of the path in force; the path goes with its last source. An entry of the undo stack
    /// Mills a pass of the path in force before the source that is milled before it now. An entry of the undo stack.
    void movePassUp(std::int64_t id);
    void changeEdit(std::size_t index, const Edit& edit); ///< an entry of the undo stack; evaluates it
    /// Entries of the undo stack; each evaluates the path. A new edit comes as late as the order of edits allows.
    /// @return its place
    std::size_t addEdit(const Edit& edit);
    void removeEdit(std::size_t index);
    void moveEdit(std::size_t from, std::size_t to);
    /// What the user chose of the path: edits that are added are meant for it. Nothing: for all of it.
    const std::optional<SourceStretch>& selection() const noexcept { return selection_; }
    void select(const Moment& moment);   ///< this one moment
    void selectTo(const Moment& moment); ///< everything from what was chosen to there; of one take
    void clearSelection();
    /// Moves a place of the path. Once more at the same place: the edit that is there moves it by so much more.
    /// @param by mm; @param along the part's surface, or freely
    void movePlace(const Moment& moment, const glm::dvec3& by, MovePoints::Along along);
    /// Puts a stroke that was drawn in the selection's stead. @param places mm, setup frame, at least two
    void replaceSelection(const std::vector<glm::dvec3>& places);
    void evaluate();
    /// What was evaluated may be no longer what was recorded, or be it again.
    /// @param all of the project; @param standing those whose strokes were not all taken back; @param newestStrokes as
    /// MillController::newestStrokes has them
    void takesChanged(const std::vector<TakeInfo>& all, const std::vector<TakeInfo>& standing,
                      const std::map<std::int64_t, std::uint64_t>& newestStrokes);
    void recordingBegins();              ///< while the hand mills nothing is evaluated
    void workpieceRemade();              ///< links may go other ways, feeds be others
    void useTool(const std::string& id); ///< the tool in force

    void load(const std::vector<StoredPath>& paths, const std::vector<TakeInfo>& takes,
              const std::vector<GeneratedInfo>& generated);

signals:
    void evaluatedAnew(); ///< that of the tool in force
    void othersChanged();
    void versionChanged();

private:
    std::int64_t inForce() const; ///< id of its path; 0: none
    void updateJob();
    void push(const QString& text, std::vector<Edit> edits);
    void apply(std::int64_t path, const std::vector<Edit>& edits);
    void countVersion();
    bool isMilledWith(const std::string& tool) const;
    std::vector<GeneratedInfo> generatedInUse() const;
    /// Moves that become a source of their tool's path.
    struct NewSource {
        GeneratedMoves moves;
        Tool tool;
        std::function<StoredPath(StoredPath path, std::int64_t source)> into; ///< on the project's thread
    };
    struct ChangedPath {
        StoredPath before, after; ///< without an id before: it is new
    };
    struct AddedSources;
    void addSources(const QString& text, std::vector<NewSource> added);
    void keepSources(const QString& text, const AddedSources& added);
    void applySources(std::int64_t path, const std::vector<PathSource>& sources);
    RecordedKey recordedKey(const std::string& tool) const;
    void followRecordings();
    void keepNew(const std::vector<StoredPath>& paths);
    void setPresent(const std::vector<StoredPath>& paths, bool present);
    void keepTakes(const StoredPath& path);

    WorkpieceController& workpiece_;
    const ToolController& tools_;
    JobEvaluation evaluation_;
    std::optional<Error> notMade_;    ///< why there is no path of the tool in force
    std::vector<StoredPath> paths_;   ///< all of the project
    std::vector<SourceInfo> sources_; ///< all of the project
    std::vector<GeneratedInfo> generated_;
    std::vector<TakeInfo> standing_; ///< of these, the ones that strokes stand of: a tool without them has no path
    std::string tool_;               ///< in force, by id
    std::optional<SourceStretch> selection_;
    std::map<std::int64_t, std::uint64_t> newestStrokes_;
    quint64 version_ = 0, newestVersion_ = 0;
    std::map<RecordedKey, quint64> versions_; ///< since edits and what stands around were changed last
    quint64 loads_ = 0;                       ///< of projects
    bool making_ = false;
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/cad/model.h"
#include "core/document/kept_workpiece.h"
#include "core/document/program_target.h"
#include "core/machine/envelope.h"
#include "core/path/edit.h"
#include "core/path/path_source.h"
#include "core/recording/generated_moves.h"
#include "core/recording/sample_source.h"
#include "core/recording/take_order.h"
#include "core/setup/axis_mode.h"
#include "core/setup/kept_guides.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

class ProjectStep;
class StagedFile;
class WorkingCopy;

/// A path as stored in the project: sources plus edits; its points are evaluated and never stored as the original data.
struct StoredPath {
    std::int64_t id = 0;
    std::string name;
    std::vector<PathSource> sources; ///< all of `setup`
    std::vector<Edit> edits;
    SetupId setup = setupInUse;
};

/// A posted program with the report of the check that it passed.
struct StoredProgram {
    std::string name;
    std::string dialect;
    std::string machine;
    std::string text;
    std::string reportJson;
    SetupId setup = setupInUse; ///< the setup in which it is to be run
};

/// A named moment of a setup's recordings.
struct TimeMarker {
    TakeMoment at;
    std::string name;
    friend bool operator==(const TimeMarker&, const TimeMarker&) = default;
};

/// A setup of a job, as shown in lists.
struct SetupName {
    SetupId id = setupInUse;
    std::string name; ///< empty: not named
};

/// A .burin file: one SQLite database. All changes go to a journalled copy in the same folder (`.<name>.working`, WAL,
/// synchronous FULL); `save` writes a snapshot next to the file through SQLite's backup interface and renames it, so
/// the user's file is always complete. A working copy left behind by its owner (kill -9, power failure) is recovered by
/// `open`.
/// README.md describes the schema and the rules of recovery.
/// Not thread-safe: one thread at a time, except `TakeWriter`, which has a connection of its own.
class Project {
public:
    /// Creates a new project, which has only a working copy and no file yet. An existing project of that name is
    /// replaced by the first `save`; any other file is never replaced. Errors: fileNotWritable, diskFull, projectInUse,
    /// projectNotBurin (the existing file is not a project).
    static Result<Project> create(const std::filesystem::path& file);
    /// If the folder can't be written, the project is opened for reading only.
    /// Errors: fileNotFound, fileEmpty, projectNotBurin, fileFromNewerBurin, projectInUse (detail: "process 4711"),
    /// fileDamaged, fileNotReadable, fileNotWritable, diskFull.
    static Result<Project> open(const std::filesystem::path& file);
    /// Opens a project for viewing only: nothing is created or changed on the disk, which may be full; unsaved work
    /// that was left behind is shown (`recovered`) and stays. `readOnly` is true. Errors: as `open`, without those of
    /// writing.
    static Result<Project> openForReading(const std::filesystem::path& file);
    ~Project(); ///< discards the working copy if everything in it was saved, keeps it otherwise
    Project(Project&&) noexcept;
    Project& operator=(Project&&) noexcept;

    /// The user's file, absolute; after `saveAs`, the new name.
    const std::filesystem::path& file() const noexcept;
    /// Whether `open` recovered a working copy that an earlier run left behind.
    bool recovered() const noexcept;
    /// A leftover working copy that doesn't belong to the current file, moved to a user-visible name; empty if there
    /// was none.
    const std::filesystem::path& keptAside() const noexcept;
    /// The new name of the earlier file, if the last `save` replaced a file of an older format; empty: it already had
    /// the present format.
    const std::filesystem::path& keptEarlier() const noexcept;
    /// Whether nothing can be changed: setters, `beginTake` and `save` then return fileNotWritable.
    bool readOnly() const noexcept;
    /// Whether something was changed since the last `save`. Errors: fileDamaged.
    Result<bool> unsaved() const;
    /// Recordings may continue meanwhile; the file then holds what they had written when the save began.
    /// Errors: diskFull, fileNotWritable; the file is then unchanged.
    Result<void> save();
    /// Moves `outputs`, which must be flushed, to their final names together with the project's file: all or none.
    Result<void> save(std::span<StagedFile> outputs);
    /// Saves under another name and continues with that file; the old file stays as it was last saved. An existing file
    /// of the new name is replaced if it is a project that nobody has open. Afterwards `readOnly` is false.
    /// Errors: as `save`, projectInUse, projectNotBurin, argumentInvalid (a take is being recorded); nothing has
    /// changed then.
    Result<void> saveAs(const std::filesystem::path& file);
    /// Records from now on which rows change, until `endStep`; of recordings only what this object changes. A step that
    /// was begun before is dropped. Errors: outOfMemory.
    Result<void> beginStep();
    /// Returns what has changed since `beginStep`; null: nothing. Errors: outOfMemory.
    Result<std::shared_ptr<const ProjectStep>> endStep();
    /// Makes the rows of a step what they were before it, whatever has become of them since. What belongs to a setup
    /// that no longer exists then is removed too; its takes are hidden as by `removeTake`. The setup in use is not
    /// changed, and may be one that no longer exists. Returns the step in the other direction; null: nothing changed.
    /// Errors: as the setters; nothing has changed then.
    Result<std::shared_ptr<const ProjectStep>> revert(const ProjectStep& step);
    /// Discards all unsaved changes: the working copy is removed with this object, including any later changes to it,
    /// and the next `open` finds the file as it was saved. Needs no free space on the disk.
    void abandonChanges() noexcept;

    // Each setter is one transaction; errors: diskFull, fileNotWritable. Each getter: fileDamaged, projectIncomplete.
    // Lists are empty if nothing was stored yet; for single values the error is then projectIncomplete.
    Result<void> setModel(const Model& model);
    Result<void> setBodyColours(const std::vector<BodyColour>& colours); ///< of the model's bodies, in order
    Result<Model> model() const;                                         ///< in its own frame
    /// The model as placed in a setup. Errors: also nameUnknown; in the model's own frame if nothing is embedded there
    /// yet.
    Result<std::shared_ptr<const Model>> placedModel(SetupId id = setupInUse) const;
    // One setup of a project is in use: functions for the data of a setup take its id, and by default use the setup in
    // use. Further error: nameUnknown (there is no setup of that id).

    /// In the order of their creation; there is always at least one.
    Result<std::vector<SetupName>> setups() const;
    /// Adds an empty setup and returns its id. It is not in use yet.
    Result<SetupId> addSetup(const std::string& name);
    Result<void> nameSetup(SetupId id, const std::string& name);
    /// Removes a setup with its stock, fixtures and guides. Errors: argumentInvalid (it is in use; it holds recordings,
    /// generated moves, paths or programs; or another setup's stock comes from it).
    Result<void> removeSetup(SetupId id);
    /// Selects the setup in use; initially the first one. This does not change the project itself.
    Result<void> useSetup(SetupId id);
    SetupId usedSetup() const noexcept;
    Result<void> setSetup(const Setup& setup, SetupId id = setupInUse);
    Result<Setup> setup(SetupId id = setupInUse) const;
    /// Materials of the setups by id, in their order, as they were when the setups were made. Materials used by setups
    /// other than the one in use stay.
    Result<void> setMaterials(const std::vector<Property>& materials);
    Result<std::vector<Property>> materials() const;
    Result<void> setTool(const Tool& tool); ///< replaces the one of the same id
    Result<std::vector<Tool>> tools() const;
    /// The fixtures and limits around the stock; replaces the previous list. Errors: also those of checkObstacle.
    Result<void> setObstacles(const std::vector<Obstacle>& obstacles, SetupId setup = setupInUse);
    Result<std::vector<Obstacle>> obstacles(SetupId setup = setupInUse) const;
    /// The control of the tool's axis from now on; takes store the axis of each sample. +Z if nothing was stored.
    /// Errors: also argumentInvalid (a direction that is not of unit length).
    Result<void> setAxisMode(const AxisMode& axis, SetupId setup = setupInUse);
    Result<AxisMode> axisMode(SetupId setup = setupInUse) const;
    /// The position of the machine's travel; determined by travelEnvelope if nothing was stored.
    Result<void> setTravelPlacement(const TravelPlacement& placement, SetupId setup = setupInUse);
    Result<TravelPlacement> travelPlacement(SetupId setup = setupInUse) const;
    /// Machine and dialect of the programs; those of the first machine if nothing was stored.
    Result<void> setProgramTarget(const ProgramTarget& target, SetupId setup = setupInUse);
    Result<ProgramTarget> programTarget(SetupId setup = setupInUse) const;
    /// The text of a program that the user is editing and that was not checked since. Empty: none.
    Result<void> setProgramDraft(const std::string& text, SetupId setup = setupInUse);
    Result<std::string> programDraft(SetupId setup = setupInUse) const;
    /// The state of the user's session (step, camera, …), a JSON text for the window. It is stored with the next
    /// `save`, but does not count as an unsaved change.
    Result<void> setLeftAt(const std::string& json);
    Result<std::string> leftAt() const; ///< empty: nothing was stored
    /// The program that was checked last, in the format of `keptProgramToJson`. Empty: none.
    Result<void> setKeptProgram(const std::string& json, SetupId setup = setupInUse);
    Result<std::string> keptProgram(SetupId setup = setupInUse) const;
    /// Returns a value that changes with any bit of part and materials, and of a setup, its fixtures and limits, its
    /// recordings and paths.
    Result<std::int64_t> jobDigest(SetupId setup = setupInUse) const;
    /// The guides of the hand; replaces the previous ones. Errors: also those of checkGuide.
    Result<void> setGuides(const KeptGuides& guides, SetupId setup = setupInUse);
    Result<KeptGuides> guides(SetupId setup = setupInUse) const;

    /// All takes of a setup, complete or not, in the order set by `setTakeOrder`, by default that of their recording.
    Result<std::vector<TakeInfo>> takes(SetupId setup = setupInUse) const;
    /// The order of the takes, including removed ones, which keep their positions.
    Result<TakeOrder> takeOrder(SetupId setup = setupInUse) const;
    /// Sets the order in which takes are replayed and listed. Takes that it does not contain follow in the order of
    /// their recording, as do takes recorded later. Errors: nameUnknown (not a take of the setup), argumentInvalid (a
    /// take occurs twice).
    Result<void> setTakeOrder(const TakeOrder& order, SetupId setup = setupInUse);
    /// Copies a take to the end of the setup's takes, with the same samples, undone strokes and intervals switched off,
    /// and with the name "NAME (copy)". Returns the id of the copy. Errors: as `take`.
    Result<std::int64_t> duplicateTake(std::int64_t id);
    /// Errors: nameUnknown, projectIncomplete (there is no recording).
    Result<Take> take(std::int64_t id) const;
    /// The same without its samples. Errors: as `take`.
    Result<TakeOutline> takeOutline(std::int64_t id) const;
    /// Visits all samples of a take, including undone ones; the memory used does not grow with their number.
    /// @param visit must not use the project. Errors: as `take`, those of `visit`.
    Result<void> visitSamples(std::int64_t id, const SampleVisitor& visit) const;
    /// Returns one sample of a take, undone or not. Errors: as `take`, argumentInvalid (`index` is out of range).
    Result<Sample> sample(std::int64_t take, std::uint64_t index) const;
    /// Removes a take: it no longer counts and is accessible only to `restoreTake`. The next opening of the project
    /// deletes it permanently. Errors: as `take`, argumentInvalid while a path uses it.
    Result<void> removeTake(std::int64_t id);
    /// Restores a removed take. Errors: nameUnknown (no removed take has this number).
    Result<void> restoreTake(std::int64_t id);

    /// The current state.
    Result<RecordedState> recordedState(SetupId setup = setupInUse) const;
    /// Stores the workpiece at a moment, replacing an earlier one of that moment, if the setup is still in the state in
    /// which the workpiece was made. The things that it is made of are noted with it: when any of them changes, it is
    /// no longer valid. When many are stored, older ones are thinned out. It is stored with the next `save`, but does
    /// not count as an unsaved change.
    Result<void> keepWorkpiece(const KeptWorkpiece& kept, const RecordedState& madeIn, SetupId setup = setupInUse);
    /// Moments with a stored and valid workpiece, in order.
    Result<std::vector<TakeMoment>> keptMoments(SetupId setup = setupInUse) const;
    /// Errors: fileDamaged (also if none is stored).
    Result<KeptWorkpiece> keptWorkpiece(const TakeMoment& at, SetupId setup = setupInUse) const;

    /// Notes that an interval of a take was undone: its samples stay, but no longer count. The take may still be
    /// recording, and the interval may extend beyond what the recorder has written. Errors: nameUnknown (the take),
    /// argumentInvalid (an empty interval, or one that overlaps another).
    Result<void> undoInterval(std::int64_t take, const SampleRange& interval);
    /// Removes such a note. Errors: argumentInvalid (there is no note of exactly this interval).
    Result<void> redoInterval(std::int64_t take, const SampleRange& interval);
    /// Switches samples of a take off until they are switched on again: like undone samples they do not count, whether
    /// or not they were also undone. @param off all intervals of the take that are to be off; ascending, disjoint,
    /// within its samples
    /// Errors: nameUnknown, argumentInvalid (intervals that are not so).
    Result<void> setSwitchedOff(std::int64_t take, std::span<const SampleRange> off);
    Result<std::vector<SampleRange>> switchedOff(std::int64_t take) const;
    /// The undone intervals of a take, whether they are also switched off or not, in ascending order and separate.
    Result<std::vector<SampleRange>> takenBack(std::int64_t take) const;
    /// Named moments, in order; replaces the previous list.
    Result<void> setMarkers(std::span<const TimeMarker> markers, SetupId setup = setupInUse);
    Result<std::vector<TimeMarker>> markers(SetupId setup = setupInUse) const;
    /// Errors: nameUnknown.
    Result<void> nameTake(std::int64_t take, const std::string& name);

    /// The data that planners generated for a setup, without the moves.
    Result<std::vector<GeneratedInfo>> generated(SetupId setup = setupInUse) const;
    /// Errors: nameUnknown.
    Result<GeneratedMoves> generatedMoves(std::int64_t id) const;
    /// Adds generated moves and returns their id; `moves.info.id` is ignored, and no id is ever reused. Generated moves
    /// are never changed: running a planner again makes new ones, from which the path is then made. Errors: those of
    /// checkGenerated, nameUnknown (the setup).
    Result<std::int64_t> addGenerated(const GeneratedMoves& moves);
    /// Errors: nameUnknown, argumentInvalid while a path uses them.
    Result<void> removeGenerated(std::int64_t id);

    /// Adds a path and returns its id; `path.id` is ignored. Errors: nameUnknown (a source), argumentInvalid (a source
    /// of another setup).
    Result<std::int64_t> addPath(const StoredPath& path);
    /// Errors: nameUnknown (the path, a source), argumentInvalid (a source of another setup).
    Result<void> setPath(const StoredPath& path);
    /// The id of a removed path is never reused. Errors: nameUnknown.
    Result<void> removePath(std::int64_t id);
    /// Restores a removed path, with its id. Errors: nameUnknown (a source).
    Result<void> restorePath(const StoredPath& path);
    Result<std::vector<StoredPath>> paths(SetupId setup = setupInUse) const;

    /// Appends a program to the existing ones.
    Result<void> addProgram(const StoredProgram& program);
    Result<std::vector<StoredProgram>> programs(SetupId setup = setupInUse) const;

    class TakeWriter;
    /// Starts a recording; `info.id`, `sampleCount` and `complete` are set by the project. The writer may outlive this
    /// object. Errors: as the setters.
    Result<TakeWriter> beginTake(const TakeInfo& info);

private:
    class Impl;
    explicit Project(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Journals a recording while it is made: samples passed to `append` are on the disk when it returns. Meant for the
/// recorder's thread, never for the haptic loop. Call it every 50 ms or more often.
class Project::TakeWriter {
public:
    ~TakeWriter(); ///< an unfinished take stays, marked incomplete
    TakeWriter(TakeWriter&&) noexcept;
    TakeWriter& operator=(TakeWriter&&) noexcept;

    std::int64_t id() const noexcept; ///< TakeInfo::id of the recording
    /// One transaction, flushed to the disk. Errors: diskFull, fileNotWritable; nothing of this call is stored then.
    Result<void> append(std::span<const Sample> samples);
    /// Marks the take complete. Errors: as `append`; the take is incomplete then.
    Result<void> finish();

private:
    friend class Project;
    class Impl;
    static Result<TakeWriter> begin(std::shared_ptr<WorkingCopy> copy, const TakeInfo& info);
    explicit TakeWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace burin

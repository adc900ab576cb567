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

class StagedFile;
class WorkingCopy;

/// A path as the project keeps it: sources plus edits; its points are evaluated, never stored as truth.
struct StoredPath {
    std::int64_t id = 0;
    std::string name;
    std::vector<PathSource> sources; ///< of `setup` all of them
    std::vector<Edit> edits;
    SetupId setup = setupInUse;
};

/// A posted program with the verdict that let it out.
struct StoredProgram {
    std::string name;
    std::string dialect;
    std::string machine;
    std::string text;
    std::string reportJson;
    SetupId setup = setupInUse; ///< that it is to be run in
};

/// A moment of a setup's recordings that somebody gave a name to.
struct TimeMarker {
    TakeMoment at;
    std::string name;
    friend bool operator==(const TimeMarker&, const TimeMarker&) = default;
};

/// A setup of a job, as lists show it.
struct SetupName {
    SetupId id = setupInUse;
    std::string name; ///< empty: nobody gave it one
};

/// A .burin file: one SQLite database. One works on a journalled copy beside it (`.<name>.working`, WAL, synchronous
/// FULL); `save` writes a snapshot beside the file through SQLite's backup interface and renames it, so the user's file
/// is always a whole one. A working copy that its owner left behind (kill -9, power) is taken up again by `open`.
/// README.md holds the schema and the rules of recovery.
/// Thread: one at a time, but for `TakeWriter`, which has a connection of its own.
class Project {
public:
    /// A new project with no file yet besides its working copy. A project that stands there already is replaced by the
    /// first `save`, nothing else is. Errors: fileNotWritable, diskFull, projectInUse, projectNotBurin (another kind of
    /// file stands there).
    static Result<Project> create(const std::filesystem::path& file);
    /// Where the folder can't be written, the project is open for reading alone.
    /// Errors: fileNotFound, fileEmpty, projectNotBurin, fileFromNewerBurin, projectInUse (detail: "process 4711"),
    /// fileDamaged, fileNotReadable, fileNotWritable, diskFull.
    static Result<Project> open(const std::filesystem::path& file);
    /// For who only looks: nothing is made or changed on the disk, which may be full, and work that was left unsaved is
    /// shown (`recovered`) and stays. `readOnly` is true. Errors: as `open`, without those of writing.
    static Result<Project> openForReading(const std::filesystem::path& file);
    ~Project(); ///< discards the working copy if everything in it was saved, keeps it otherwise
    Project(Project&&) noexcept;
    Project& operator=(Project&&) noexcept;

    /// The user's file, absolute; the name that `saveAs` gave it last.
    const std::filesystem::path& file() const noexcept;
    /// True when `open` took up a working copy that an earlier run left behind.
    bool recovered() const noexcept;
    /// A leftover working copy that doesn't belong to the file as it is now, under a name that the user sees; empty
    /// when there was none.
    const std::filesystem::path& keptAside() const noexcept;
    /// The name that the file got when the last `save` put one of the present format in its place; empty: it was of
    /// that already.
    const std::filesystem::path& keptEarlier() const noexcept;
    /// True when nothing can be changed: setters, `beginTake` and `save` give fileNotWritable.
    bool readOnly() const noexcept;
    /// Whether something was changed since the last `save`. Errors: fileDamaged.
    Result<bool> unsaved() const;
    /// Recordings may go on meanwhile; the file then holds what they had written when it began.
    /// Errors: diskFull, fileNotWritable; the file is then what it was before.
    Result<void> save();
    /// Puts `outputs`, which were flushed, in their places together with the project's file: all or none.
    Result<void> save(std::span<StagedFile> outputs);
    /// Saves under another name and goes on there; the file that it had stays as it was last saved. What stands at the
    /// new name is replaced, if it is a project that nobody has open. Afterwards `readOnly` is false.
    /// Errors: as `save`, projectInUse, projectNotBurin, argumentInvalid (a take is being recorded); nothing has
    /// changed then.
    Result<void> saveAs(const std::filesystem::path& file);
    /// What was not saved is no longer wanted: the working copy goes with this object, whatever is still changed in it,
    /// and the next `open` finds the file as it was saved. Needs no room on the disk.
    void abandonChanges() noexcept;

    // Each setter is one transaction; errors: diskFull, fileNotWritable. Each getter: fileDamaged, projectIncomplete.
    // Lists are empty where nothing was stored yet; what there is only one of is then projectIncomplete.
    Result<void> setModel(const Model& model);
    Result<Model> model() const; ///< in its own frame
    /// As it lies in a setup. Errors: also nameUnknown; the model's own frame where nothing is embedded there yet.
    Result<std::shared_ptr<const Model>> placedModel(SetupId id = setupInUse) const;
    // A project is used in one of its setups: what belongs to a setup takes its id, and is of the one in use where none
    // is said. Further error: nameUnknown (there is none of that id).

    /// In the order in which they were made; there is always one.
    Result<std::vector<SetupName>> setups() const;
    /// A further one, in which nothing is stored yet; its id. It is not in use yet.
    Result<SetupId> addSetup(const std::string& name);
    Result<void> nameSetup(SetupId id, const std::string& name);
    /// With its stock, fixtures and guides; another is in use. Errors: argumentInvalid (it is in use, it holds
    /// recordings, generated moves, paths or programs, or another setup's stock comes from it).
    Result<void> removeSetup(SetupId id);
    /// From now on; the first one where a project was opened or made. The project itself stays as it is.
    Result<void> useSetup(SetupId id);
    SetupId usedSetup() const noexcept;
    Result<void> setSetup(const Setup& setup, SetupId id = setupInUse);
    Result<Setup> setup(SetupId id = setupInUse) const;
    /// Materials of the setups by id, as they were when they were made; in their order. What other setups than the one
    /// in use name stays.
    Result<void> setMaterials(const std::vector<Property>& materials);
    Result<std::vector<Property>> materials() const;
    Result<void> setTool(const Tool& tool); ///< replaces the one of the same id
    Result<std::vector<Tool>> tools() const;
    /// What stands around the stock; the list replaces the one before. Errors: also those of checkObstacle.
    Result<void> setObstacles(const std::vector<Obstacle>& obstacles, SetupId setup = setupInUse);
    Result<std::vector<Obstacle>> obstacles(SetupId setup = setupInUse) const;
    /// How the tool's axis is held from now on; takes keep the axis of each sample. +Z where nothing was stored.
    /// Errors: also argumentInvalid (a direction that is not of unit length).
    Result<void> setAxisMode(const AxisMode& axis, SetupId setup = setupInUse);
    Result<AxisMode> axisMode(SetupId setup = setupInUse) const;
    /// Where the machine's travel lies; by the rule of travelEnvelope where nothing was stored.
    Result<void> setTravelPlacement(const TravelPlacement& placement, SetupId setup = setupInUse);
    Result<TravelPlacement> travelPlacement(SetupId setup = setupInUse) const;
    /// Machine and dialect of the programs; the first machine's where nothing was stored.
    Result<void> setProgramTarget(const ProgramTarget& target, SetupId setup = setupInUse);
    Result<ProgramTarget> programTarget(SetupId setup = setupInUse) const;
    /// The text of a program that the user edits and that was not checked since. Empty: none.
    Result<void> setProgramDraft(const std::string& text, SetupId setup = setupInUse);
    Result<std::string> programDraft(SetupId setup = setupInUse) const;
    /// Where the user left the project (step, camera, …), a JSON text that the window reads. It is kept with the next
    /// `save` and is no change that needs one.
    Result<void> setLeftAt(const std::string& json);
    Result<std::string> leftAt() const; ///< empty: nothing was stored
    /// The program that was checked last, as `keptProgramToJson` writes it. Empty: none.
    Result<void> setKeptProgram(const std::string& json, SetupId setup = setupInUse);
    Result<std::string> keptProgram(SetupId setup = setupInUse) const;
    /// A figure that changes with any bit of part and materials, and of a setup, what stands around its stock, its
    /// recordings and paths.
    Result<std::int64_t> jobDigest(SetupId setup = setupInUse) const;
    /// The guides of the hand; they replace the ones before. Errors: also those of checkGuide.
    Result<void> setGuides(const KeptGuides& guides, SetupId setup = setupInUse);
    Result<KeptGuides> guides(SetupId setup = setupInUse) const;

    /// All of a setup, complete or not, in the order in which they were made.
    Result<std::vector<TakeInfo>> takes(SetupId setup = setupInUse) const;
    /// Errors: nameUnknown, projectIncomplete (there is no recording at all).
    Result<Take> take(std::int64_t id) const;
    /// The same without its samples. Errors: as `take`.
    Result<TakeOutline> takeOutline(std::int64_t id) const;
    /// All samples of a take, also those that were taken back, in memory that does not grow with their number.
    /// @param visit must not use the project. Errors: as `take`, those of `visit`.
    Result<void> visitSamples(std::int64_t id, const SampleVisitor& visit) const;
    /// One of its samples, whether it was taken back or not. Errors: as `take`, argumentInvalid (it has not so many).
    Result<Sample> sample(std::int64_t take, std::uint64_t index) const;
    /// It counts no more, and is there no more for anybody but `restoreTake`. Who opens the project next finds it gone
    /// for good. Errors: as `take`, argumentInvalid while a path uses it.
    Result<void> removeTake(std::int64_t id);
    /// Puts a take that was removed back. Errors: nameUnknown (there is none of that number that was).
    Result<void> restoreTake(std::int64_t id);

    /// As it is now.
    Result<RecordedState> recordedState(SetupId setup = setupInUse) const;
    /// Keeps the workpiece at a moment, in place of one that was kept there, if the setup's state is still the one that
    /// it was made in. What it is made of is noted with it: where any of that becomes another, it holds no more. Of
    /// many the older ones are thinned out. It is kept with the next `save` and is no change that needs one.
    Result<void> keepWorkpiece(const KeptWorkpiece& kept, const RecordedState& madeIn, SetupId setup = setupInUse);
    /// Moments whose workpiece is kept and holds, in order.
    Result<std::vector<TakeMoment>> keptMoments(SetupId setup = setupInUse) const;
    /// Errors: fileDamaged (also where none is kept).
    Result<KeptWorkpiece> keptWorkpiece(const TakeMoment& at, SetupId setup = setupInUse) const;

    /// Notes that a stretch of a take was taken back: its samples stay, and count no more. The take may still be
    /// recorded, and the stretch run ahead of what the recorder has written. Errors: nameUnknown (the take),
    /// argumentInvalid (an empty stretch, or one that overlaps another).
    Result<void> undoStretch(std::int64_t take, const SampleRange& stretch);
    /// Takes such a note back. Errors: argumentInvalid (there is none of just this stretch).
    Result<void> redoStretch(std::int64_t take, const SampleRange& stretch);
    /// Switches samples of a take off, until they are switched on again: they count no more than what was taken back,
    /// whether they were or not. @param off all of the take that is to be off; rising, apart, within its samples
    /// Errors: nameUnknown, argumentInvalid (such ranges they are not).
    Result<void> setSwitchedOff(std::int64_t take, std::span<const SampleRange> off);
    Result<std::vector<SampleRange>> switchedOff(std::int64_t take) const;
    /// Moments that somebody gave names to, in order; the list replaces the one before.
    Result<void> setMarkers(std::span<const TimeMarker> markers, SetupId setup = setupInUse);
    Result<std::vector<TimeMarker>> markers(SetupId setup = setupInUse) const;
    /// Errors: nameUnknown.
    Result<void> nameTake(std::int64_t take, const std::string& name);

    /// What planners made for a setup, without the moves.
    Result<std::vector<GeneratedInfo>> generated(SetupId setup = setupInUse) const;
    /// Errors: nameUnknown.
    Result<GeneratedMoves> generatedMoves(std::int64_t id) const;
    /// Their id; `moves.info.id` is ignored, and none is ever given twice. They are never changed: a planner that is
    /// run again makes new ones, and the path is made of these. Errors: those of checkGenerated, nameUnknown (the
    /// setup).
    Result<std::int64_t> addGenerated(const GeneratedMoves& moves);
    /// Errors: nameUnknown, argumentInvalid while a path is made of them.
    Result<void> removeGenerated(std::int64_t id);

    /// Its id; `path.id` is ignored. Errors: nameUnknown (a source), argumentInvalid (a source of another setup).
    Result<std::int64_t> addPath(const StoredPath& path);
    /// Errors: nameUnknown (the path, a source), argumentInvalid (a source of another setup).
    Result<void> setPath(const StoredPath& path);
    /// Its id is never given again. Errors: nameUnknown.
    Result<void> removePath(std::int64_t id);
    /// Puts a path that was removed back, with its id. Errors: nameUnknown (a source).
    Result<void> restorePath(const StoredPath& path);
    Result<std::vector<StoredPath>> paths(SetupId setup = setupInUse) const;

    /// Behind those that are there.
    Result<void> addProgram(const StoredProgram& program);
    Result<std::vector<StoredProgram>> programs(SetupId setup = setupInUse) const;

    class TakeWriter;
    /// Starts a recording; `info.id`, `sampleCount` and `complete` are the project's to decide. The writer may outlive
    /// this object. Errors: as the setters.
    Result<TakeWriter> beginTake(const TakeInfo& info);

private:
    class Impl;
    explicit Project(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Journals a recording while it is made: what `append` got is on the disk when it returns. Meant for the recorder's
/// thread, never for the haptic loop. Call it every 50 ms or more often.
class Project::TakeWriter {
public:
    ~TakeWriter(); ///< an unfinished take stays, marked incomplete
    TakeWriter(TakeWriter&&) noexcept;
    TakeWriter& operator=(TakeWriter&&) noexcept;

    std::int64_t id() const noexcept; ///< TakeInfo::id of what is recorded
    /// One transaction, flushed to the disk. Errors: diskFull, fileNotWritable; nothing of this call is kept then.
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/left_work.h"
#include "core/job/kept_program.h"
#include "ui/workbench/controller.h"

#include <QDateTime>
#include <QTimer>

#include <filesystem>
#include <memory>

namespace burin {

/// What a project held when it was opened.
struct ProjectContents {
    std::shared_ptr<const Model> model; ///< null: none yet
    std::optional<Setup> setup;
    std::vector<Property> materials; ///< of the setup, as they were when it was created
    std::vector<Obstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
    ProgramTarget target;
    KeptGuides guides;
    std::vector<Tool> tools;
    std::vector<SetupName> setups; ///< all setups of the job; the other members belong to the one in use
    SetupId usedSetup = firstSetup;
    bool stockOutOfDate = false; ///< the stock comes from another setup, which has changed since
    std::vector<TakeInfo> takes;
    std::vector<GeneratedInfo> generated; ///< by planners
    std::vector<StoredPath> paths;
    std::vector<StoredProgram> programs;
    std::optional<ReopenedProgram> keptProgram; ///< the one that was checked last
    std::string programDraft;                   ///< text edited but not checked since; empty: none
    std::string leftAt;                         ///< JSON from the function given to `keepLeftAt`; empty: none
};

/// The project as a document: new, open, save, close. A new project is kept in a file in the user's data folder until
/// it is given a name, so that no data exist in memory only.
class DocumentController final : public Controller {
    Q_OBJECT
public:
    DocumentController(const Desk& desk, QObject* parent);

    bool isOpen() const noexcept { return !file_.empty(); }
    const std::filesystem::path& file() const noexcept { return file_; }
    bool isUnnamed() const; ///< whether it was never saved under a name
    QString title() const;
    bool unsaved() const noexcept { return unsaved_; }
    bool readOnly() const noexcept { return readOnly_; }
    bool recovered() const noexcept { return recovered_; }
    const std::filesystem::path& keptAside() const noexcept { return keptAside_; }
    const QDateTime& savedAt() const noexcept { return savedAt_; } ///< in this session; invalid if not saved yet

    /// Called when the operation is complete; the argument tells whether it succeeded. Errors are reported by `failed`.
    using Then = std::function<void(bool)>;
    /// The project that was open before is closed once the new one is ready.
    /// @param abandon whether to discard its unsaved changes; otherwise they are kept for recovery
    void createNew(bool abandon, Then then = {});
    void openFile(const std::filesystem::path& file, bool abandon, Then then = {});
    bool holds(const std::filesystem::path& file) const; ///< whether `file` is the open project

    /// A project that was read completely and locked, but is not the open one yet. Dropping it leaves that project as
    /// it was.
    struct Prepared;
    using WhenPrepared = std::function<void(Result<std::shared_ptr<Prepared>>)>;
    /// Reads another project and leaves the open one as it is, so that the user is asked about unsaved work only if the
    /// other project can be opened.
    void prepare(const std::filesystem::path& file, WhenPrepared then);
    /// Makes a prepared project the open one, as `openFile` does.
    void open(const std::shared_ptr<Prepared>& prepared, bool abandon, Then then = {});
    void save(Then then = {});
    void saveAs(const std::filesystem::path& file, Then then = {});
    void close(bool abandon, Then then = {});
    /// Switches the open project to another setup, or reads the present one again.
    /// @param step is turned first; if that fails or the setup can't be read, everything stays as it was
    void useSetup(SetupId id, Then then = {}, const std::optional<SharedStep>& step = std::nullopt);

    /// Sets the function that returns the user's position in the work, which is stored with each save. Empty text is
    /// not stored.
    void keepLeftAt(std::function<std::string()> now) { leftAt_ = std::move(now); }

    /// Unsaved work of processes that have ended, newest first.
    FoundWork leftWork() const;
    static void forget(const LeftWork& work);
    /// Folder of projects without a name. Created if it does not exist.
    static std::filesystem::path unnamedFolder();

signals:
    /// Saving replaced a file of an earlier format by one of the present format; the earlier file was renamed to
    /// `file`.
    void keptEarlier(const std::filesystem::path& file);
    void opened(const burin::ProjectContents& contents);
    void setupUsed(const burin::ProjectContents& contents); ///< of the same project
    void closed();

private:
    struct Opened;
    static Result<std::shared_ptr<Prepared>> read(Result<Project> project);
    static Opened exchange(std::optional<Project>& place, Prepared& prepared, bool abandon);
    void take(Result<Opened> outcome, const Then& then);
    void saved(const Result<void>& outcome, const Then& then);
    void askUnsaved();

    std::filesystem::path file_, keptAside_;
    bool unsaved_ = false, readOnly_ = false, recovered_ = false;
    QDateTime savedAt_;
    QTimer askSoon_;
    std::function<std::string()> leftAt_ = [] { return std::string(); };
};

} // namespace burin

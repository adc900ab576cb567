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
    std::vector<Property> materials; ///< of the setup, as they were when it was made
    std::vector<Obstacle> obstacles;
    AxisMode axis;
    TravelPlacement travel;
    ProgramTarget target;
    KeptGuides guides;
    std::vector<Tool> tools;
    std::vector<SetupName> setups; ///< of the job; all else is of the one in use
    SetupId usedSetup = firstSetup;
    bool stockOutOfDate = false; ///< another setup left its stock, and has changed since
    std::vector<TakeInfo> takes;
    std::vector<GeneratedInfo> generated; ///< by planners
    std::vector<StoredPath> paths;
    std::vector<StoredProgram> programs;
    std::optional<ReopenedProgram> keptProgram; ///< the one that was checked last
    std::string programDraft;                   ///< text that was edited and not checked since; empty: none
    std::string leftAt;                         ///< JSON, of whoever gave it to `keepLeftAt`; empty: none
};

/// The project as a document: new, open, save, close. A new one works on a file in a folder of the user's own until it
/// gets a name, so that nothing is ever only in memory.
class DocumentController final : public Controller {
    Q_OBJECT
public:
    DocumentController(const Desk& desk, QObject* parent);

    bool isOpen() const noexcept { return !file_.empty(); }
    const std::filesystem::path& file() const noexcept { return file_; }
    bool isUnnamed() const; ///< it was never saved under a name
    QString title() const;
    bool unsaved() const noexcept { return unsaved_; }
    bool readOnly() const noexcept { return readOnly_; }
    bool recovered() const noexcept { return recovered_; }
    const std::filesystem::path& keptAside() const noexcept { return keptAside_; }
    const QDateTime& savedAt() const noexcept { return savedAt_; } ///< in this session; invalid: not yet

    /// What comes next is called with whether it went well; errors are told by `failed`.
    using Then = std::function<void(bool)>;
    /// The project that was open before is closed, once the other one stands.
    /// @param abandon its unsaved changes are discarded; otherwise they wait to be recovered
    void createNew(bool abandon, Then then = {});
    void openFile(const std::filesystem::path& file, bool abandon, Then then = {});
    bool holds(const std::filesystem::path& file) const; ///< it is the open one

    /// A project that was read as a whole and is locked, but not the open one yet. Dropped, it is as it was before.
    struct Prepared;
    using WhenPrepared = std::function<void(Result<std::shared_ptr<Prepared>>)>;
    /// Reads another project and leaves the open one as it is: who asks about unsaved work then asks in earnest.
    void prepare(const std::filesystem::path& file, WhenPrepared then);
    /// Makes it the open one, as `openFile`.
    void open(const std::shared_ptr<Prepared>& prepared, bool abandon, Then then = {});
    void save(Then then = {});
    void saveAs(const std::filesystem::path& file, Then then = {});
    void close(bool abandon, Then then = {});
    /// Uses the open project in another setup, or reads the present one again.
    void useSetup(SetupId id, Then then = {});

    /// Asked for what is kept with each save: where the user is. An empty text is not kept.
    void keepLeftAt(std::function<std::string()> now) { leftAt_ = std::move(now); }

    /// Unsaved work of programs that are gone, the newest first.
    FoundWork leftWork() const;
    static void forget(const LeftWork& work);
    /// Folder of projects without a name. Made when it is not there.
    static std::filesystem::path unnamedFolder();

signals:
    /// A save put a file of the present format in the place of an earlier one, which has this name now.
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

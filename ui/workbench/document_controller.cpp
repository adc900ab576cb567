// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/document_controller.h"

#include "core/job/further_setup.h"
#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include <chrono>
#include <system_error>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// Data that a project may lack are no error here.
template <class T>
Result<std::optional<T>> unlessMissing(Result<T> value) {
    if (value) return std::optional<T>(std::move(*value));
    if (value.error().code == ErrorCode::projectIncomplete) return std::optional<T>();
    return std::move(value).error();
}

fs::path nextUnnamedFile() {
    const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    const QString name = QStringLiteral("untitled-%1-%2.burin").arg(time).arg(QCoreApplication::applicationPid());
    return DocumentController::unnamedFolder() / name.toStdString();
}

/// Reads fixtures, limits and guides.
Result<void> readMilling(const Project& project, ProjectContents& contents) {
    Result<std::vector<Obstacle>> obstacles = project.obstacles();
    if (!obstacles) return std::move(obstacles).error();
    contents.obstacles = std::move(*obstacles);
    const Result<AxisMode> axis = project.axisMode();
    if (!axis) return axis.error();
    contents.axis = *axis;
    const Result<TravelPlacement> travel = project.travelPlacement();
    if (!travel) return travel.error();
    contents.travel = *travel;
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    contents.target = *target;
    Result<KeptGuides> guides = project.guides();
    if (!guides) return std::move(guides).error();
    contents.guides = std::move(*guides);
    return {};
}

Result<void> readSetups(const Project& project, ProjectContents& contents) {
    Result<std::vector<SetupName>> setups = project.setups();
    if (!setups) return std::move(setups).error();
    contents.setups = std::move(*setups);
    contents.usedSetup = project.usedSetup();
    if (!contents.setup) return {};
    const Result<bool> outOfDate = isStockOutOfDate(project);
    if (!outOfDate) return outOfDate.error();
    contents.stockOutOfDate = *outOfDate;
    return {};
}

Result<ProjectContents> contentsOf(const Project& project) {
    ProjectContents contents;
    Result<std::optional<Model>> model = unlessMissing(project.model());
    if (!model) return std::move(model).error();
    if (*model) contents.model = std::make_shared<const Model>(std::move(**model));
    Result<std::optional<Setup>> setup = unlessMissing(project.setup());
    if (!setup) return std::move(setup).error();
    contents.setup = std::move(*setup);
    Result<std::optional<std::vector<Property>>> materials = unlessMissing(project.materials());
    if (!materials) return std::move(materials).error();
    contents.materials = std::move(*materials).value_or(std::vector<Property>{});
    if (Result<void> read = readMilling(project, contents); !read) return std::move(read).error();
    Result<std::vector<Tool>> tools = project.tools();
    if (!tools) return std::move(tools).error();
    contents.tools = std::move(*tools);
    if (Result<void> read = readSetups(project, contents); !read) return std::move(read).error();
    Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return std::move(takes).error();
    contents.takes = std::move(*takes);
    Result<std::vector<GeneratedInfo>> generated = project.generated();
    if (!generated) return std::move(generated).error();
    contents.generated = std::move(*generated);
    Result<std::vector<StoredPath>> paths = project.paths();
    if (!paths) return std::move(paths).error();
    contents.paths = std::move(*paths);
    Result<std::vector<StoredProgram>> programs = project.programs();
    if (!programs) return std::move(programs).error();
    contents.programs = std::move(*programs);
    Result<std::string> draft = project.programDraft();
    if (!draft) return std::move(draft).error();
    contents.programDraft = std::move(*draft);
    Result<std::optional<ReopenedProgram>> kept = reopenProgram(project);
    if (!kept) return std::move(kept).error();
    contents.keptProgram = std::move(*kept);
    Result<std::string> left = project.leftAt();
    if (!left) return std::move(left).error();
    contents.leftAt = std::move(*left);
    return contents;
}

/// Uses another setup and reads it.
Result<ProjectContents> contentsIn(Project& project, SetupId id) {
    if (Result<void> used = project.useSetup(id); !used) return std::move(used).error();
    return contentsOf(project);
}

/// Returns the name given to a file of an earlier format, if any.
Result<fs::path> saveWith(Project& project, const std::string& left) {
    if (!left.empty())
        if (Result<void> noted = project.setLeftAt(left); !noted) return std::move(noted).error();
    if (Result<void> saved = project.save(); !saved) return std::move(saved).error();
    return project.keptEarlier();
}

} // namespace

struct DocumentController::Prepared {
    Project project;
    ProjectContents contents;
};

struct DocumentController::Opened {
    ProjectContents contents;
    fs::path file, keptAside;
    bool recovered = false, readOnly = false;
};

DocumentController::DocumentController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    askSoon_.setSingleShot(true);
    askSoon_.setInterval(std::chrono::milliseconds(150));
    connect(&askSoon_, &QTimer::timeout, this, &DocumentController::askUnsaved);
    connect(&desk_.project, &ProjectThread::worked, this, [this] {
        if (!askSoon_.isActive()) askSoon_.start();
    });
}

bool DocumentController::isUnnamed() const {
    return isOpen() && file_.parent_path() == unnamedFolder();
}

QString DocumentController::title() const {
    if (!isOpen()) return {};
    return isUnnamed() ? tr("Untitled") : QString::fromStdString(file_.stem().string());
}

fs::path DocumentController::unnamedFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    const fs::path folder = fs::path(data.toStdString()) / "unsaved";
    std::error_code failed;
    fs::create_directories(folder, failed); // if this fails, creating the project reports it
    const fs::path plain = fs::weakly_canonical(folder, failed);
    return failed ? folder : plain;
}

FoundWork DocumentController::leftWork() const {
    return burin::leftWork(unnamedFolder());
}

void DocumentController::forget(const LeftWork& work) {
    Result<Project> project = Project::open(work.file);
    if (project) project->abandonChanges();
}

Result<std::shared_ptr<DocumentController::Prepared>> DocumentController::read(Result<Project> project) {
    if (!project) return std::move(project).error();
    Result<ProjectContents> contents = contentsOf(*project);
    if (!contents) return std::move(contents).error();
    return std::make_shared<Prepared>(Prepared{std::move(*project), std::move(*contents)});
}

DocumentController::Opened DocumentController::exchange(std::optional<Project>& place, Prepared& prepared,
                                                        bool abandon) {
    if (place && abandon) place->abandonChanges();
    place.reset();
    place.emplace(std::move(prepared.project));
    return Opened{std::move(prepared.contents), place->file(), place->keptAside(), place->recovered(),
                  place->readOnly()};
}

void DocumentController::createNew(bool abandon, Then then) {
    desk_.project.postToPlace(
        [abandon](std::optional<Project>& place) -> Result<Opened> {
            const Result<std::shared_ptr<Prepared>> made = read(Project::create(nextUnnamedFile()));
            if (!made) return made.error();
            return exchange(place, **made, abandon);
        },
        [this, then = std::move(then)](Result<Opened> outcome) { take(std::move(outcome), then); });
}

void DocumentController::useSetup(SetupId id, Then then, const std::optional<SharedStep>& step) {
    desk_.project.post(
        [id, step](Project& project) -> Result<ProjectContents> {
            const SetupId before = project.usedSetup();
            if (step) {
                const SharedStep kept;
                kept.join(*step);
                if (Result<void> turned = step->turn(project); !turned) {
                    step->join(kept); // it can be tried again
                    return std::move(turned).error();
                }
            }
            Result<ProjectContents> contents = contentsIn(project, id);
            if (!contents) { // restores what the window shows
                if (step) static_cast<void>(step->turn(project));
                static_cast<void>(project.useSetup(before));
            }
            return contents;
        },
        [this, then = std::move(then)](const Result<ProjectContents>& contents) {
            if (contents)
                emit setupUsed(*contents);
            else
                emit failed(contents.error());
            if (then) then(contents.hasValue());
        });
}

bool DocumentController::holds(const fs::path& file) const {
    std::error_code failed;
    return isOpen() && (file == file_ || fs::equivalent(file, file_, failed));
}

void DocumentController::prepare(const fs::path& file, WhenPrepared then) {
    desk_.project.postToPlace([file](std::optional<Project>&) { return read(Project::open(file)); }, std::move(then));
}

void DocumentController::open(const std::shared_ptr<Prepared>& prepared, bool abandon, Then then) {
    desk_.project.postToPlace(
        [prepared, abandon](std::optional<Project>& place) -> Result<Opened> {
            return exchange(place, *prepared, abandon);
        },
        [this, then = std::move(then)](Result<Opened> outcome) { take(std::move(outcome), then); });
}

void DocumentController::openFile(const fs::path& file, bool abandon, Then then) {
    if (holds(file)) {
        if (then) then(true);
        return;
    }
    prepare(file, [this, abandon, then = std::move(then)](const Result<std::shared_ptr<Prepared>>& prepared) {
        if (prepared) {
            open(*prepared, abandon, then);
            return;
        }
        emit failed(prepared.error());
        if (then) then(false);
    });
}

void DocumentController::take(Result<Opened> outcome, const Then& then) {
    if (outcome) {
        savedAt_ = QDateTime();
        unsaved_ = false;
        file_ = outcome->file;
        keptAside_ = outcome->keptAside;
        recovered_ = outcome->recovered;
        readOnly_ = outcome->readOnly;
        emit opened(outcome->contents);
        askUnsaved();
        emit changed();
    } else {
        emit failed(outcome.error());
    }
    if (then) then(outcome.hasValue());
}

void DocumentController::save(Then then) {
    desk_.project.post([left = leftAt_()](Project& project) { return saveWith(project, left); },
                       [this, then = std::move(then)](const Result<fs::path>& outcome) {
                           saved(outcome ? Result<void>() : Result<void>(outcome.error()), then);
                           if (outcome && !outcome->empty()) emit keptEarlier(*outcome);
                       });
}

void DocumentController::saveAs(const fs::path& file, Then then) {
    desk_.project.post(
        [file, left = leftAt_()](Project& project) -> Result<fs::path> {
            if (!left.empty() && !project.readOnly())
                if (Result<void> noted = project.setLeftAt(left); !noted) return std::move(noted).error();
            if (Result<void> done = project.saveAs(file); !done) return std::move(done).error();
            return project.file();
        },
        [this, then = std::move(then)](const Result<fs::path>& outcome) {
            if (outcome) {
                file_ = *outcome;
                readOnly_ = false;
            }
            saved(outcome ? Result<void>() : Result<void>(outcome.error()), then);
        });
}

void DocumentController::saved(const Result<void>& outcome, const Then& then) {
    if (outcome) {
        unsaved_ = false;
        recovered_ = false;
        savedAt_ = QDateTime::currentDateTime();
        emit changed();
    } else {
        emit failed(outcome.error());
    }
    if (then) then(outcome.hasValue());
}

void DocumentController::close(bool abandon, Then then) {
    desk_.project.postToPlace(
        [abandon, left = leftAt_()](std::optional<Project>& place) -> Result<void> {
            if (place && abandon) place->abandonChanges();
            // Stores the user's position with unsaved work, for recovery. A file is not written for that alone.
            if (place && !abandon && !place->readOnly() && !left.empty()) static_cast<void>(place->setLeftAt(left));
            place.reset();
            return {};
        },
        [this, then = std::move(then)](const Result<void>& outcome) {
            file_.clear();
            unsaved_ = false;
            emit closed();
            emit changed();
            if (!outcome) emit failed(outcome.error());
            if (then) then(outcome.hasValue());
        });
}

void DocumentController::askUnsaved() {
    if (!isOpen()) return;
    desk_.project.ask([](Project& project) { return project.unsaved(); },
                      [this](const Result<bool>& answer) {
                          if (!answer || *answer == unsaved_) return;
                          unsaved_ = *answer;
                          emit changed();
                      });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/document_flow.h"

#include "core/base/file.h"
#include "core/cad/file_unit.h"
#include "core/document/file_kind.h"
#include "core/exchange/volume_input.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/sheet/sheet_drawing.h"
#include "ui/window/path_presenters.h"
#include "ui/window/restart_dialog.h"
#include "ui/window/tool_shape_dialog.h"

#include <QBuffer>
#include <QFileInfo>
#include <QGuiApplication>
#include <QStandardPaths>
#include <QTimer>

#include <utility>

namespace burin {

namespace {

QString textOf(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

std::filesystem::path pathOf(const QString& text) {
    return {text.toStdString()};
}

/// "part.ngc" becomes "part-from-120.ngc".
QString restartName(const QString& program, int line) {
    const QFileInfo file(program);
    return QStringLiteral("%1-from-%2.%3").arg(file.completeBaseName(), QString::number(line), file.suffix());
}

} // namespace

QString samplePart() {
    return textOf(resourceDirectory() / "samples" / "mouse.step");
}

DocumentFlow::DocumentFlow(Workbench& workbench, UserSettings& settings, QWidget& window)
    : QObject(&window), workbench_(workbench), settings_(settings), window_(window) {
    connect(&workbench.document, &DocumentController::opened, this, [this] { noteSaved(); });
    connect(&workbench.program, &ProgramController::exported, this, &DocumentFlow::exported);
    connect(&workbench.workpiece, &WorkpieceController::exported, this, &DocumentFlow::workpieceExported);
    // Called by a task, which may still run when this object no longer exists.
    const auto unit = [flow = QPointer<DocumentFlow>(this)] {
        return flow ? flow->settings_.preferences().unit : LengthUnit::millimetre;
    };
    workbench.sheet.setDraw(
        [&tasks = workbench.tasks(), unit](const std::shared_ptr<const SheetContent>& content, Progress& progress) {
            return drawSheet(tasks, content, unit, progress);
        });
    connect(&workbench.program, &ProgramController::restarted, this,
            [this](const std::shared_ptr<const RestartedProgram>& rest) {
                // Queued, as its dialog stays open: the task that delivers the result, and its progress display,
                // must end first.
                QMetaObject::invokeMethod(
                    this, [this, rest] { exportRestart(*rest); }, Qt::QueuedConnection);
            });
    connect(&workbench.program, &ProgramController::restartExported, this,
            [this](std::uint32_t line, const QString& file) { emit restartExported(static_cast<int>(line), file); });
}

void DocumentFlow::connectActions(const Actions& actions) {
    const auto on = [&](ActionId id, void (DocumentFlow::*what)()) {
        connect(actions[id], &QAction::triggered, this, what);
    };
    on(ActionId::newProject, &DocumentFlow::createNew);
    on(ActionId::openProject, &DocumentFlow::open);
    on(ActionId::importPart, &DocumentFlow::import);
    on(ActionId::updatePart, &DocumentFlow::updatePart);
    on(ActionId::sampleProject, &DocumentFlow::importSample);
    on(ActionId::save, &DocumentFlow::save);
    on(ActionId::saveAs, &DocumentFlow::saveAs);
    on(ActionId::exportProgram, &DocumentFlow::exportProgram);
    on(ActionId::exportWorkpiece, &DocumentFlow::exportWorkpiece);
    on(ActionId::exportSheet, &DocumentFlow::exportSheet);
    connect(actions[ActionId::recordTrace], &QAction::triggered, this, &DocumentFlow::recordTrace);
    on(ActionId::stockFile, &DocumentFlow::readStock);
    on(ActionId::toolShape, &DocumentFlow::shapeTool);
    connect(actions[ActionId::programPath], &QAction::triggered, this, [this] { addProgramPath(); });
}

QString DocumentFlow::folder() const {
    const QString last = settings_.lastFolder();
    if (!last.isEmpty() && QFileInfo(last).isDir()) return last;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void DocumentFlow::keepFolder(const QString& file) {
    settings_.setLastFolder(QFileInfo(file).absolutePath());
}

void DocumentFlow::createNew() {
    settle(
        [this](bool abandon) { workbench_.comeToRest([this, abandon] { workbench_.document.createNew(abandon); }); });
}

void DocumentFlow::open() {
    const QString file = askProjectToOpen(&window_, folder());
    if (file.isEmpty()) return;
    keepFolder(file);
    openAny(file);
}

void DocumentFlow::openProject(const QString& file) {
    if (workbench_.document.holds(pathOf(file))) {
        emit alreadyOpen();
        return;
    }
    using Prepared = std::shared_ptr<DocumentController::Prepared>;
    workbench_.document.prepare(pathOf(file), [this, file](const Result<Prepared>& prepared) {
        if (!prepared) {
            refuse(file, prepared.error());
            return;
        }
        settle([this, project = *prepared](bool abandon) {
            workbench_.comeToRest([this, project, abandon] { workbench_.document.open(project, abandon); });
        });
    });
}

/// A program is shown on a workpiece: that of the open project.
void DocumentFlow::openProgram(const QString& file) {
    if (!workbench_.workpiece.embedded()) {
        emit refused(tr("“%1” is an NC program: open its project or embed its part first, then open the program again.")
                         .arg(QFileInfo(file).fileName()));
        return;
    }
    const Result<std::string> bytes = readFile(pathOf(file));
    if (!bytes) {
        refuse(file, bytes.error());
        return;
    }
    QString text = QString::fromStdString(*bytes);
    // Files of old controls are in Latin-1.
    if (text.toStdString() != *bytes) text = QString::fromLatin1(QByteArray::fromStdString(*bytes));
    workbench_.program.openText(text);
    emit programOpened();
}

void DocumentFlow::addProgramPath() {
    const QString file = askProgramToRead(&window_, folder());
    if (file.isEmpty()) return;
    keepFolder(file);
    emit begun();
    addProgramPath(file);
}

void DocumentFlow::addProgramPath(const QString& file) {
    if (!workbench_.passes.possible()) {
        emit refused(tr("“%1” becomes a path of a job: open its project or embed its part first, then open it again.")
                         .arg(QFileInfo(file).fileName()));
        return;
    }
    const Result<std::string> text = readFile(pathOf(file));
    if (!text)
        refuse(file, text.error());
    else
        workbench_.passes.addProgram(*text, file.toStdString(), workbench_.target.dialect());
}

/// Nothing has changed. A missing file of the recent list needs a decision, any other error only a message.
void DocumentFlow::refuse(const QString& file, const Error& error) {
    if (error.code != ErrorCode::fileNotFound || !settings_.isRecentFile(file)) {
        emit refused(Messages::sentence(error));
        return;
    }
    if (!confirm(&window_, tr("Remove “%1” from the list of recent files?").arg(QFileInfo(file).fileName()),
                 tr("The file was moved, renamed or deleted, or its drive is not connected."),
                 tr("Remove it from the list")))
        return;
    settings_.removeRecentFile(file);
    emit recentFilesChanged();
}

void DocumentFlow::import() {
    const QString file = askPartToImport(&window_, folder());
    if (file.isEmpty()) return;
    keepFolder(file);
    openAny(file);
}

void DocumentFlow::updatePart() {
    const auto model = workbench_.model.model();
    if (!model) return;
    emit begun();
    QString file = QString::fromStdString(model->sourceFile);
    if (!QFileInfo::exists(file)) {
        file = askPartToImport(&window_, folder());
        if (file.isEmpty()) return;
        keepFolder(file);
    }
    workbench_.updatePart(pathOf(file));
}

void DocumentFlow::importFixture() {
    const QString file = askFixtureToImport(&window_, folder());
    if (file.isEmpty()) return;
    keepFolder(file);
    const auto model = workbench_.model.model();
    workbench_.surroundings.importFile(pathOf(file), model ? importOptionsAsBefore(*model).fileUnit : 1.0);
}

void DocumentFlow::importFile(const QString& file) {
    workbench_.model.read(pathOf(file), {}, [this](const std::shared_ptr<const Model>& part) { adopt(part); });
}

void DocumentFlow::adopt(const std::shared_ptr<const Model>& part) {
    if (!workbench_.importNeedsNewProject()) {
        workbench_.adoptPart(part, false);
        return;
    }
    if (workbench_.document.isOpen()) workbench_.model.dropPreview(); // the question is about the open project
    settle([this, part](bool abandon) { workbench_.adoptPart(part, abandon); });
}

void DocumentFlow::importAgain(double unit) {
    const auto before = workbench_.model.model();
    if (!before) return;
    ImportOptions options;
    options.unitInstead = unit;
    workbench_.model.read(before->sourceFile, options, [this, before](const std::shared_ptr<const Model>& part) {
        if (!workbench_.changeUnit(before, part)) adopt(part);
    });
}

void DocumentFlow::importSample() {
    emit begun();
    importFile(samplePart());
}

void DocumentFlow::showSample() {
    emit begun();
    settle([this](bool abandon) {
        workbench_.comeToRest([this, abandon] {
            workbench_.document.createNew(abandon, [this](bool made) {
                if (!made) return;
                workbench_.importPart(pathOf(samplePart()), false);
                workbench_.showHowItIsDone();
            });
        });
    });
}

void DocumentFlow::openAny(const QString& file) {
    emit begun();
    const Result<FileKind> kind = fileKind(pathOf(file));
    if (!kind)
        refuse(file, kind.error());
    else if (*kind == FileKind::program)
        openProgram(file);
    else if (*kind == FileKind::locations)
        addProgramPath(file);
    else if (*kind == FileKind::project)
        openProject(file);
    else
        importFile(file);
}

void DocumentFlow::save() {
    saveThen({});
}

void DocumentFlow::saveAs() {
    saveAsThen({});
}

void DocumentFlow::saveThen(std::function<void()> then) {
    if (!workbench_.document.isOpen()) return;
    workbench_.collectText();
    if (workbench_.document.isUnnamed() || workbench_.document.readOnly()) {
        saveAsThen(std::move(then));
        return;
    }
    workbench_.document.save([this, then = std::move(then)](bool saved) {
        if (!saved) return;
        noteSaved();
        if (then) then();
    });
}

void DocumentFlow::saveAsThen(std::function<void()> then) {
    if (!workbench_.document.isOpen()) return;
    workbench_.collectText();
    QString name = workbench_.document.title();
    if (workbench_.document.isUnnamed()) name = jobName(workbench_);
    const QString file = askProjectToSave(&window_, folder(), name + QStringLiteral(".burin"));
    if (file.isEmpty()) return;
    keepFolder(file);
    const auto save = [this, file, then = std::move(then)] {
        workbench_.document.saveAs(pathOf(file), [this, then](bool saved) {
            if (!saved) return;
            noteSaved();
            if (then) then();
        });
    };
    // A recording belongs to one file: it ends, mill mode continues.
    if (workbench_.session.running())
        workbench_.mill.interrupt(save);
    else
        save();
}

void DocumentFlow::noteSaved() {
    if (!workbench_.document.isOpen() || workbench_.document.isUnnamed()) return;
    settings_.addRecentFile(textOf(workbench_.document.file()));
    emit recentFilesChanged();
}

void DocumentFlow::exportProgram() {
    workbench_.collectText(); // text being typed has not been checked
    if (!workbench_.program.exportable()) return;
    const QString file = askProgramToExport(&window_, folder(), programName(workbench_));
    if (file.isEmpty()) return;
    keepFolder(file);
    workbench_.program.exportTo(pathOf(file));
}

void DocumentFlow::readStock() {
    if (!workbench_.setup.hasPart() || workbench_.setup.locked() || workbench_.setup.readingStock()) return;
    const QString file = askStockToRead(&window_, folder());
    if (file.isEmpty()) return;
    keepFolder(file);
    QString table;
    if (const Result<VolumeSource> source = volumeSourceOf(pathOf(file));
        source && *source == VolumeSource::voxelArray) {
        table = askArrayTable(&window_, folder(), QFileInfo(file).fileName());
        if (table.isEmpty()) return;
    }
    workbench_.setup.readStock(pathOf(file), table.isEmpty() ? std::filesystem::path() : pathOf(table));
}

void DocumentFlow::shapeTool() {
    if (workbench_.tool.locked() || workbench_.tool.shaping()) return;
    ToolShapeDialog dialog(workbench_.tool.current(), folder(), settings_.preferences().unit, &window_);
    if (dialog.exec() != QDialog::Accepted) return;
    settings_.setLastFolder(dialog.folder());
    ToolShapeRequest request = dialog.request();
    request.id = workbench_.tool.freeId(QString::fromStdString(request.name));
    workbench_.tool.shape(request);
}

void DocumentFlow::exportSheet() {
    if (!workbench_.setup.usable() || workbench_.sheet.writing()) return;
    const QString file = askSheetToExport(&window_, folder(), QFileInfo(programName(workbench_)).completeBaseName());
    if (file.isEmpty()) return;
    keepFolder(file);
    workbench_.sheet.write(workbench_.document.title(), file);
}

void DocumentFlow::recordTrace(bool on) {
    QString file;
    if (on) file = askTraceToRecord(&window_, folder(), jobName(workbench_) + QStringLiteral("-trace"));
    if (!file.isEmpty()) keepFolder(file);
    workbench_.mill.setTrace(pathOf(file));
}

void DocumentFlow::exportPicture(const QImage& picture) {
    const QString file = askPictureToExport(&window_, folder(), jobName(workbench_));
    if (file.isEmpty()) return;
    keepFolder(file);
    QByteArray png;
    QBuffer buffer(&png);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
        return emit workbench_.failed({ErrorCode::outOfMemory, file.toStdString(), {}, {}});
    if (const Result<void> written = writeFileAtomically(pathOf(file), png.toStdString()); !written)
        emit workbench_.failed(written.error());
    else
        emit pictureExported(file);
}

void DocumentFlow::exportFaces(const std::string& table) {
    const QString file = askFacesToExport(&window_, folder(), jobName(workbench_) + QStringLiteral("-faces"));
    if (file.isEmpty()) return;
    keepFolder(file);
    if (const Result<void> written = writeFileAtomically(pathOf(file), table); !written)
        emit workbench_.failed(written.error());
    else
        emit facesExported(file);
}

void DocumentFlow::exportWorkpiece() {
    if (!workbench_.workpiece.embedded() || workbench_.session.running()) return;
    const QString name = QFileInfo(workbench_.document.title()).completeBaseName();
    const QString file = askWorkpieceToExport(&window_, folder(), name.isEmpty() ? tr("workpiece") : name);
    if (file.isEmpty()) return;
    keepFolder(file);
    workbench_.workpiece.exportTo(pathOf(file));
}

void DocumentFlow::restartProgram(int line) {
    workbench_.collectText(); // text being typed has not been checked
    if (line < 1) return;
    workbench_.program.restart(static_cast<std::uint32_t>(line), restartName(programName(workbench_), line));
}

void DocumentFlow::exportRestart(const RestartedProgram& rest) {
    const RestartAnswer answer = askRestart(&window_, rest, settings_.preferences().unit);
    if (!answer.write) return;
    const int line = static_cast<int>(rest.from);
    const QString file = askProgramToExport(&window_, folder(), restartName(programName(workbench_), line));
    if (file.isEmpty()) return;
    keepFolder(file);
    workbench_.program.exportRestart(pathOf(file), rest, answer.overrideReason);
}

void DocumentFlow::settle(std::function<void(bool)> then) {
    if (asking_) return;
    const bool typed = workbench_.collectText();
    if (!workbench_.document.isOpen() || (!workbench_.document.unsaved() && !typed && !workbench_.mill.recording())) {
        then(false);
        return;
    }
    asking_ = true;
    const UnsavedAnswer answer = askUnsaved(&window_, workbench_.document.title());
    asking_ = false;
    if (answer == UnsavedAnswer::discard)
        then(true);
    else if (answer == UnsavedAnswer::save)
        workbench_.comeToRest([this, then = std::move(then)] { saveThen([then] { then(false); }); });
}

void DocumentFlow::whenSheetIsWritten(std::function<void()> then) {
    if (std::exchange(awaitingSheet_, true)) return;
    awaitSheet(std::move(then));
}

void DocumentFlow::awaitSheet(std::function<void()> then) {
    constexpr int patience = 20; // ms
    if (workbench_.sheet.writing()) {
        QTimer::singleShot(patience, this, [this, then = std::move(then)] { awaitSheet(then); });
    } else {
        awaitingSheet_ = false;
        then();
    }
}

void DocumentFlow::closeProject(bool abandon, std::function<void()> then) {
    workbench_.comeToRest([this, abandon, then = std::move(then)] {
        workbench_.tasks().cancelAll();
        workbench_.document.close(abandon, [then](bool) { then(); });
    });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Connections of actions, of completed work, and of requests from the welcome page.
#include "core/base/numbers.h"
#include "core/tool/tool_solid.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/texts.h"
#include "ui/window/button_actions.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QFileInfo>
#include <QShortcut>
#include <QStackedWidget>

#include <algorithm>

namespace burin {

void MainWindow::connectActions() {
    for (std::size_t id = 0; id < static_cast<std::size_t>(ActionId::count); ++id)
        addAction(actions_[static_cast<ActionId>(id)]); // so that shortcuts work wherever the focus is
    flow_.connectActions(actions_);
    presenters_->connectActions(actions_, *viewport_);
    const auto on = [this](ActionId id, auto what) { connect(actions_[id], &QAction::triggered, this, what); };
    on(ActionId::quit, [this] { close(); });
    on(ActionId::preferences, [this] { showPreferences(); });
    const auto step = [this](int by) {
        const int next = std::clamp(static_cast<int>(presenters_->job.shown()) + by, 0, StepBar::steps - 1);
        showStep(static_cast<JobStep>(next));
    };
    on(ActionId::nextStep, [step] { step(1); });
    on(ActionId::previousStep, [step] { step(-1); });
    on(ActionId::millMode, [this](bool wanted) {
        showStep(JobStep::mill);
        if (wanted)
            workbench_.stylusEditor.leave([this] { workbench_.mill.enter(); });
        else
            workbench_.mill.leave();
    });
    on(ActionId::punchIn, [this] {
        showStep(JobStep::mill);
        workbench_.time.punchIn();
    });
    on(ActionId::addFixtureFile, [this] { flow_.importFixture(); });
    connect(&presenters_->surroundings, &SurroundingsPresenter::fixtureFileRequested, &flow_,
            &DocumentFlow::importFixture);
    on(ActionId::drawEdit, [this] {
        showStep(JobStep::path);
        presenters_->pathScene.toggleLastDrawing();
    });
    on(ActionId::stylusEdit, [this](bool wanted) {
        if (wanted) showStep(JobStep::path);
        presenters_->stylusEdit.toggle(wanted);
    });
    connect(&presenters_->stylusEdit, &StylusEditPresenter::told, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    on(ActionId::findInProgram, [this] {
        showStep(JobStep::program);
        panels_->program->editor().startSearch();
    });
    on(ActionId::programDock, [this](bool docked) {
        if (docked) showStep(JobStep::program); // the step in which its effect is visible
    });
    on(ActionId::overrideCheck, [this] { overrideCheck(); });
    on(ActionId::restart, [this] {
        showStep(JobStep::program);
        flow_.restartProgram(panels_->program->line());
    });
    on(ActionId::resetLayout, [this] { resetLayout(); });
    on(ActionId::shortcuts, [this] { showShortcuts(); });
    on(ActionId::exportPicture, [this] { flow_.exportPicture(viewport_->grabFramebuffer()); });
    on(ActionId::machines, [this] { showMachines(); });
    on(ActionId::tools, [this] { showTools(); });
    on(ActionId::materials, [this] { showMaterials(); });
    on(ActionId::devices, [this] { showDevices(); });
    on(ActionId::scoreTake, [this] { workbench_.score.ask(workbench_.mill.chosenTake()); });
    connect(&workbench_.score, &ScoreController::asked, this, &MainWindow::showScore, Qt::QueuedConnection);
    on(ActionId::welcome, [this] {
        if (pages_->currentWidget() != welcome_) {
            leftFrom_ = QApplication::focusWidget();
            showWelcome();
        } else {
            goBack();
        }
    });
    connect(welcome_, &WelcomePage::backRequested, this, &MainWindow::goBack);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MainWindow::escape);
    on(ActionId::help, [this] { showHelp(); });
    on(ActionId::keyList, [this] { showKeys(); });
    on(ActionId::about, [this] { showAbout(this, QCoreApplication::applicationVersion()); });
    connect(panels_->part, &PartPanel::importRequested, &flow_, &DocumentFlow::import);
    connect(panels_->part, &PartPanel::fileUnitChosen, &flow_, &DocumentFlow::importAgain);
    connect(panels_->stock, &StockPanel::fileRequested, &flow_, &DocumentFlow::readStock);
    connect(panels_->program, &ProgramPanel::exportRequested, &flow_, &DocumentFlow::exportProgram);
    connect(&presenters_->millMode, &MillMode::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    connect(&presenters_->setups, &SetupsPresenter::pickBegins, this, [this] { showStep(JobStep::part); });
    connect(&presenters_->setups, &SetupsPresenter::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    connect(&presenters_->zero, &ZeroPresenter::pickBegins, this, [this] {
        showStep(JobStep::stock);
        panels_->showPanel(panels_->zero);
    });
    connect(&presenters_->fixtures, &FixturePresenter::placingBegins, this, [this] {
        if (presenters_->job.shown() != JobStep::stock) showStep(JobStep::stock);
        panels_->showPanel(panels_->surroundings);
    });
    connect(&presenters_->obstacleMove, &ObstacleMovePresenter::movingBegins, this, [this](const QString& hint) {
        if (presenters_->job.shown() != JobStep::stock) showStep(JobStep::stock);
        panels_->showPanel(panels_->surroundings);
        message_->tell(Notice::Kind::information, hint);
    });
    connect(&presenters_->obstacleMove, &ObstacleMovePresenter::movingEnded, message_, &MessageStrip::dismiss);
    connect(&presenters_->surroundings, &SurroundingsPresenter::libraryFixtureRequested,
            actions_[ActionId::libraryFixture], &QAction::trigger);
    connect(&presenters_->zero, &ZeroPresenter::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    connect(&presenters_->zero, &ZeroPresenter::told, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    connect(&presenters_->tree, &TreePresenter::stepRequested, this, &MainWindow::showStep);
    connect(&presenters_->measure, &MeasurePresenter::told, this,
            [this](const QString& sentences) { message_->tell(Notice::Kind::information, sentences); });
    connect(&presenters_->holes, &HolePresenter::told, this,
            [this](const QString& sentences) { message_->tell(Notice::Kind::information, sentences); });
    connect(&presenters_->holes, &HolePresenter::pickBegins, this, [this] {
        if (presenters_->job.shown() != JobStep::path) showStep(JobStep::path);
    });
    connect(&presenters_->area, &AreaPresenter::paintingBegins, this, [this] {
        if (presenters_->job.shown() != JobStep::path) showStep(JobStep::path);
    });
    connect(&presenters_->area, &AreaPresenter::refused, this,
            [this](const Error& error) { message_->tell(Notice::Kind::information, Messages::sentence(error)); });
    connect(&presenters_->mill, &MillPresenter::takeRemovalRequested, this, &MainWindow::removeTake);
    connect(stepBar_, &StepBar::stepChosen, this, &MainWindow::showStep);
    connect(menus_, &Menus::recentChosen, &flow_, &DocumentFlow::openAny);
}

/// Describes how a program was converted to a path.
QString MainWindow::programPathText(const ProgramPasses& passes) const {
    QStringList text{
        tr("A path was made of %1 of feed moves, with the feeds and speeds of the program. Links replace its rapids.")
            .arg(wayText(passes.length(), settings_.preferences().unit))};
    const auto count = [](std::size_t number) { return static_cast<int>(number); };
    if (passes.arcs > 0)
        text << (passes.arcs == 1 ? tr("1 arc was converted to lines within 0.001 mm; “Fit arcs” restores it.")
                                  : tr("%n arcs were converted to lines within 0.001 mm; “Fit arcs” restores them.",
                                       nullptr, count(passes.arcs)));
    if (passes.dwells > 0)
        text << (passes.dwells == 1 ? tr("1 dwell was left out.")
                                    : tr("%n dwells were left out.", nullptr, count(passes.dwells)));
    if (passes.startless > 0)
        text << (passes.startless == 1 ? tr("1 move was left out: the program does not state where it begins.")
                                       : tr("%n moves were left out: the program does not state where they begin.",
                                            nullptr, count(passes.startless)));
    return text.join(QLatin1Char(' '));
}

/// Describes the differences of a part that was read again.
QString MainWindow::updateText(const PartUpdate& update) {
    const auto listed = [](const std::vector<std::string>& names) {
        QStringList texts;
        for (const std::string& name : names) texts << QString::fromStdString(name);
        return texts.join(QStringLiteral(", "));
    };
    QStringList sentences;
    if (update.nothing()) sentences << tr("The part has not changed.");
    if (!update.changed.empty()) sentences << tr("Changed bodies: %1.").arg(listed(update.changed));
    if (!update.added.empty()) sentences << tr("New bodies: %1.").arg(listed(update.added));
    if (!update.removed.empty()) sentences << tr("Removed bodies: %1.").arg(listed(update.removed));
    if (update.stockStays && !update.nothing())
        sentences << tr("Stock and program zero stay where they are; check the programs again.");
    return sentences.join(QLatin1Char(' '));
}

/// The device that moves the view in addition to the stylus.
void MainWindow::connectViewDevice() {
    ViewDevice& device = workbench_.viewDevice;
    device.choose(settings_.viewDevice());
    connect(&device, &ViewDevice::changed, this, [this, &device] { settings_.setViewDevice(device.chosen()); });
    connect(&device, &ViewDevice::pushed, this, [this](const glm::dvec3& push, const glm::dvec3& turn, double seconds) {
        viewport_->push({push, turn}, seconds);
    });
    connect(&device, &ViewDevice::fitRequested, this, [this] { viewport_->fit(); });
}

/// The effect of a pen's pressure is a setting of the user, not of the project.
void MainWindow::connectPen() {
    MillMode& mode = presenters_->millMode;
    MillToolSettings kept = mode.settings();
    kept.pen = settings_.penSinks() ? PenRule::sink : PenRule::depth;
    kept.sinkSpeed = settings_.penSinkSpeed();
    mode.setSettings(kept);
    connect(&mode, &MillMode::settingsChanged, this, [this, &mode] {
        settings_.setPenSinks(mode.settings().pen == PenRule::sink);
        settings_.setPenSinkSpeed(mode.settings().sinkSpeed);
    });
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::failed, this, [this](const Error& error) {
        const bool stopped = error.code == ErrorCode::cancelled;
        message_->tell(stopped ? Notice::Kind::information : Notice::Kind::error, Messages::sentence(error));
    });
    connect(&flow_, &DocumentFlow::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::error, sentence); });
    connect(&flow_, &DocumentFlow::begun, message_, &MessageStrip::dismiss);
    connect(&flow_, &DocumentFlow::programOpened, this, [this] {
        showWorkSteps(true);
        showStep(JobStep::program);
        workbench_.program.checkText(programName(workbench_));
    });
    connect(&workbench_.passes, &PassController::programAdded, this, [this](const ProgramPasses& passes) {
        showWorkSteps(true);
        showStep(JobStep::path);
        message_->tell(Notice::Kind::information, programPathText(passes));
    });
    connect(&flow_, &DocumentFlow::alreadyOpen, this, [this] { showWorkSteps(true); });
    connect(&workbench_, &Workbench::partUpdated, this,
            [this](const PartUpdate& update) { message_->tell(Notice::Kind::information, updateText(update)); });
    connect(&workbench_, &Workbench::setupShown, this, [this](const QString& title) {
        message_->tell(Notice::Kind::information, tr("Switched to “%1”, where the change was made.").arg(title));
    });
    connect(&workbench_.hand, &HandController::batteryLow, this, &MainWindow::tellAboutBattery);
    const auto [device, mode] = settings_.chosenDevice();
    workbench_.styluses.prefer(device, mode);
    connect(&workbench_.styluses, &StylusController::choiceMade, this, [this] {
        const StylusController::Choice& choice = workbench_.styluses.choice();
        settings_.setChosenDevice(choice.id, choice.mode);
    });
    connect(&workbench_.styluses, &StylusController::changed, this, &MainWindow::followFelt);
    workbench_.styluses.setAxisMaps([this](const std::string& id) { return settings_.axisMap(id); });
    new ButtonActions(workbench_, actions_, this);
    workbench_.styluses.start();
    connectViewDevice();
    connectPen();
    followStockLayer();
    connect(actions_[ActionId::keepFromStock], &QAction::triggered, this, [this](bool on) {
        settings_.setStockLayer({settings_.stockLayer().distance, on});
        followStockLayer();
    });
    connect(&workbench_.mill, &MillController::traceWritten, this, [this](const QString& file) {
        message_->tell(Notice::Kind::information, tr("The trace of the session was written to “%1”.").arg(file));
    });
    connect(&workbench_.document, &DocumentController::changed, this, &MainWindow::updateTitle);
    connect(&workbench_.document, &DocumentController::opened, this, [this](const ProjectContents& contents) {
        tellAboutOpened();
        const auto left = leftAtFromJson(contents.leftAt);
        presenters_->tree.hideBodies(left ? left->hidden : std::set<std::size_t>());
        if (left) goTo(*left);
        // Without a window's state the project was embedded by the command line.
        if (left ? left->embedded : contents.setup.has_value()) workbench_.ensureWorkpiece();
    });
    connect(&workbench_.document, &DocumentController::keptEarlier, this, [this](const std::filesystem::path& file) {
        message_->tell(Notice::Kind::information,
                       tr("An earlier version of Burin saved this project; the previous file is kept as “%1”.")
                           .arg(QString::fromStdString(file.filename().string())));
    });
    workbench_.document.keepLeftAt([this] { return toJson(leftAt()); });
    connect(&workbench_.model, &Controller::changed, this, &MainWindow::followPreview);
    connect(&workbench_.model, &ModelController::imported, this, [this] {
        message_->dismiss();
        showStep(JobStep::stock);
    });
    connect(&workbench_.session, &SessionRunner::changed, this, [this] {
        panels_->meters->setVisible(workbench_.session.running());
        if (workbench_.showMe.showing()) showStep(JobStep::mill);
    });
    connect(&workbench_.showMe, &ShowMe::finished, this, [this] {
        // A take recorded just before may not be in the list yet.
        workbench_.mill.refreshTakes([this] {
            if (workbench_.mill.takes().empty() || ending_) return;
            showStep(JobStep::path);
            workbench_.path.makeNew();
        });
    });
    connect(&flow_, &DocumentFlow::recentFilesChanged, this, [this] {
        menus_->setRecentFiles(settings_.recentFiles());
        welcome_->setRecentFiles(settings_.recentFiles());
    });
    connect(&flow_, &DocumentFlow::exported, this, [this](const QString& file) {
        message_->tell(Notice::Kind::passed, tr("The program was written to “%1”.").arg(QFileInfo(file).fileName()));
    });
    connect(&flow_, &DocumentFlow::workpieceExported, this, [this](const QString& file) {
        message_->tell(Notice::Kind::passed, tr("The workpiece was written to “%1”.").arg(QFileInfo(file).fileName()));
    });
    connect(&flow_, &DocumentFlow::pictureExported, this, [this](const QString& file) {
        message_->tell(Notice::Kind::passed, tr("The picture was written to “%1”.").arg(QFileInfo(file).fileName()));
    });
    connect(&presenters_->faces, &FacePresenter::exportRequested, &flow_, &DocumentFlow::exportFaces);
    connect(&flow_, &DocumentFlow::facesExported, this, [this](const QString& file) {
        message_->tell(Notice::Kind::passed,
                       tr("The table of faces was written to “%1”.").arg(QFileInfo(file).fileName()));
    });
    connect(&workbench_.sheet, &SheetController::written, this, [this](const QString& file) {
        message_->tell(Notice::Kind::passed,
                       tr("The setup sheet was written to “%1”.").arg(QFileInfo(file).fileName()));
    });
    connect(&workbench_.setup, &SetupController::unitUnknown, this, [this](const QString& file) {
        message_->tell(Notice::Kind::information, tr("“%1” gives no unit of length; it was read in mm.").arg(file));
    });
    connect(&workbench_.setup, &SetupController::stockTurnedAslant, this, [this](double by) {
        message_->tell(Notice::Kind::warning, tr("The stock was rotated by an angle that is not a multiple of 90°. Its "
                                                 "faces may be off by up to %1 mm; use smaller voxels to reduce this.")
                                                  .arg(QString::fromStdString(formatLimit(by, 3))));
    });
    connect(&workbench_.tool, &ToolController::shaped, this, [this](const ShapedTool& made) {
        if (!made.tool.cutter.turns())
            return message_->tell(Notice::Kind::passed,
                                  tr("The tool “%1” is in the library. It doesn't turn: its models cut, and their "
                                     "profile keeps them out of the part.")
                                      .arg(QString::fromStdString(made.tool.name)));
        if (made.tool.cutter.isHollow())
            return message_->tell(
                made.coarser ? Notice::Kind::warning : Notice::Kind::passed,
                tr("The tool “%1” is in the library. It is hollow, %2 mm in diameter and %3 mm deep, and leaves a core "
                   "there; its outside is at most %4 mm wider than what its flutes sweep.")
                    .arg(QString::fromStdString(made.tool.name),
                         QString::fromStdString(formatFixed(made.tool.cutter.solid->hollowWidth, 2)),
                         QString::fromStdString(formatFixed(made.tool.cutter.solid->hollowDepth, 2)),
                         QString::fromStdString(formatLimit(made.excess, 4))));
        message_->tell(
            made.coarser ? Notice::Kind::warning : Notice::Kind::passed,
            tr("The tool “%1” is in the library. Its profile is at most %2 mm wider than what its flutes "
               "sweep, and never narrower.")
                .arg(QString::fromStdString(made.tool.name), QString::fromStdString(formatLimit(made.excess, 4))));
    });
    connect(&flow_, &DocumentFlow::restartExported, this, [this](int line, const QString& file) {
        message_->tell(Notice::Kind::passed,
                       tr("The rest of the program from line %1 on passed its check and was written to “%2”.")
                           .arg(QString::number(line), QFileInfo(file).fileName()));
    });
    connect(viewport_, &Viewport::drawingFailed, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::error, sentence); });
    menus_->setRecentFiles(settings_.recentFiles());
}

void MainWindow::connectFirstJob() {
    welcome_->setFirstJobFinished(settings_.firstJobFinished());
    connect(actions_[ActionId::firstJob], &QAction::triggered, this, &MainWindow::beginFirstJob);
    connect(welcome_, &WelcomePage::firstJobRequested, this, &MainWindow::beginFirstJob);
    connect(coach_.get(), &Coach::finished, this, [this] {
        settings_.setFirstJobFinished(true);
        welcome_->setFirstJobFinished(true);
    });
}

/// Closes the project, then starts the first job. While it is running, the same shortcut moves the focus to it; after
/// its last step, it starts again.
void MainWindow::beginFirstJob() {
    if (coach_->running() && !coach_->job().finished()) return coach_->takeKeyboard();
    const auto begin = [this](bool abandon) {
        flow_.closeProject(abandon, [this] {
            message_->dismiss();
            showWelcome();
            coach_->begin();
        });
    };
    flow_.whenSheetIsWritten([this, begin] {
        if (!ending_) flow_.settle(begin);
    });
}

void MainWindow::connectWelcome() {
    connect(welcome_, &WelcomePage::importRequested, &flow_, &DocumentFlow::import);
    connect(welcome_, &WelcomePage::sampleRequested, &flow_, &DocumentFlow::importSample);
    connect(welcome_, &WelcomePage::showMeRequested, &flow_, &DocumentFlow::showSample);
    connect(welcome_, &WelcomePage::openRequested, &flow_, &DocumentFlow::open);
    connect(welcome_, &WelcomePage::recentChosen, &flow_, &DocumentFlow::openAny);
    connect(welcome_, &WelcomePage::leftWorkChosen, &flow_, &DocumentFlow::openAny);
    connect(welcome_, &WelcomePage::leftWorkForgotten, this, [this](const QString& file) {
        if (!confirm(this, tr("Delete this work?"), tr("It was never saved. This can't be undone."), tr("Delete")))
            return;
        DocumentController::forget({file.toStdString(), {}});
        showWelcome();
    });
    lookAgain_.setSingleShot(true);
    lookAgain_.setInterval(std::chrono::seconds(2));
    connect(&lookAgain_, &QTimer::timeout, this, [this] {
        if (pages_->currentWidget() == welcome_) lookForLeftWork();
    });
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/main_window.h"

#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/texts.h"
#include "ui/scene/view_cube_room.h"
#include "ui/window/machine_dialog.h"
#include "ui/window/program_dock.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace burin {

namespace {

constexpr QSize smallestWindow(1024, 680);
constexpr QSize firstWindow(1280, 800);
constexpr std::chrono::milliseconds warmUpAfter(300); // when the welcome page stands, and before anyone has read it

/// What the view shows.
constexpr ActionId shownByAction[] = {ActionId::showPart, ActionId::showWorkpiece, ActionId::showTool,
                                      ActionId::showPath, ActionId::showGuides,    ActionId::showOtherPaths};

/// The one file that is dragged; empty for anything else.
QString draggedFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), states_(actions_, workbench_, nullptr), flow_(workbench_, settings_, *this) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setMinimumSize(smallestWindow);
    dress(settings_.preferences().theme); // before there are widgets: they take font and style from it
    layOut();
    presenters_ =
        std::make_unique<Presenters>(workbench_, actions_, Stage{*viewport_, *jobLine_, *panels_, *status_}, nullptr);
    new ViewOptions(*viewport_, *viewBar_, actions_, settings_, this);
    connectActions();
    connectWorkbench();
    connectWelcome();
    viewport_->setPalette3D(activePalette());
    setUnit(settings_.preferences().unit);
    resize(firstWindow);
    restoreGeometry(settings_.windowGeometry());
    work_->restoreState(settings_.panelWidth());
    view_->restoreState(settings_.viewDocks());
    actions_[ActionId::programDock]->setChecked(settings_.programDocked());
    panels_->meters->setFolded(settings_.metersFolded());
    connect(panels_->meters, &Meters::foldedChanged, this, [this](bool folded) { settings_.setMetersFolded(folded); });
    showStep(JobStep::part);
    showWelcome();
    updateTitle();
    QTimer::singleShot(warmUpAfter, viewport_, &Viewport::warmUp);
}

MainWindow::~MainWindow() {
    presenters_.reset(); // before the widgets that they fill
}

void MainWindow::layOut() {
    menus_ = new Menus(*menuBar(), actions_);
    status_ = new StatusLine(this);
    setStatusBar(status_);
    viewport_ = new Viewport;
    viewport_->setObjectName(QStringLiteral("viewport"));
    viewport_->setFocusPolicy(Qt::StrongFocus);
    viewBar_ = new ViewBar(
        {*actions_[ActionId::parallelView], *actions_[ActionId::sectionPlane], *actions_[ActionId::flipSection]});
    jobLine_ = new JobLine;
    jobLine_->setObjectName(QStringLiteral("jobLine"));
    panels_ = new PanelStack;
    message_ = new MessageStrip;
    welcome_ = new WelcomePage;

    work_ = new QSplitter(Qt::Horizontal);
    work_->setObjectName(QStringLiteral("workSplitter"));
    work_->setChildrenCollapsible(false);
    view_ = makeView();
    programDock_ = new ProgramDock(*panels_->program, *actions_[ActionId::programDock], *view_);
    work_->addWidget(view_);
    work_->addWidget(panels_);
    work_->setStretchFactor(0, 1);
    work_->setStretchFactor(1, 0);
    work_->handle(1)->setToolTip(tr("Drag to make the panel wider or narrower"));
    bench_ = new QWidget;
    bench_->setObjectName(QStringLiteral("benchPage"));
    auto* bench = new QVBoxLayout(bench_);
    bench->setContentsMargins(0, 0, 0, 0);
    bench->setSpacing(0);
    bench->addWidget(jobLine_);
    bench->addWidget(work_, 1);

    pages_ = new QStackedWidget;
    pages_->setObjectName(QStringLiteral("pages"));
    pages_->addWidget(welcome_);
    pages_->addWidget(bench_);
    setCentralWidget(pages_);
    connect(pages_, &QStackedWidget::currentChanged, this, &MainWindow::followPage);
    followPage();
}

void MainWindow::followPage() {
    const bool working = pages_->currentWidget() == bench_;
    const bool leadsBack = !working && workbench_.document.isOpen();
    constexpr int cube = static_cast<int>(ViewCubeRoom::side + 2.0 * ViewCubeRoom::margin);
    message_->layOver(working ? static_cast<QWidget*>(viewport_) : welcome_, working ? cube : 0);
    followProgram();
    status_->setPageEscape(leadsBack ? tr("Esc: back to the project") : QString(), !working);
}

void MainWindow::followProgram() {
    programDock_->setUsed(presenters_ && pages_->currentWidget() == bench_ &&
                          presenters_->job.shown() == JobStep::program);
}

QMainWindow* MainWindow::makeView() {
    auto* docks = new QMainWindow;
    docks->setWindowFlags(Qt::Widget);
    docks->setObjectName(QStringLiteral("viewDocks"));
    docks->setContextMenuPolicy(Qt::NoContextMenu); // the menu offers what there is
    auto* view = new QWidget;
    docks->setCentralWidget(view);
    auto* layout = new QVBoxLayout(view);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(viewport_, 1);
    layout->addWidget(viewBar_);
    return docks;
}

void MainWindow::connectActions() {
    for (std::size_t id = 0; id < static_cast<std::size_t>(ActionId::count); ++id)
        addAction(actions_[static_cast<ActionId>(id)]); // shortcuts hold wherever the keyboard is
    flow_.connectActions(actions_);
    const auto on = [this](ActionId id, auto what) { connect(actions_[id], &QAction::triggered, this, what); };
    on(ActionId::quit, [this] { close(); });
    on(ActionId::preferences, [this] { showPreferences(); });
    const auto step = [this](int by) {
        const int next = std::clamp(static_cast<int>(presenters_->job.shown()) + by, 0, JobLine::steps - 1);
        showStep(static_cast<JobStep>(next));
    };
    on(ActionId::nextStep, [step] { step(1); });
    on(ActionId::previousStep, [step] { step(-1); });
    on(ActionId::embed, [this] { workbench_.bench.embed(); });
    on(ActionId::millMode, [this](bool wanted) {
        showStep(JobStep::mill);
        if (wanted)
            workbench_.mill.enter();
        else
            workbench_.mill.leave();
    });
    on(ActionId::showMe, [this] { workbench_.showHowItIsDone(); });
    on(ActionId::stopShow, [this] { workbench_.showMe.stop(); });
    on(ActionId::guides, [this](bool wanted) { workbench_.guides.setOn(wanted); });
    on(ActionId::nearestEdge, [this] { workbench_.guides.add(GuideKind::curve); });
    on(ActionId::levelAbove, [this] { workbench_.guides.stepLevel(1); });
    on(ActionId::levelBelow, [this] { workbench_.guides.stepLevel(-1); });
    on(ActionId::addFixtureFile, [this] { flow_.importFixture(); });
    on(ActionId::axisOfView, [this] {
        workbench_.surroundings.setAxis({false, -viewport_->sight(QRectF(viewport_->rect()).center()).rayDirection});
    });
    connect(&presenters_->surroundings, &SurroundingsPresenter::fixtureFileWanted, &flow_,
            &DocumentFlow::importFixture);
    connect(panels_->surroundings, &SurroundingsPanel::axisOfViewRequested, actions_[ActionId::axisOfView],
            &QAction::trigger);
    on(ActionId::newPath, [this] { workbench_.path.makeNew(); });
    on(ActionId::drawStretch, [this] { presenters_->pathScene.setDrawing(!presenters_->pathScene.drawing()); });
    on(ActionId::drawEdit, [this] {
        showStep(JobStep::path);
        presenters_->pathScene.toggleLastDrawing();
    });
    on(ActionId::evaluatePath, [this] { workbench_.path.evaluate(); });
    on(ActionId::post, [this] { workbench_.program.post(programName(workbench_)); });
    on(ActionId::findInProgram, [this] {
        showStep(JobStep::program);
        panels_->program->editor().startSearch();
    });
    on(ActionId::programDock, [this](bool docked) {
        if (docked) showStep(JobStep::program); // where one sees what it did
    });
    on(ActionId::overrideCheck, [this] { overrideCheck(); });
    on(ActionId::restart, [this] {
        showStep(JobStep::program);
        flow_.restartProgram(panels_->program->line());
    });
    on(ActionId::machines, [this] { showMachines(); });
    connect(panels_->program, &ProgramPanel::machinesRequested, actions_[ActionId::machines], &QAction::trigger);
    connect(panels_->program, &ProgramPanel::overrideRequested, actions_[ActionId::overrideCheck], &QAction::trigger);
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
    on(ActionId::keyList, [this] { showKeys(); });
    on(ActionId::about, [this] { showAbout(this, QCoreApplication::applicationVersion()); });
    connect(panels_->part, &PartPanel::importRequested, &flow_, &DocumentFlow::import);
    connect(panels_->part, &PartPanel::stlUnitChosen, &flow_, &DocumentFlow::importAgain);
    connect(panels_->program, &ProgramPanel::exportRequested, &flow_, &DocumentFlow::exportProgram);
    connect(panels_->path, &PathPanel::visibilityToggled, actions_[ActionId::showPath], &QAction::setChecked);
    presenters_->mill.connectActions(actions_);
    presenters_->hand.connectActions(actions_, *viewport_);
    connect(&presenters_->millMode, &MillMode::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::information, sentence); });
    connect(&presenters_->mill, &MillPresenter::takeRemovalRequested, this, &MainWindow::removeTake);
    connect(jobLine_, &JobLine::stepChosen, this, &MainWindow::showStep);
    connect(menus_, &Menus::recentChosen, &flow_, &DocumentFlow::openAny);
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::failed, this, [this](const Error& error) {
        const bool stopped = error.code == ErrorCode::cancelled;
        message_->tell(stopped ? Notice::Kind::information : Notice::Kind::error, Messages::sentence(error));
    });
    connect(&flow_, &DocumentFlow::refused, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::error, sentence); });
    connect(&flow_, &DocumentFlow::begun, message_, &MessageStrip::dismiss);
    connect(&flow_, &DocumentFlow::alreadyOpen, this, [this] { showBench(true); });
    connect(&workbench_.hand, &HandController::batteryLow, this, &MainWindow::tellAboutBattery);
    workbench_.styluses.start();
    connect(&workbench_.document, &DocumentController::changed, this, &MainWindow::updateTitle);
    connect(&workbench_.document, &DocumentController::opened, this, [this](const ProjectContents& contents) {
        tellAboutOpened();
        const auto left = leftAtFromJson(contents.leftAt);
        if (left) goTo(*left);
    });
    workbench_.document.keepLeftAt([this] { return toJson(leftAt()); });
    connect(&workbench_.model, &ModelController::imported, this, [this] {
        message_->dismiss();
        showStep(JobStep::stock);
    });
    connect(&workbench_.session, &SessionRunner::changed, this, [this] {
        panels_->meters->setVisible(workbench_.session.running());
        if (workbench_.showMe.showing()) showStep(JobStep::mill);
    });
    connect(&workbench_.showMe, &ShowMe::finished, this, [this] {
        // What was just recorded may not be in the list yet.
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
    connect(&flow_, &DocumentFlow::restartExported, this, [this](int line, const QString& file) {
        message_->tell(Notice::Kind::passed,
                       tr("The rest of the program from line %1 on passed its check and was written to “%2”.")
                           .arg(QString::number(line), QFileInfo(file).fileName()));
    });
    connect(viewport_, &Viewport::drawingFailed, this,
            [this](const QString& sentence) { message_->tell(Notice::Kind::error, sentence); });
    menus_->setRecentFiles(settings_.recentFiles());
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

void MainWindow::showWelcome() {
    lookForLeftWork();
    welcome_->setRecentFiles(settings_.recentFiles());
    welcome_->setProject(workbench_.document.isOpen() ? workbench_.document.title() : QString());
    pages_->setCurrentWidget(welcome_);
    followPage(); // also where it was shown before, and the project is another or none
}

/// And again where a program has some of it open: one that was killed may still be ending.
void MainWindow::lookForLeftWork() {
    const FoundWork found = workbench_.document.leftWork();
    if (found.inUse) lookAgain_.start();
    std::vector<LeftWorkRow> rows;
    for (const LeftWork& work : found.left) {
        const QString file = QString::fromStdString(work.file.string());
        const auto time = std::chrono::file_clock::to_sys(work.changed);
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
        rows.push_back({file, QDateTime::fromSecsSinceEpoch(seconds)});
    }
    welcome_->setLeftWork(rows);
}

/// From the welcome page to the project, where one is open.
void MainWindow::goBack() {
    if (!workbench_.document.isOpen()) return;
    showBench(true);
    if (leftFrom_ && leftFrom_->isVisible()) leftFrom_->setFocus();
}

/// Esc leaves what one is in, wherever the keyboard is; in a field, the field.
void MainWindow::escape() {
    if (auto* list = findChild<KeyList*>()) {
        list->close();
        return;
    }
    if (pages_->currentWidget() == welcome_) return goBack();
    InteractiveTool* tool = viewport_->interactiveTool();
    if (tool == nullptr || !tool->key(Qt::Key_Escape, Qt::NoModifier)) {
        activateWindow(); // a dock may be a window of its own
        viewport_->setFocus();
    }
}

void MainWindow::showBench(bool shown) {
    pages_->setCurrentWidget(shown ? bench_ : welcome_);
    if (shown) viewport_->setFocus();
}

void MainWindow::showStep(JobStep step) {
    // The left button cuts where one sees that it does. (A device's own button is another matter.)
    if (step != JobStep::mill && workbench_.mill.stylus() != nullptr) workbench_.mill.leave();
    presenters_->job.setShown(step);
    presenters_->guideScene.setShown(step);
    presenters_->deviation.setShown(step == JobStep::program);
    // Who lets go of the pointer comes before who takes it.
    if (step == JobStep::program) presenters_->pathScene.setShown(step);
    presenters_->programScene.setShown(step);
    if (step != JobStep::program) presenters_->pathScene.setShown(step);
    panels_->showStep(step);
    followProgram();
}

LeftAt MainWindow::leftAt() const {
    LeftAt left;
    left.step = presenters_->job.shown();
    left.tool = workbench_.tool.current().id;
    left.mill = presenters_->millMode.settings();
    left.camera = viewport_->cameraView();
    for (const ActionId id : shownByAction) left.shown[actions_[id]->objectName()] = actions_[id]->isChecked();
    return left;
}

void MainWindow::goTo(const LeftAt& left) {
    if (workbench_.model.model()) showStep(left.step);
    workbench_.tool.show(left.tool);
    presenters_->millMode.setSettings(left.mill);
    for (const ActionId id : shownByAction)
        actions_[id]->setChecked(left.shown.value(actions_[id]->objectName(), actions_[id]->isChecked()));
    // The presenters have to show the part first, which fits it into the picture.
    QMetaObject::invokeMethod(
        this, [this, camera = left.camera] { viewport_->setCameraView(camera); }, Qt::QueuedConnection);
}

void MainWindow::tellAboutOpened() {
    message_->dismiss();
    showBench(true);
    showStep(workbench_.model.model() ? JobStep::mill : JobStep::part);
    const DocumentController& document = workbench_.document;
    if (!document.keptAside().empty())
        message_->tell(Notice::Kind::warning,
                       tr("Older unsaved work did not belong to this file any more; it was moved to “%1”.")
                           .arg(QString::fromStdString(document.keptAside().filename().string())));
    else if (document.readOnly())
        message_->tell(Notice::Kind::warning,
                       tr("The folder can't be written, so this project is open for reading only; save it elsewhere to "
                          "change it."));
    else if (document.recovered())
        message_->tell(
            Notice::Kind::information,
            tr("Burin ended before this work was saved; everything that was entered and recorded is restored."));
}

void MainWindow::tellAboutBattery(double share) {
    message_->tell(Notice::Kind::warning, tr("The battery of “%1” is down to %2; charge it soon.")
                                              .arg(workbench_.styluses.chosenName(), shareText(share)));
}

void MainWindow::updateTitle() {
    const DocumentController& document = workbench_.document;
    setWindowTitle(document.isOpen() ? tr("%1[*] — Burin").arg(document.title()) : tr("Burin"));
    setWindowModified(document.isOpen() && document.unsaved());
}

void MainWindow::dress(Theme theme) {
    const Result<Palette> palette = loadPalette(theme);
    if (palette)
        applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()), *palette);
    else // Qt's own colours serve as well
        QMetaObject::invokeMethod(
            this, [this, error = palette.error()] { message_->tell(Notice::Kind::error, Messages::sentence(error)); },
            Qt::QueuedConnection);
}

/// Only what is another one than before: a theme visits every widget.
void MainWindow::apply(const Preferences& preferences, const Preferences& before) {
    if (preferences.theme != before.theme) {
        dress(preferences.theme);
        viewport_->setPalette3D(activePalette());
    }
    if (preferences.unit != before.unit) setUnit(preferences.unit);
}

void MainWindow::setUnit(LengthUnit unit) {
    presenters_->setUnit(unit);
    viewBar_->setUnit(unit);
}

void MainWindow::showPreferences() {
    PreferencesDialog dialog(settings_.preferences(), this);
    connect(&dialog, &PreferencesDialog::preferencesChanged, this, [this](const Preferences& preferences) {
        const Preferences before = settings_.preferences();
        settings_.setPreferences(preferences);
        apply(preferences, before);
    });
    dialog.exec();
}

void MainWindow::showKeys() {
    auto* list = findChild<KeyList*>();
    if (list == nullptr) {
        std::vector<KeySection> sections{{tr("Mouse in the view"), HandKeys::ofTheView()},
                                         {tr("In mill mode"), HandKeys::inMillMode()},
                                         {tr("On the path"), HandKeys::onThePath()}};
        std::ranges::move(menus_->keys(), std::back_inserter(sections));
        list = new KeyList(sections, this);
        list->setAttribute(Qt::WA_DeleteOnClose);
    }
    list->show();
    list->raise();
    list->activateWindow();
}

void MainWindow::removeTake(qint64 take) {
    const auto& takes = workbench_.mill.takes();
    const auto found = std::ranges::find(takes, take, &TakeInfo::id);
    if (found == takes.end()) return;
    if (confirm(this, tr("Delete “%1”?").arg(takeName(found->name)),
                tr("The workpiece is milled again without it. This can't be undone."), tr("Delete")))
        workbench_.mill.removeTake(take);
}

void MainWindow::showMachines() {
    MachineDialog dialog(workbench_.target, settings_.preferences().unit, this);
    dialog.exec();
}

void MainWindow::overrideCheck() {
    if (!workbench_.program.refused()) return;
    const auto count = static_cast<int>(workbench_.program.program()->errorCount());
    const QString reason = askReason(
        this, tr("Export a program that was refused?"),
        count == 1 ? tr("Its check found 1 problem that can damage a tool, the part or the machine.")
                   : tr("Its check found %n problems that can damage a tool, the part or the machine.", nullptr, count),
        tr("Your reason. It goes into the program's header together with the findings."));
    if (!reason.isEmpty()) workbench_.program.overrideCheck(programName(workbench_), reason);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (ended_) {
        event->accept();
        return;
    }
    event->ignore();
    if (ending_) return;
    flow_.settle([this](bool abandon) { end(abandon); });
}

void MainWindow::endQuietly() {
    if (!ending_) end(false);
}

void MainWindow::end(bool abandon) {
    ending_ = true;
    settings_.setWindowGeometry(saveGeometry());
    settings_.setPanelWidth(work_->saveState());
    settings_.setViewDocks(view_->saveState());
    settings_.setProgramDocked(actions_[ActionId::programDock]->isChecked());
    flow_.closeProject(abandon, [this] {
        ended_ = true;
        close();
    });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString file = draggedFile(*event->mimeData());
    if (file.isEmpty()) return;
    event->acceptProposedAction();
    // The drop ends first: a question would hold up the program that the file comes from.
    QMetaObject::invokeMethod(
        this, [this, file] { openFile(file); }, Qt::QueuedConnection);
}

} // namespace burin

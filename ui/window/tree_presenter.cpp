// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/tree_presenter.h"

#include "ui/panels/model_labels.h"
#include "ui/panels/texts.h"
#include "ui/window/body_rows.h"
#include "ui/window/context_menu.h"
#include "ui/window/path_presenters.h"
#include "ui/window/take_menu.h"

#include <QMenu>

#include <algorithm>

namespace burin {

namespace {

ProjectRow group(qint64 place, const QString& name) {
    ProjectRow node;
    node.id = place;
    node.name = name;
    return node;
}

} // namespace

TreePresenter::TreePresenter(Workbench& workbench, ProjectTree& tree, ScenePresenter& scene, QObject* parent)
    : Presenter(workbench,
                {&workbench.setups, &workbench.setup, &workbench.model, &workbench.surroundings, &workbench.tool,
                 &workbench.mill, &workbench.path, &workbench.program},
                parent)
    , tree_(tree)
    , scene_(scene) {
    yieldWhileHidden(tree);
    connect(&tree, &ProjectTree::opened, this, &TreePresenter::open);
    connect(&tree, &ProjectTree::chosen, this, [this](ProjectRowKind kind, qint64 id) {
        workbench_.mill.chooseTake(kind == ProjectRowKind::take ? id : 0);
    });
    connect(&tree, &ProjectTree::switched, this, &TreePresenter::switchRow);
    connect(&tree, &ProjectTree::menuRequested, this, &TreePresenter::showMenu);
    connect(&tree, &ProjectTree::moved, this, [this](ProjectRowKind kind, qint64 id, qint64 before) {
        if (kind == ProjectRowKind::take) workbench_.mill.moveTakeBefore(id, before);
    });
}

void TreePresenter::present() {
    const std::shared_ptr<const Model>& part = workbench_.setup.part();
    const bool other =
        (part == nullptr) != (model_ == nullptr) ||
        (part && model_ && (part->sourceFile != model_->sourceFile || part->bodies.size() != model_->bodies.size()));
    if (other && !hidden_.empty()) hide({});
    model_ = part;
    std::vector<ProjectRow> rows{setups(), bodies(), fixtures(), tools(), takes(), paths(), programs()};
    std::erase_if(rows, [](const ProjectRow& node) { return node.children.empty(); });
    tree_.setRows(rows);
    tree_.choose(ProjectRowKind::take, workbench_.mill.chosenTake());
}

ProjectRow TreePresenter::setups() const {
    ProjectRow all = group(0, tr("Setups"));
    for (const SetupName& setup : workbench_.setups.setups()) {
        ProjectRow row{ProjectRowKind::setup,
                       static_cast<qint64>(setup.id),
                       workbench_.setups.title(setup.id),
                       {},
                       tr("Double click: work in this setup.")};
        row.current = setup.id == workbench_.setups.used();
        all.children.push_back(std::move(row));
    }
    return all;
}

ProjectRow TreePresenter::bodies() const {
    ProjectRow all = group(1, tr("Part"));
    const std::shared_ptr<const Model>& part = workbench_.setup.part();
    if (!part || workbench_.model.preview()) return all;
    all.children = rowsOfBodies({*part, workbench_.setup.setup(), workbench_.model.colours(), hidden_});
    return all;
}

ProjectRow TreePresenter::fixtures() const {
    ProjectRow all = group(2, tr("Fixtures and keep-out volumes"));
    const std::vector<PlacedObstacle>& obstacles = workbench_.surroundings.wanted().obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        ProjectRow row{ProjectRowKind::fixture, static_cast<qint64>(i),
                       QString::fromStdString(obstacles[i].obstacle->name),
                       obstacles[i].obstacle->kind == ObstacleKind::fixture ? tr("fixture") : tr("keep-out"),
                       tr("Tick: the tool keeps clear of it.")};
        row.on = obstacles[i].on;
        all.children.push_back(std::move(row));
    }
    return all;
}

ProjectRow TreePresenter::tools() const {
    ProjectRow all = group(3, tr("Tools"));
    std::vector<std::string> used = workbench_.path.toolsThatMilled();
    for (const StoredPath& path : workbench_.path.jobPaths())
        if (const std::string tool = workbench_.path.toolOf(path.id); std::ranges::find(used, tool) == used.end())
            used.push_back(tool);
    const std::string& current = workbench_.tool.current().id;
    if (std::ranges::find(used, current) == used.end()) used.push_back(current);
    const std::vector<Tool>& known = workbench_.tool.tools();
    for (const std::string& id : used) {
        const auto tool = std::ranges::find(known, id, &Tool::id);
        if (tool == known.end()) continue;
        ProjectRow row{ProjectRowKind::tool, tool - known.begin(), toolName(*tool),
                       QStringLiteral("T%1").arg(tool->number), tr("Double click: load this tool.")};
        row.current = id == current;
        all.children.push_back(std::move(row));
    }
    return all;
}

ProjectRow TreePresenter::takes() const {
    ProjectRow all = group(4, tr("Takes"));
    const std::vector<TakeInfo>& standing = workbench_.mill.takes();
    for (const TakeInfo& take : workbench_.mill.allTakes()) {
        ProjectRow row{ProjectRowKind::take, take.id, takeName(take.name),
                       take.seconds ? durationText(*take.seconds) : QString(),
                       tr("Drag: move it. Right click: switch it off and on, move, duplicate, rename or delete it.")};
        row.movable = workbench_.mill.canCopy(take.id);
        row.dimmed = std::ranges::find(standing, take.id, &TakeInfo::id) == standing.end();
        all.children.push_back(std::move(row));
    }
    return all;
}

ProjectRow TreePresenter::paths() const {
    ProjectRow all = group(5, tr("Paths"));
    const StoredPath* current = workbench_.path.stored();
    for (const StoredPath& path : workbench_.path.jobPaths()) {
        ProjectRow row{
            ProjectRowKind::path, path.id, toolName(workbench_.tool.tools(), workbench_.path.toolOf(path.id)),
            path.edits.size() == 1 ? tr("1 edit") : tr("%n edits", nullptr, static_cast<int>(path.edits.size())),
            tr("Double click: load its tool and edit it.")};
        row.current = current != nullptr && current->id == path.id;
        if (row.current)
            for (const GeneratedInfo& pass : workbench_.path.passes())
                row.children.push_back(
                    {ProjectRowKind::pass, pass.id, passName(pass), {}, tr("Right click: order and delete passes.")});
        all.children.push_back(std::move(row));
    }
    return all;
}

ProjectRow TreePresenter::programs() const {
    ProjectRow all = group(6, tr("Program"));
    const ProgramController& program = workbench_.program;
    if (!program.program() && program.storedText().isEmpty()) return all;
    QString state = tr("not checked");
    if (program.program() && !program.edited())
        state = program.outdated()              ? tr("out of date")
                : program.program()->passed()   ? tr("passed")
                : program.program()->overridden ? tr("overridden")
                                                : tr("refused");
    all.children.push_back(
        {ProjectRowKind::program, 0, programName(workbench_), state, tr("Double click: show its text and findings.")});
    return all;
}

void TreePresenter::open(ProjectRowKind kind, qint64 id) {
    switch (kind) {
    case ProjectRowKind::setup:
        workbench_.setups.use(SetupId{id});
        break;
    case ProjectRowKind::assembly:
    case ProjectRowKind::body:
        emit stepRequested(JobStep::part);
        break;
    case ProjectRowKind::fixture:
        emit stepRequested(JobStep::mill);
        break;
    case ProjectRowKind::tool:
        if (static_cast<std::size_t>(id) < workbench_.tool.tools().size())
            workbench_.tool.choose(workbench_.tool.tools()[static_cast<std::size_t>(id)].id);
        break;
    case ProjectRowKind::take:
        emit stepRequested(JobStep::mill);
        break;
    case ProjectRowKind::path:
        workbench_.tool.choose(workbench_.path.toolOf(id));
        emit stepRequested(JobStep::path);
        break;
    case ProjectRowKind::pass:
        emit stepRequested(JobStep::path);
        break;
    case ProjectRowKind::program:
        emit stepRequested(JobStep::program);
        break;
    case ProjectRowKind::group:
        break;
    }
}

void TreePresenter::switchRow(ProjectRowKind kind, qint64 id, bool on) {
    if (kind == ProjectRowKind::fixture) workbench_.surroundings.setOn(static_cast<std::size_t>(id), on);
    const std::vector<std::size_t> bodies = chosenBodies(kind, id).bodies;
    if (bodies.empty()) return;
    std::set<std::size_t> hidden = hidden_;
    for (const std::size_t body : bodies) on ? void(hidden.erase(body)) : void(hidden.insert(body));
    hide(hidden);
}

void TreePresenter::showMenu(ProjectRowKind kind, qint64 id, const QPoint& globalPosition) {
    if (kind == ProjectRowKind::setup) showSetupMenu(id, globalPosition);
    if (const ChosenBodies chosen = chosenBodies(kind, id); !chosen.bodies.empty())
        showBodyMenu(
            workbench_, chosen, hidden_, [this](const std::set<std::size_t>& bodies) { hide(bodies); }, globalPosition,
            &tree_);
    if (kind == ProjectRowKind::fixture) showFixtureMenu(static_cast<std::size_t>(id), globalPosition);
    if (kind == ProjectRowKind::take) showTakeMenu(workbench_, id, 0, globalPosition, &tree_);
    if (kind == ProjectRowKind::pass) showPassMenu(id, globalPosition);
}

void TreePresenter::showSetupMenu(qint64 id, const QPoint& globalPosition) {
    SetupsController& setups = workbench_.setups;
    QMenu* menu = makeContextMenu("setupMenu", setups.title(SetupId{id}), &tree_);
    if (SetupId{id} != setups.used()) {
        addEntry(*menu, tr("&Work in it"), tr("Switch to this setup."), "useSetupAction",
                 [&setups, id] { setups.use(SetupId{id}); });
    } else {
        addEntry(*menu, tr("&Rename…"), tr("Rename the setup."), "renameSetupAction", [this, &setups, id] {
            const QString name = askName(tr("Rename the setup"), setups.title(SetupId{id}), &tree_);
            if (!name.isEmpty()) setups.rename(name);
        });
        if (setups.setups().size() > 1)
            addEntry(*menu, tr("&Delete"), tr("Delete the setup, if nothing was recorded in it."), "deleteSetupAction",
                     [&setups] { setups.remove(); });
    }
    menu->popup(globalPosition);
}

ChosenBodies TreePresenter::chosenBodies(ProjectRowKind kind, qint64 id) const {
    if (!model_) return {};
    const auto body = static_cast<std::size_t>(id);
    if (kind == ProjectRowKind::body && body < model_->bodies.size())
        return {bodyName(std::string(lastElement(model_->bodies[body].name))), {body}};
    if (kind != ProjectRowKind::assembly) return {};
    const std::vector<BodyNode> tree = bodyTree(*model_);
    const BodyNode* assembly = assemblyOfRow(tree, id);
    return assembly != nullptr ? ChosenBodies{bodyName(assembly->name), bodiesOf(*assembly)} : ChosenBodies();
}

void TreePresenter::showFixtureMenu(std::size_t place, const QPoint& globalPosition) {
    const std::vector<PlacedObstacle>& obstacles = workbench_.surroundings.wanted().obstacles;
    if (place >= obstacles.size()) return;
    QMenu* menu = makeContextMenu("fixtureMenu", QString::fromStdString(obstacles[place].obstacle->name), &tree_);
    const Obstacle& fixture = *obstacles[place].obstacle;
    if (fixture.design)
        addEntry(*menu, tr("&Change…"), tr("Change its sizes and its position."), "changeFixtureAction",
                 [this, place] { workbench_.fixtures.beginChange(place); });
    else
        addEntry(*menu, tr("&Move"), tr("Move it in the view, with the mouse or the keys."), "moveFixtureAction",
                 [this, place] { workbench_.mover.begin(place); });
    addEntry(*menu, tr("&Rename…"), tr("Rename it."), "renameFixtureAction",
             [this, place, before = QString::fromStdString(fixture.name)] {
                 workbench_.surroundings.rename(place, askName(tr("Rename the fixture"), before, &tree_));
             });
    addEntry(*menu, tr("&Delete"), tr("Delete it from the setup."), "deleteFixtureAction",
             [this, place] { workbench_.surroundings.remove(place); });
    menu->popup(globalPosition);
}

void TreePresenter::showPassMenu(qint64 id, const QPoint& globalPosition) {
    PathController& path = workbench_.path;
    const std::vector<GeneratedInfo> passes = path.passes();
    const auto pass = std::ranges::find(passes, id, &GeneratedInfo::id);
    if (pass == passes.end()) return;
    QMenu* menu = makeContextMenu("passMenu", passName(*pass), &tree_);
    addEntry(*menu, tr("Mill it &earlier"), tr("Mill this pass before the one above."), "passEarlierAction",
             [&path, id] { path.movePassUp(id); });
    addEntry(*menu, tr("&Delete"), tr("Delete this pass."), "deletePassAction", [&path, id] { path.removePass(id); });
    menu->popup(globalPosition);
}

void TreePresenter::hideBodies(std::set<std::size_t> bodies) {
    model_ = workbench_.setup.part();
    const std::size_t count = model_ ? model_->bodies.size() : 0;
    bodies.erase(bodies.lower_bound(count), bodies.end()); // a damaged project can name any
    hide(bodies);
}

void TreePresenter::hide(const std::set<std::size_t>& bodies) {
    hidden_ = bodies;
    scene_.setHiddenBodies(hidden_);
    presentSoon();
}

} // namespace burin

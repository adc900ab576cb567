// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/surroundings_controller.h"

#include "core/cad/import.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double besideStock = 2.0;   // mm
constexpr double fixtureShare = 0.25; // of the stock's longest side
constexpr double sameAxis = 1e-12;    // of 1 - cos

glm::dvec3 placeBeside(const Box& stock) {
    return {stock.high.x + besideStock, stock.centre().y, stock.low.z};
}

double sizeFor(const Box& stock) {
    const glm::dvec3 size = stock.size();
    return std::max(1.0, std::round(fixtureShare * std::max({size.x, size.y, size.z})));
}

} // namespace

SurroundingsController::SurroundingsController(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                                               SessionRunner& session, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), mill_(mill), session_(session) {
    connect(&mill_, &MillController::entered, this, &SurroundingsController::switchLayers);
    connect(&session_, &SessionRunner::changed, this, &Controller::changed);
    connect(&session_, &SessionRunner::recordingStarted, this, &SurroundingsController::letGoOfStock);
}

void SurroundingsController::load(std::vector<Obstacle> obstacles, const AxisMode& axis,
                                  const TravelPlacement& travel) {
    wanted_ = {placed(std::move(obstacles)), axis, travel};
    stockHolds_ = false;
    emit changed();
}

QString SurroundingsController::freeName(const QString& pattern) const {
    const bool numbered = pattern.contains(QStringLiteral("%1"));
    for (int number = 1;; ++number) {
        const QString name = numbered      ? pattern.arg(number)
                             : number == 1 ? pattern
                                           : pattern + QStringLiteral(" %1").arg(number);
        const auto same = [&](const PlacedObstacle& other) { return other.obstacle->name == name.toStdString(); };
        if (std::ranges::none_of(wanted_.obstacles, same)) return name;
    }
}

QString SurroundingsController::nameFor(ObstacleKind kind) const {
    return freeName(kind == ObstacleKind::keepOut ? tr("Keep-out %1") : tr("Fixture %1"));
}

void SurroundingsController::addBox(ObstacleKind kind) {
    if (!workpiece_.hasModel()) return;
    const Box stock = workpiece_.wantedStock();
    const glm::dvec3 low = placeBeside(stock);
    const double size = sizeFor(stock);
    add({nameFor(kind).toStdString(),
         Box{low - glm::dvec3(0.0, 0.5 * size, 0.0), low + glm::dvec3(size, 0.5 * size, size)},
         kind == ObstacleKind::fixture ? fixtureMargin : 0.0, true, kind});
}

void SurroundingsController::addCylinder(ObstacleKind kind) {
    if (!workpiece_.hasModel()) return;
    const Box stock = workpiece_.wantedStock();
    const double size = sizeFor(stock);
    CylinderShape cylinder;
    cylinder.radius = 0.5 * size;
    cylinder.base = placeBeside(stock) + glm::dvec3(cylinder.radius, 0.0, 0.0);
    cylinder.height = size;
    add({nameFor(kind).toStdString(), cylinder, kind == ObstacleKind::fixture ? fixtureMargin : 0.0, true, kind});
}

void SurroundingsController::add(Obstacle obstacle) {
    if (locked()) return;
    std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
    obstacles.push_back({std::make_shared<const Obstacle>(std::move(obstacle)), true});
    setObstacles(tr("new fixture"), std::move(obstacles));
}

void SurroundingsController::importFile(const std::filesystem::path& file, double fileUnit) {
    if (locked()) return;
    const std::string name = file.stem().string();
    desk_.tasks.start(
        TaskKind::fixture, tr("Importing %1").arg(QString::fromStdString(file.filename().string())),
        [file, name, fileUnit](Progress& progress) -> Result<std::vector<Obstacle>> {
            ImportOptions options;
            options.fileUnit = fileUnit;
            const Result<Model> model = importModel(file, options, progress);
            if (!model) return model.error();
            return fixturesOf(*model, name, fixtureMargin);
        },
        [this](Result<std::vector<Obstacle>> fixtures) {
            if (!fixtures) {
                emit changed();
                emit failed(fixtures.error());
                return;
            }
            std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
            for (PlacedObstacle& fixture : placed(std::move(*fixtures))) obstacles.push_back(std::move(fixture));
            setObstacles(tr("new fixture"), std::move(obstacles));
        });
    emit changed();
}

void SurroundingsController::change(std::size_t place, const Obstacle& obstacle) {
    changeTo(place, obstacle, tr("fixture"), obstacleValue + static_cast<int>(place));
}

void SurroundingsController::move(std::size_t place, const Obstacle& obstacle) {
    changeTo(place, obstacle, tr("fixture moved"), -1);
}

void SurroundingsController::changeTo(std::size_t place, const Obstacle& obstacle, const QString& title, int kind) {
    if (locked() || place >= wanted_.obstacles.size() || *wanted_.obstacles[place].obstacle == obstacle) return;
    if (const Result<void> good = checkObstacle(obstacle); !good) {
        emit changed(); // resets the panel to the value in force
        emit failed(good.error());
        return;
    }
    std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
    obstacles[place].obstacle = std::make_shared<const Obstacle>(obstacle);
    setObstacles(title, std::move(obstacles), kind);
}

void SurroundingsController::rename(std::size_t place, const QString& name) {
    if (locked() || place >= wanted_.obstacles.size() || name.isEmpty()) return;
    Obstacle renamed = *wanted_.obstacles[place].obstacle;
    if (renamed.name == name.toStdString()) return;
    renamed.name = freeName(name).toStdString();
    std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
    obstacles[place].obstacle = std::make_shared<const Obstacle>(std::move(renamed));
    setObstacles(tr("fixture renamed"), std::move(obstacles));
}

void SurroundingsController::remove(std::size_t place) {
    if (locked() || place >= wanted_.obstacles.size()) return;
    std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
    obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(place));
    setObstacles(tr("fixture deleted"), std::move(obstacles));
}

void SurroundingsController::setOn(std::size_t place, bool on) {
    if (place >= wanted_.obstacles.size() || wanted_.obstacles[place].on == on) return;
    std::vector<PlacedObstacle> obstacles = wanted_.obstacles;
    obstacles[place].on = on;
    setObstacles(on ? tr("fixture on") : tr("fixture off"), std::move(obstacles));
}

void SurroundingsController::setObstacles(const QString& title, std::vector<PlacedObstacle> obstacles, int kind) {
    desk_.undo.push(new ValueCommand<std::vector<PlacedObstacle>>(
        title, kind, wanted_.obstacles, std::move(obstacles),
        [this](const std::vector<PlacedObstacle>& value) { apply(value); }));
}

void SurroundingsController::apply(const std::vector<PlacedObstacle>& obstacles) {
    wanted_.obstacles = obstacles;
    store([obstacles](Project& project) { return project.setObstacles(obstaclesOf(obstacles)); });
    switchLayers();
    emit changed();
}

void SurroundingsController::setAxis(const AxisMode& axis) {
    const double length = glm::length(axis.direction);
    if (locked() || !(length > 0.0)) return;
    AxisMode wanted{axis.free, axis.direction / length};
    if (wanted.direction.z > 1.0 - sameAxis) wanted.direction = {0.0, 0.0, 1.0}; // a view from above means exactly +Z
    if (wanted.free == wanted_.axis.free && wanted.direction == wanted_.axis.direction) return;
    desk_.undo.push(
        new ValueCommand<AxisMode>(tr("tool axis"), axisValue, wanted_.axis, wanted, [this](const AxisMode& value) {
            wanted_.axis = value;
            store([value](Project& project) { return project.setAxisMode(value); });
            emit changed();
        }));
}

void SurroundingsController::setTravelOn(bool on) {
    if (on == wanted_.travel.on) return;
    TravelPlacement wanted = wanted_.travel;
    wanted.on = on;
    desk_.undo.push(new ValueCommand<TravelPlacement>(
        tr("machine's travel"), -1, wanted_.travel, wanted, [this](const TravelPlacement& value) {
            wanted_.travel = value;
            store([value](Project& project) { return project.setTravelPlacement(value); });
            switchLayers();
            emit changed();
        }));
}

void SurroundingsController::setEditing(bool editing) {
    editing_ = editing;
    switchLayers();
    emit changed();
}

/// The part's layer comes first; empty while the bounds in force are others.
std::optional<std::size_t> SurroundingsController::layerOf(std::size_t place) const {
    const std::vector<PlacedObstacle>& bound = workpiece_.bound().obstacles;
    if (!moves() || place >= bound.size() || place >= wanted_.obstacles.size() ||
        bound[place].obstacle != wanted_.obstacles[place].obstacle)
        return std::nullopt;
    return place + 1;
}

std::optional<std::size_t> SurroundingsController::layerOfKind(BoundLayer::Kind kind) const {
    if (!moves() || !workpiece_.bounds()) return std::nullopt;
    const std::vector<BoundLayer>& layers = workpiece_.bounds()->layers();
    const auto layer = std::ranges::find(layers, kind, &BoundLayer::kind);
    if (layer == layers.end()) return std::nullopt;
    return static_cast<std::size_t>(layer - layers.begin());
}

std::optional<LayerNews> SurroundingsController::newsOf(std::optional<std::size_t> layer) const {
    const std::vector<LayerNews>& layers = session_.state().layers;
    return layer && *layer < layers.size() ? std::optional(layers[*layer]) : std::nullopt;
}

std::optional<LayerNews> SurroundingsController::news(std::size_t place) const {
    return newsOf(layerOf(place));
}

std::optional<LayerNews> SurroundingsController::travelNews() const {
    return newsOf(layerOfKind(BoundLayer::Kind::machineTravel));
}

/// The session has switched the layer off, or there is none.
void SurroundingsController::letGoOfStock() {
    desk_.tasks.abandon(TaskKind::touching); // its end would interrupt the recording
    if (std::exchange(stockHolds_, false)) emit changed();
}

bool SurroundingsController::canHoldAtStock() const {
    return mill_.active() && !mill_.recording() && (layerOfKind(BoundLayer::Kind::stock) || workpiece_.canBringStock());
}

void SurroundingsController::holdAtStock(bool hold) {
    if (hold == stockHolds_ || (hold && !canHoldAtStock())) return;
    stockHolds_ = hold;
    if (const std::optional<std::size_t> layer = layerOfKind(BoundLayer::Kind::stock))
        session_.setLayer(*layer, hold);
    else if (hold)
        bringStock();
    emit changed();
}

/// Mill mode is entered again with that layer, which `switchLayers` then switches on.
void SurroundingsController::bringStock() {
    workpiece_.bringStock([this] { letGoOfStock(); });
}

std::optional<LayerNews> SurroundingsController::stockNews() const {
    return newsOf(layerOfKind(BoundLayer::Kind::stock));
}

/// After a break of mill mode, as each new program zero causes, the stock holds the tool as before.
void SurroundingsController::switchLayers() {
    if (stockHolds_ && mill_.active()) {
        if (const std::optional<std::size_t> stock = layerOfKind(BoundLayer::Kind::stock))
            session_.setLayer(*stock, true);
        else
            bringStock();
    }
    for (std::size_t place = 0; place < wanted_.obstacles.size(); ++place)
        if (const std::optional<std::size_t> layer = layerOf(place))
            session_.setLayer(*layer, wanted_.obstacles[place].on);
    if (const std::optional<std::size_t> layer = layerOfKind(BoundLayer::Kind::machineTravel))
        session_.setLayer(*layer, wanted_.travel.on);
}

} // namespace burin

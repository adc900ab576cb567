// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/setup_controller.h"

#include "core/job/left_stock.h"
#include "ui/workbench/undo_refusal.h"
#include "ui/workbench/value_command.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr const char* defaultMaterial = "machinable-wax";

/// The title of a change of the stock's shape, and the kind with which it is merged.
struct ShapeChange {
    QString title;
    int kind = -1;
};

ShapeChange changeFrom(const Setup& before, const Setup& after) {
    if (before.voxel != after.voxel) return {SetupController::tr("voxel size"), voxelValue};
    if (before.freeCarving != after.freeCarving) return {SetupController::tr("free carving"), -1};
    if (before.form != after.form || before.stated != after.stated)
        return {SetupController::tr("shape of the stock"), -1};
    if (before.marginLow != after.marginLow || before.marginHigh != after.marginHigh)
        return {SetupController::tr("stock margin"), marginValue};
    return {SetupController::tr("shape of the stock"), stockShapeValue};
}

bool sameForm(const Setup& one, const Setup& other) {
    if (one.form != other.form || one.stated != other.stated || one.freeCarving != other.freeCarving) return false;
    if (one.form == StockForm::cylinder)
        return one.stated ? one.cylinder == other.cylinder : one.cylinder.axis == other.cylinder.axis;
    if (one.form == StockForm::file)
        return one.volume == other.volume ||
               (one.volume && other.volume && one.volume->checksum() == other.volume->checksum());
    return one.form != StockForm::box || !one.stated ||
           (one.stock.low == other.stock.low && one.stock.high == other.stock.high);
}

/// A setup without roles has the same roles as one in which all bodies are parts.
bool sameRoles(const Setup& one, const Setup& other) {
    for (std::size_t i = 0; i < std::max(one.roles.size(), other.roles.size()); ++i)
        if (roleOf(one, i) != roleOf(other, i)) return false;
    return true;
}

bool sameMaterials(const Setup& one, const Setup& other) {
    return one.stockMaterial == other.stockMaterial && one.bodyMaterials == other.bodyMaterials;
}

/// Machinable bodies and layers of one material share an entry of the property list; changing the material may split
/// it.
bool sharesMaterials(const Setup& setup) {
    return setup.form == StockForm::file || !setup.regions.empty() ||
           std::ranges::find(setup.roles, BodyRole::insert) != setup.roles.end();
}

/// Removes the stock left by another setup: it does not apply to other forms of stock, and would not be restored with
/// its true faces.
Setup withoutLeft(Setup setup) {
    setup.leftBy.reset();
    setup.volume = nullptr;
    return setup;
}

} // namespace

double suitableVoxel(const Box& part) {
    const glm::dvec3 size = part.size();
    const double longest = std::max({size.x, size.y, size.z, 1e-3});
    const double wanted = std::max(longest / 200.0, (longest + 2.0 * firstMargin) / 600.0);
    double best = 0.5;
    double leastRatio = std::numeric_limits<double>::infinity();
    for (const double decade : {0.001, 0.01, 0.1, 1.0, 10.0})
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double ratio = std::abs(std::log(decade * digit / wanted));
            if (ratio >= leastRatio) continue;
            leastRatio = ratio;
            best = decade * digit;
        }
    return best;
}

bool shapedAlike(const Setup& one, const Setup& other) {
    return one.voxel == other.voxel && one.placement == other.placement && one.marginLow == other.marginLow &&
           one.marginHigh == other.marginHigh && sameForm(one, other) && sameRoles(one, other) &&
           one.regions == other.regions && (!sharesMaterials(one) || sameMaterials(one, other));
}

bool embedAlike(const Setup& one, const Setup& other) {
    return shapedAlike(one, other) && sameMaterials(one, other);
}

SetupController::SetupController(const Desk& desk, QObject* parent) : Controller(desk, parent) {
    readMaterials({});
}

/// @param own materials stored in the project
void SetupController::readMaterials(const std::vector<Property>& own) {
    materials_ = own;
    for (const std::string& id : materialIds())
        if (std::ranges::find(own, id, &Property::id) == own.end())
            if (Result<Property> material = loadMaterial(id)) materials_.push_back(std::move(*material));
    std::ranges::sort(materials_, {}, &Property::id);
}

void SetupController::readLibrary() {
    const std::vector<std::string> library = materialIds(), used = materialsUsed(setup_);
    const auto isIn = [](const std::vector<std::string>& ids, const Property& material) {
        return std::ranges::find(ids, material.id) != ids.end();
    };
    std::vector<Property> kept;
    for (const Property& material : materials_)
        if (isIn(used, material) && (locked_ || !isIn(library, material))) kept.push_back(material);
    readMaterials(kept);
    if (model_ && !locked_ && !problem_) storeSetup();
    emit changed();
}

const Property* SetupController::stockMaterial() const {
    const auto found = std::ranges::find(materials_, setup_.stockMaterial, &Property::id);
    if (found == materials_.end() && setup_.form == StockForm::file && setup_.volume)
        return &setup_.volume->materials()[setup_.volume->mainMaterial()];
    return found == materials_.end() ? nullptr : &*found;
}

void SetupController::setLocked(bool locked) {
    if (locked == locked_) return;
    locked_ = locked;
    emit changed();
}

void SetupController::placeAround(std::shared_ptr<const Model> model) {
    imported_ = std::move(model);
    model_ = imported_;
    Setup setup;
    setup.voxel = suitableVoxel(model_->box());
    setup.marginLow = setup.marginHigh = glm::dvec3(firstMargin);
    setup.stockMaterial = defaultMaterial;
    setup.bodyMaterials.assign(model_->bodies.size(), {});
    apply(setup);
}

void SetupController::exchangeModel(std::shared_ptr<const Model> model) {
    Setup setup = setup_;
    const bool suits = imported_ != nullptr && setup.voxel == suitableVoxel(imported_->box());
    imported_ = std::move(model);
    model_ = nullptr;
    if (suits) setup.voxel = suitableVoxel(imported_->box());
    apply(setup);
}

void SetupController::load(std::shared_ptr<const Model> model, const std::optional<Setup>& setup,
                           const std::vector<Property>& materials) {
    imported_ = std::move(model);
    model_ = nullptr;
    readMaterials(materials);
    if (imported_ && !setup) {
        placeAround(imported_);
        return;
    }
    adopt(setup.value_or(Setup{}));
    emit changed();
}

void SetupController::showUnstored(const Setup& setup) {
    adopt(setup);
    emit changed();
}

void SetupController::edit(const Setup& edited) {
    if (locked_ || embedAlike(edited, setup_)) return;
    const bool leaves = edited.leftBy && edited.form != StockForm::file;
    const Setup setup = leaves ? withoutLeft(edited) : edited;
    const ShapeChange change = changeFrom(setup_, setup);
    desk_.undo.pushForming(new ValueCommand<Setup>(change.title, change.kind, setup_, setup,
                                                   [this](const Setup& value) { apply(value); }));
}

void SetupController::chooseStockMaterial(const std::string& id) {
    if (locked_ || id == setup_.stockMaterial) return;
    Setup setup = setup_;
    setup.stockMaterial = id;
    desk_.undo.pushForming(
        new ValueCommand<Setup>(tr("stock material"), -1, setup_, setup, [this](const Setup& value) { apply(value); }));
}

void SetupController::chooseBodyMaterial(std::size_t body, const std::string& id) {
    if (locked_ || !model_ || body >= model_->bodies.size()) return;
    Setup setup = setup_;
    setup.bodyMaterials.resize(model_->bodies.size());
    if (setup.bodyMaterials[body] == id) return;
    setup.bodyMaterials[body] = id;
    desk_.undo.pushForming(new ValueCommand<Setup>(tr("material of a body"), -1, setup_, setup,
                                                   [this](const Setup& value) { apply(value); }));
}

void SetupController::chooseRole(std::size_t body, BodyRole role) {
    chooseRoles({body}, role);
}

void SetupController::chooseRoles(const std::vector<std::size_t>& bodies, BodyRole role) {
    if (locked_ || !model_) return;
    Setup setup = setup_;
    setup.roles.resize(model_->bodies.size(), BodyRole::part);
    for (const std::size_t body : bodies)
        if (body < setup.roles.size()) setup.roles[body] = role;
    if (sameRoles(setup, setup_)) return;
    const QString title = bodies.size() == 1 ? tr("role of a body") : tr("role of bodies");
    desk_.undo.pushForming(
        new ValueCommand<Setup>(title, -1, setup_, setup, [this](const Setup& value) { apply(value); }));
}

void SetupController::readStock(const std::filesystem::path& file, const std::filesystem::path& table) {
    if (locked_ || !model_ || readingStock()) return;
    StockFileRequest request{file, table, setup_.voxel, {}, {}};
    if (const Property* material = stockMaterial()) request.material = *material;
    desk_.tasks.start(
        TaskKind::stock, tr("Reading the stock from %1").arg(QString::fromStdString(file.filename().string())),
        [request](Progress& progress) { return readStockFile(request, progress); },
        [this, name = QString::fromStdString(file.filename().string())](const Result<StockFile>& stock) {
            if (stock)
                takeStock(*stock, name);
            else if (stock.error().code != ErrorCode::cancelled)
                emit failed(stock.error());
            emit changed();
        });
    emit changed();
}

void SetupController::takeStock(const StockFile& stock, const QString& name) {
    if (locked_ || !model_) return; // a take was recorded or the project closed meanwhile
    if (refusedDuringUndo(desk_, *this, tr("shape of the stock"))) return;
    Setup setup = setup_;
    setup.form = StockForm::file;
    setup.volume = stock.volume;
    setup.leftBy.reset();
    edit(setup);
    if (!stock.unitKnown) emit unitUnknown(name);
}

void SetupController::setRegions(const std::vector<MaterialRegion>& regions) {
    if (locked_ || regions == setup_.regions) return;
    Setup setup = setup_;
    setup.regions = regions;
    desk_.undo.pushForming(
        new ValueCommand<Setup>(tr("layers"), -1, setup_, setup, [this](const Setup& value) { apply(value); }));
}

void SetupController::place(const Placement& by) {
    if (locked_ || !model_ || placing() || isNone(by)) return;
    if (!setup_.leftBy) {
        Setup setup = setup_;
        setup.placement = combined(setup.placement, by);
        setup.zero = moved(setup.zero, by);
        editPlacement(setup);
        return;
    }
    desk_.tasks.start(
        TaskKind::placing, tr("Rotating the stock"),
        [setup = setup_, by](Progress& progress) { return placedFurther(setup, by, progress); },
        [this, by](const Result<Setup>& setup) {
            if (setup && !locked_ && model_ && !refusedDuringUndo(desk_, *this, tr("placement of the part"))) {
                editPlacement(*setup);
                if (!alongAxes(by)) emit stockTurnedAslant(std::sqrt(0.5) * setup->voxel);
            }
            if (!setup && setup.error().code != ErrorCode::cancelled) emit failed(setup.error());
            emit changed();
        });
    emit changed();
}

void SetupController::editPlacement(const Setup& setup) {
    desk_.undo.pushForming(new ValueCommand<Setup>(tr("placement of the part"), -1, setup_, setup,
                                                   [this](const Setup& value) { apply(value); }));
}

void SetupController::examineFace(const glm::dvec3& place, std::function<void(const PartFace&)> then) {
    if (!model_) return;
    desk_.tasks.start(
        TaskKind::face, tr("Examining the face"),
        [part = model_, place](Progress& progress) { return partFaceAt(*part, place, {}, progress); },
        [this, part = model_, then = std::move(then)](const Result<PartFace>& face) {
            if (face && part == model_)
                then(*face);
            else if (!face && face.error().code != ErrorCode::cancelled)
                emit failed(face.error());
        });
}

void SetupController::chooseZero(const ProgramZero& zero) {
    if (!model_ || zero == setup_.zero) return;
    Setup asked = setup_;
    asked.zero = zero;
    if (const Result<Setup> placed = placeZero(*model_, std::move(asked)); !placed) {
        emit changed(); // resets the panel to the value in force
        emit failed(placed.error());
        return;
    }
    desk_.undo.push(new ValueCommand<ProgramZero>(tr("program zero"), -1, setup_.zero, zero,
                                                  [this](const ProgramZero& value) { applyZero(value); }));
}

void SetupController::applyZero(const ProgramZero& zero) {
    Setup setup = setup_;
    setup.zero = zero;
    apply(setup);
}

void SetupController::apply(const Setup& setup) {
    adopt(setup);
    if (!problem_) storeSetup();
    emit changed();
}

void SetupController::adopt(const Setup& setup) {
    if (model_ == nullptr || setup.placement != setup_.placement) model_ = placed(imported_, setup.placement);
    setup_ = setup;
    size_.reset();
    problem_.reset();
    if (!model_) return;
    const Result<Setup> placed = placeStock(*model_, setup);
    if (!placed) {
        problem_ = placed.error();
        return;
    }
    setup_ = *placed;
    const Result<EmbeddingSize> size = embeddingSize(setup_);
    if (size)
        size_ = *size;
    else
        problem_ = size.error();
}

void SetupController::storeSetup() {
    const std::vector<std::string> ids = materialsUsed(setup_);
    std::vector<Property> used;
    for (const Property& material : materials_)
        if (std::ranges::find(ids, material.id) != ids.end()) used.push_back(material);
    store([setup = setup_, used](Project& project) {
        if (Result<void> done = project.setSetup(setup); !done) return done;
        return project.setMaterials(used);
    });
}

} // namespace burin

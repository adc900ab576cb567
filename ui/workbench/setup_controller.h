// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_face.h"
#include "core/job/stock_file.h"
#include "core/setup/setup.h"
#include "core/volume/runs/property_list.h"
#include "ui/workbench/controller.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace burin {

/// Stock, voxels and materials: what embedding will make of the part.
class SetupController final : public Controller {
    Q_OBJECT
public:
    SetupController(const Desk& desk, QObject* parent);

    bool hasPart() const noexcept { return model_ != nullptr; }
    /// In its own frame; null: none yet.
    const std::shared_ptr<const Model>& imported() const noexcept { return imported_; }
    /// As it lies in the setup; null: none yet.
    const std::shared_ptr<const Model>& part() const noexcept { return model_; }
    const Setup& setup() const noexcept { return setup_; } ///< as edited
    const std::optional<EmbeddingSize>& size() const noexcept { return size_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< why it can't be embedded
    bool usable() const noexcept { return hasPart() && !problem_; }
    /// The library's; what the project keeps stands in place of what the library has of that id.
    const std::vector<Property>& materials() const noexcept { return materials_; }
    const Property* stockMaterial() const; ///< nullptr: neither the project nor the library has it
    bool readingStock() const { return desk_.tasks.running(TaskKind::stock); }
    bool locked() const noexcept { return locked_; }
    /// Stock and material stay as they are: there are recordings of them.
    void setLocked(bool locked);

    /// The library of materials changed: the project takes its values, unless it is locked.
    void readLibrary();
    /// A new part in a stock that suits its size.
    void placeAround(std::shared_ptr<const Model> model);
    /// The part is another one of the same bodies.
    void exchangeModel(std::shared_ptr<const Model> model);
    /// What a project holds.
    void load(std::shared_ptr<const Model> model, const std::optional<Setup>& setup,
              const std::vector<Property>& materials);

    // Each an entry of the undo stack; nothing happens while it is locked.
    void edit(const Setup& setup);
    void chooseStockMaterial(const std::string& id);
    void chooseBodyMaterial(std::size_t body, const std::string& id);
    void chooseRole(std::size_t body, BodyRole role);
    /// The stock as a file has it, read in the background (core/job/stock_file.h): a model with the present voxel and
    /// material. @param table of a voxel array
    void readStock(const std::filesystem::path& file, const std::filesystem::path& table);
    void setRegions(const std::vector<MaterialRegion>& regions);
    /// Turns or moves the part from how it lies; a stock that another setup left goes with it, in the background.
    void place(const Placement& by);
    /// Where the programs have their zero; recordings or not.
    void chooseZero(const ProgramZero& zero);
    /// The face of the part at a place, looked at in the background by the import program; `then` gets it unless the
    /// part was exchanged meanwhile. @param place mm, setup frame
    void examineFace(const glm::dvec3& place, std::function<void(const PartFace&)> then);
    bool placing() const { return desk_.tasks.running(TaskKind::placing); }

signals:
    /// A voxel array states no unit of length: mm were taken.
    void unitUnknown(const QString& file);
    /// A stock that another setup left was turned by no quarter turns: its faces may lie beside the true ones.
    /// @param by mm
    void stockTurnedAslant(double by);

private:
    void apply(const Setup& setup);
    void adopt(const Setup& setup);
    void editPlacement(const Setup& setup);
    void applyZero(const ProgramZero& zero);
    void readMaterials(const std::vector<Property>& own);
    void storeSetup();
    void takeStock(const StockFile& stock, const QString& name);

    std::shared_ptr<const Model> imported_, model_; ///< in its own frame, and as it lies in the setup
    std::vector<Property> materials_;
    Setup setup_;
    std::optional<EmbeddingSize> size_;
    std::optional<Error> problem_;
    bool locked_ = false;
};

/// The voxel for a part, mm: of the sizes 1, 2 and 5, the one that gives its longest side about 200 voxels, and the
/// stock around it about 600 at most.
double suitableVoxel(const Box& part);

/// Around a part whose stock nobody has set yet, mm.
inline constexpr double firstMargin = 5.0;

/// Whether the workpiece of one becomes that of the other by other materials alone: nothing has to be embedded anew.
bool shapedAlike(const Setup& one, const Setup& other);
/// Whether two setups embed to the same workpiece.
bool embedAlike(const Setup& one, const Setup& other);

} // namespace burin

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

/// Stock, voxels and materials: the input of embedding the part.
class SetupController final : public Controller {
    Q_OBJECT
public:
    SetupController(const Desk& desk, QObject* parent);

    bool hasPart() const noexcept { return model_ != nullptr; }
    /// In its own frame; null: none yet.
    const std::shared_ptr<const Model>& imported() const noexcept { return imported_; }
    /// As placed in the setup; null: none yet.
    const std::shared_ptr<const Model>& part() const noexcept { return model_; }
    const Setup& setup() const noexcept { return setup_; } ///< as edited
    const std::optional<EmbeddingSize>& size() const noexcept { return size_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< why it can't be embedded
    bool usable() const noexcept { return hasPart() && !problem_; }
    /// Materials of the library; one that the project keeps replaces the library's of the same id.
    const std::vector<Property>& materials() const noexcept { return materials_; }
    const Property* stockMaterial() const; ///< nullptr if neither the project nor the library has it
    bool readingStock() const { return desk_.tasks.running(TaskKind::stock); }
    bool locked() const noexcept { return locked_; }
    /// Locks stock and material because recordings depend on them.
    void setLocked(bool locked);

    /// The library of materials has changed: the project takes its values unless it is locked.
    void readLibrary();
    /// Sets a new part with a stock that suits its size.
    void placeAround(std::shared_ptr<const Model> model);
    /// Replaces the part by another one with the same bodies. Voxels of a size that suits the part still do afterwards.
    void exchangeModel(std::shared_ptr<const Model> model);
    /// Loads the setup of a project.
    void load(std::shared_ptr<const Model> model, const std::optional<Setup>& setup,
              const std::vector<Property>& materials);
    /// Shows a setup that can't be embedded, as it was edited; no entry of the undo stack.
    void showUnstored(const Setup& setup);

    // Each is an entry of the undo stack; they do nothing while it is locked.
    void edit(const Setup& setup);
    void chooseStockMaterial(const std::string& id);
    void chooseBodyMaterial(std::size_t body, const std::string& id);
    void chooseRole(std::size_t body, BodyRole role);
    void chooseRoles(const std::vector<std::size_t>& bodies, BodyRole role);
    /// Reads the stock from a file in the background (core/job/stock_file.h); a model is used with the present voxel
    /// size and material. @param table of a voxel array
    void readStock(const std::filesystem::path& file, const std::filesystem::path& table);
    void setRegions(const std::vector<MaterialRegion>& regions);
    /// Rotates or moves the part from its present placement; a stock left by another setup moves with it, in the
    /// background.
    void place(const Placement& by);
    /// Sets the program zero, with or without recordings.
    void chooseZero(const ProgramZero& zero);
    /// Finds the face of the part at a point in the background, in the import process; `then` is called with it unless
    /// the part was exchanged meanwhile. @param place mm, setup frame
    void examineFace(const glm::dvec3& place, std::function<void(const PartFace&)> then);
    bool placing() const { return desk_.tasks.running(TaskKind::placing); }

signals:
    /// A voxel array states no unit of length; mm were assumed.
    void unitUnknown(const QString& file);
    /// A stock left by another setup was rotated by an angle other than a multiple of 90°: its faces may deviate from
    /// the true ones.
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

    std::shared_ptr<const Model> imported_, model_; ///< in its own frame, and as placed in the setup
    std::vector<Property> materials_;
    Setup setup_;
    std::optional<EmbeddingSize> size_;
    std::optional<Error> problem_;
    bool locked_ = false;
};

/// The voxel size for a part, mm: of the sizes 1, 2 and 5 times a power of ten, the one that gives its longest side
/// about 200 voxels, and the stock around it about 600 at most.
double suitableVoxel(const Box& part);

/// Margin around a part whose stock has not been set yet, mm.
inline constexpr double firstMargin = 5.0;

/// Whether the workpiece of one setup becomes that of the other by changing materials alone, without embedding again.
bool shapedAlike(const Setup& one, const Setup& other);
/// Whether two setups embed to the same workpiece.
bool embedAlike(const Setup& one, const Setup& other);

} // namespace burin

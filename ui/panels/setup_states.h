// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/setup/axis_mode.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"

#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What the panels of what bounds the tool, and what it mills show. Panels own no model: they get one of these and tell
/// by signals what the user wants.
namespace burin {

struct PartState {
    std::shared_ptr<const Model> model; ///< null: none yet
    bool busy = false;
    std::shared_ptr<const ModelPreview> preview{}; ///< of the one that is being read; null: none
    std::vector<BodyRole> roles{};                 ///< of the model's bodies
    bool locked = false;                           ///< there are recordings: roles stay as they are
};

/// A setup of the job, as lists show it.
struct SetupRow {
    SetupId id = firstSetup;
    QString name;  ///< empty: nobody gave it one
    QString title; ///< never empty
};

/// Where a face of the part that the user picks is to look.
enum class FaceAim { none, down, up, alongX, alongY };

struct SetupState {
    std::shared_ptr<const Model> part; ///< as it lies; null: none yet
    std::vector<SetupRow> setups;      ///< one at least
    SetupId used = firstSetup;
    Placement placement;
    bool stockOutOfDate = false; ///< another setup left its stock, and has changed since
    bool embedded = false;       ///< the workpiece is there
    bool locked = false;         ///< there are recordings: the part stays as it lies
    bool busy = false;           ///< a setup is being added, or a stock turned
    FaceAim aim = FaceAim::none; ///< of the face that is being picked
};

struct StockState {
    bool hasPart = false;
    Setup setup;                       ///< as edited; `stock` filled by placeStock
    std::optional<EmbeddingSize> size; ///< voxels and memory that embedding would take
    bool embedded = false;             ///< the workpiece stands as `setup` says
    bool locked = false;               ///< there are recordings: stock and material stay as they are
    bool busy = false;
    QString problem;                        ///< why this stock can't be embedded, a sentence; empty: it can
    std::vector<EmbeddingFinding> findings; ///< of the workpiece that stands
};

/// What becomes of a bound while the tool is in hand.
enum class BoundNews {
    none,  ///< nothing is to be told
    waits, ///< the tool is inside of it: it holds as soon as that is clear
    holds  ///< it holds the tool back
};

struct ObstacleRow {
    std::shared_ptr<const Obstacle> obstacle; ///< never null; whether it is on says `on`
    bool on = true;
    BoundNews news = BoundNews::none;
};

struct SurroundingsState {
    bool hasPart = false;
    std::vector<ObstacleRow> obstacles;
    bool travelOn = true; ///< the machine's travel bounds the tool
    BoundNews travel = BoundNews::none;
    AxisMode axis;
    bool locked = false;  ///< a recording runs: shapes and axis stay
    bool busy = false;    ///< a fixture is being read
    glm::dvec3 zero{0.0}; ///< mm, of the program, in the setup frame
};

struct ZeroState {
    bool hasPart = false;
    ProgramZero zero;
    glm::dvec3 place{0.0}; ///< mm, setup frame: where it is
    bool picking = false;  ///< the user clicks on a place in the view
};

struct MaterialState {
    std::vector<Property> materials; ///< of the library
    std::string stockMaterial;
    std::vector<std::string> bodyNames, bodyMaterials;
    bool locked = false;
};

struct ToolState {
    std::vector<Tool> tools;
    std::string current;
    std::vector<std::string> ofTakes; ///< the tool of each take
    double feed = 0.0, plungeFeed = 0.0,
           spindleSpeed = 0.0;        ///< mm/min, mm/min, 1/min in the stock's material; 0: not known yet
    bool conditionsEstimated = false; ///< the material's figures are estimates
    bool fieldBusy = false;           ///< the boundary for this tool is being computed
    bool locked = false;              ///< a recording runs
};

struct AllowanceState {
    double allowance = 0.0; ///< mm
    double maximum = 5.0;   ///< mm
    bool locked = false;
};

} // namespace burin

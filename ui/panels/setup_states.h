// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/setup/axis_mode.h"
#include "core/setup/fixture_fit.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"

#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// States of the panels for the part, the setup, the stock, the fixtures and limits, and the tool. Panels own no model:
/// they are given one of these states and report the user's requests by signals.
namespace burin {

struct PartState {
    std::shared_ptr<const Model> model; ///< null: no part yet
    bool busy = false;
    std::shared_ptr<const ModelPreview> preview{}; ///< preview of the model that is being read; null: none
    std::vector<BodyRole> roles{};                 ///< of the model's bodies
    bool locked = false;                           ///< whether there are recordings, so that roles can't be changed
    std::vector<BodyColour> colours{};             ///< of the model's bodies
};

/// A setup of the job, as shown in lists.
struct SetupRow {
    SetupId id = firstSetup;
    QString name;  ///< empty: not named by the user
    QString title; ///< never empty
};

/// The direction into which a picked face of the part is to be turned.
enum class FaceAim { none, down, up, alongX, alongY };

struct SetupState {
    std::shared_ptr<const Model> part; ///< as placed in the setup; null: none yet
    std::vector<SetupRow> setups;      ///< at least one
    SetupId used = firstSetup;
    Placement placement;
    bool stockOutOfDate = false; ///< whether the setup that left this stock has changed since
    bool embedded = false;       ///< whether the workpiece exists
    bool locked = false;         ///< whether there are recordings, so that the part can't be moved
    bool busy = false;           ///< whether a setup is being added or a stock is being turned
    FaceAim aim = FaceAim::none; ///< of the face that is being picked
};

struct StockState {
    bool hasPart = false;
    Setup setup;                       ///< as edited; `stock` filled by placeStock
    std::optional<EmbeddingSize> size; ///< number of voxels and memory that embedding would need
    bool embedded = false;             ///< whether the workpiece exists and matches `setup`
    bool locked = false;               ///< whether there are recordings, so that stock and material can't be changed
    bool busy = false;
    QString problem;                        ///< why this stock can't be embedded, as a sentence; empty: it can
    std::vector<EmbeddingFinding> findings; ///< of the existing workpiece
};

/// The state of a fixture or limit while milling.
enum class BoundNews {
    none,  ///< nothing to report
    waits, ///< the tool is inside; the limit takes effect as soon as the tool is clear of it
    holds  ///< it is holding the tool back
};

struct ObstacleRow {
    std::shared_ptr<const Obstacle> obstacle; ///< never null; `on` states whether it is switched on
    bool on = true;
    BoundNews news = BoundNews::none;
    FixtureFit fit{};    ///< the stock may have changed after it was placed
    bool moving = false; ///< whether it is being moved in the view
};

struct SurroundingsState {
    bool hasPart = false;
    std::vector<ObstacleRow> obstacles;
    bool travelOn = true; ///< whether the machine's travel limits the tool
    BoundNews travel = BoundNews::none;
    AxisMode axis;
    bool locked = false;  ///< whether a recording is running, so that shapes and axis can't be changed
    bool busy = false;    ///< whether a fixture is being read
    glm::dvec3 zero{0.0}; ///< program zero, mm, setup frame
};

struct ZeroState {
    bool hasPart = false;
    ProgramZero zero;
    glm::dvec3 place{0.0}; ///< position of program zero, mm, setup frame
    bool picking = false;  ///< whether the user is picking a point in the view
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
    std::string preset;               ///< name of the tool's preset that gives these; empty: the material's values do
    bool plungeByPreset = false;      ///< whether the preset also states the plunge feed
    bool conditionsEstimated = false; ///< whether the material's values are estimates
    bool fieldBusy = false;           ///< whether the boundary for this tool is being computed
    bool locked = false;              ///< whether a recording is running
};

struct AllowanceState {
    double allowance = 0.0; ///< mm
    double maximum = 5.0;   ///< mm
    bool locked = false;
};

} // namespace burin

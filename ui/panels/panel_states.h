// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/haptics/guide.h"
#include "core/haptics/tick_sink.h"
#include "core/nc/lint.h"
#include "core/path/drawn_edit.h"
#include "core/path/evaluate.h"
#include "core/project/project.h"
#include "core/setup/obstacle.h"
#include "core/setup/setup.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"
#include "core/volume/property_list.h"

#include <QString>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>
#include <vector>

/// What each panel shows. Panels own no model: they get one of these and tell by signals what the user wants.
namespace burin {

struct PartState {
    std::shared_ptr<const Model> model;          ///< null: none yet
    std::shared_ptr<const ModelPreview> preview; ///< of the one that is being read; null: none
    bool busy = false;
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

enum class DepthChoice { level, part };
enum class RepeatChoice { lower, left, right };

struct TakeRow {
    TakeInfo info;
    QString tool; ///< its name
    std::size_t strokes = 0;
    bool recording = false; ///< it grows
    bool replaying = false; ///< it is being cut again; its strokes are not counted yet
};

struct MillState {
    bool ready = false;  ///< stock embedded and boundary there
    QString missing;     ///< what is to be done first, a sentence
    bool active = false; ///< mill mode
    bool recording = false;
    double recordedSeconds = 0.0;
    bool cutting = false; ///< a stroke is under way: none is taken back or put back
    bool canUndoStroke = false, canRedoStroke = false;
    std::size_t undoableStrokes = 0; ///< that can be taken back one after the other
    DepthChoice depthRule = DepthChoice::level;
    bool raster = false;                                                ///< a drag spans a rectangle
    double depthOfCut = 1.0, press = 2.0, speed = 60.0, stepOver = 2.0; ///< mm, mm, mm/s, mm
    bool canRepeat = false;                                             ///< there is a stroke to repeat
    QString lock;                                                       ///< what strokes keep to; empty: nothing
    QString alarm; ///< what keeps the tool from cutting; empty: nothing
    QString hint;  ///< what the hand may wonder about; empty: nothing
    std::vector<TakeRow> takes;
    bool showing = false; ///< the virtual operator mills
    QStringList styluses; ///< what can be milled with
    int stylus = 0;       ///< of these
};

struct GuideState {
    std::vector<Guide> guides; ///< the upper one stays where not all can hold
    bool on = true;            ///< as a whole
    bool full = false;         ///< no more can be added
    bool edges = false;        ///< the part has edges to follow
    bool live = false;         ///< mill mode: `news` counts
    std::array<GuideNews, GuideSettings::capacity> news{};
    glm::dvec3 zero{0.0}; ///< mm, of the program, in the setup frame
};

struct HandState {
    bool hasDevice = false; ///< a device is in the hand, not the mouse
    double scale = 1.0;     ///< mm of the tool per mm of the hand
    bool clutched = false;
    bool canRate = false; ///< the device may set the tool's speed instead of its place
    bool rate = false;    ///< and does
    int buttons = 0;      ///< of the device
    int clutchButton = 0, levelButton = 0, forceButton = 0; ///< numbers from 1; 0: none
    bool motors = false;                                    ///< forces can be felt
    bool recording = false;
    std::optional<double> battery, heat; ///< 0 … 1, where the device tells them
    bool charging = false;
};

/// What a drag of a place of the path changes.
enum class DragChoice { level, x, y, z, surface };

struct PathState {
    struct Tool {
        std::string id;
        QString name;
    };
    std::vector<Tool> milled;     ///< the tools that have takes
    Tool tool;                    ///< in force
    bool hasTakes = false;        ///< of the tool in force
    bool someWithoutPath = false; ///< of those that milled
    bool exists = false;
    StoredPath path;
    std::vector<TakeInfo> takes;       ///< all, for their names and times
    glm::dvec3 zero{0.0};              ///< mm, of the program, in the setup frame
    std::vector<EditReport> reports;   ///< of the newest evaluation, one for each enabled edit, in order
    std::optional<double> errorBudget; ///< mm
    std::size_t points = 0;
    double cuttingLength = 0.0;                         ///< mm
    double climbLength = 0.0, conventionalLength = 0.0; ///< mm of it; the rest cuts on both sides, or from above
    std::optional<MillingSide> selectedSide;            ///< of what is chosen; nothing: not the same everywhere
    bool outdated = false;                              ///< takes or edits changed since
    bool busy = false;
    bool waiting = false; ///< for the workpiece; then it is evaluated by itself
    std::optional<TakeStretch> selection;
    DragChoice drag = DragChoice::level;
    bool drawing = false;                   ///< a stroke is being drawn in the selection's stead
    std::optional<DrawnField> drawnField{}; ///< of an edit, that is being drawn
    QString problem;
    QString missingBefore; ///< tools whose paths are milled before and can't be made
};

/// Something that can be chosen by its name.
struct NamedChoice {
    std::string id;
    QString name;
};

/// A path that may belong into a program.
struct ProgramPathState {
    std::int64_t id = 0;
    QString name; ///< its tool's
    bool included = true;
};

struct ProgramState {
    bool hasPath = false;                ///< some path belongs into it
    bool upToDate = false;               ///< that of the tool in force is, or there is none
    std::vector<ProgramPathState> paths; ///< in the order of milling
    QStringList withoutPath;             ///< tools that milled and have no path yet
    NcUnits units = NcUnits::millimetre;
    std::vector<NamedChoice> machines, dialects;
    std::string machine, dialect; ///< ids of those in force
    bool typicalMachine = false;  ///< the one in force is shipped with Burin
    QString missingMachine;       ///< that the project names, and that is not here; empty: it is
    QString text;                 ///< empty: not posted
    bool edited = false;          ///< by hand, after it was posted, and not checked since
    std::size_t blocks = 0;
    std::shared_ptr<const VerifyReport> report; ///< null: not checked; large, so that it is shared
    std::vector<LintMark> lint;                 ///< of the program that the report is about
    bool released = false;                      ///< it passed, or its header says why it is wanted all the same
    double gougeTolerance = 0.02;               ///< mm, for the next check
    double excessTolerance = 0.1;               ///< mm, the same; 0: not judged
    double judgedTolerance = 0.02;              ///< mm, that the report was judged by
    bool outdated = false;
    bool busy = false;
    QString problem;
};

/// What the meters and the status line show.
struct MeterState {
    bool running = false; ///< the haptic loop runs
    double rateHz = 0.0;
    double intervalP999 = 0.0; ///< µs from force to force
    double workP999 = 0.0;     ///< µs of thread CPU time
    std::uint64_t missed = 0;
    std::uint64_t late = 0; ///< ticks whose force was withheld
    SchedulingClass scheduling = SchedulingClass::normal;
    double force = 0.0;       ///< N, unscaled cutting force
    double forceScale = 5.0;  ///< N, full scale so far
    double forceLimit = 0.0;  ///< N that tool and spindle bear; 0: not known
    QString forceLimitOf;     ///< what bears no more
    double removalRate = 0.0; ///< mm³/s
    double removalScale = 100.0;
    glm::dvec3 tip{0.0}; ///< mm, program coordinates
    QString stylus;      ///< "Mouse", "Virtual operator 8 ×"
};

/// The steps of the job, in order.
enum class JobStep { part, stock, material, tool, allowance, mill, path, program };
enum class StepProgress {
    missing, ///< cannot be done yet
    ready,
    current,
    objected, ///< done, but a check objects to it
    done
};
struct JobStepState {
    StepProgress progress = StepProgress::missing;
    QString line; ///< what it holds, or what is missing
};

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/device/stylus_handle.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/servo_loop.h"
#include "core/haptics/operator/virtual_operator.h"
#include "core/haptics/trace/session_trace.h"
#include "core/job/feed_proposal.h"
#include "core/job/milling_context.h"
#include "core/job/tool_bounds.h"
#include "core/passes/milling_plan.h"
#include "core/passes/scripted_intents.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A request for one recording.
struct TakeRequest {
    std::string name;
    double allowance = 0.0; ///< mm of stock that the boundary leaves on the part
    WorkspaceMapping mapping;
    Pace pace = Pace::fast;
    double maximumSeconds = 1e9; ///< of the session, s
    double period = 0.0;         ///< of a tick, s; 0: as in SessionRequest
    bool cutsOnButton = false;   ///< the spindle turns only while the stylus' first button is pressed
    FeltCutting felt;
    StockLayer stock;
    GainLimits gains;
    std::uint32_t forceButtons = 0;                   ///< as in SessionRequest
    std::optional<GuideSettings> guides;              ///< as in SessionRequest
    std::filesystem::path trace, flights;             ///< as in SessionRequest
    std::optional<StagedFile>* traceOutput = nullptr; ///< as in SessionRequest
    bool saves = true;                                ///< saves the project at the end; otherwise the caller does
    const SessionTrace* replayed = nullptr;           ///< as in SessionRequest
    std::function<void(const Error&)> heardFault; ///< on the calling thread: a fault after which the session continues
};

/// The result of a recording, read back from the project.
struct TakeOutcome {
    std::int64_t take = 0;
    std::uint64_t samples = 0;
    LoopStatistics loop;
    double removed = 0.0;                  ///< mm³, sum over the recorded samples
    double drop = 0.0;                     ///< mm³ that the workpiece's machinable runs lost during the take
    std::uint64_t shankTicks = 0;          ///< ticks with a contact of shank or holder
    std::uint64_t obstacleTicks = 0;       ///< ticks with the tool held by fixture, keep-out volume or machine travel
    std::uint64_t stockTicks = 0;          ///< ticks in which shank or holder were kept away from the stock
    std::uint64_t axisHeldTicks = 0;       ///< ticks in which the axis could not follow the hand
    std::vector<std::uint64_t> layerTicks; ///< ticks in which each layer held the tool, by index in ToolBounds::layers
    double largestForce = 0.0;             ///< N, rendered
    double largestTorque = 0.0;            ///< N·mm, rendered
    double largestCuttingForce = 0.0;      ///< N, unscaled
    SmoothedCut heaviestCut;               ///< empty if no cut lasted 0.1 s
    std::optional<FeedProposal> heaviestFeed; ///< for the heaviest cut
};

/// Mills with a stylus and records every tick into the project while milling; saves the project at the end.
/// Errors: those of the stylus, the servo loop, the recorder and Project::save; the file is then unchanged, and what
/// was recorded until then is kept as unsaved work.
Result<TakeOutcome> recordTake(Project& project, MillingContext& milling, const ToolBounds& bounds,
                               const StylusHandle& stylus, const TakeRequest& request, const std::atomic<bool>& stop);

/// A request to the virtual operator.
struct OperatorRequest {
    OperatorIntent intent = OperatorIntent::passes;
    HandImpedance hand = firmHand;  ///< of the hand that holds the stylus
    double allowance = 0.5;         ///< mm, roughing
    double press = 2.0;             ///< mm into the part, finishing
    double levelDepth = 0.0;        ///< mm, between roughing levels; 0: the plan's own rule
    double roughingStepOver = 0.0;  ///< mm; 0: the plan's own rule
    double finishingStepOver = 0.0; ///< mm; 0: the plan's own rule
    double finishingDepth = 0.0;    ///< mm of stock that finishing may remove at once; 0: the distance of the levels
    double timeLimit = 0.0;         ///< s for all takes; 0: none, but 20 s for the intents scribble and hostile
    std::uint64_t seed = 1;         ///< of the hand's tremor
    StockLayer stock;               ///< as in SessionRequest; the plan does not take it into account
    Pace pace = Pace::fast;
    bool saves = true; ///< saves the project after each take; otherwise the caller does
};

struct OperatorOutcome {
    MillingPlan plan;
    std::vector<TakeOutcome> takes; ///< roughing, then finishing; an empty one is left out
};

/// One take of a virtual operator.
struct OperatorStage {
    std::string name;                ///< of the take
    std::vector<IntentPoint> intent; ///< tips, setup frame
    double allowance = 0.0;          ///< mm
};

/// The share of the cutting force that a planned hand feels. Such a hand can't see where it was pushed to, and would
/// leave its plan; at this share the cutting force deflects a firm hand by less than a finishing cut.
inline constexpr FeltCutting feltByPlannedHand{.gain = 0.05};

/// The plan of a virtual operator: a VirtualOperator with a stage's intent, `mapping` and `hand` mills it.
struct OperatorPlan {
    MillingPlan plan;
    WorkspaceMapping mapping;
    OperatorSettings hand;
    FeltCutting felt = feltByPlannedHand;
    std::vector<OperatorStage> stages; ///< in order; empty stages are left out
};

/// Plans along a fixed tool axis. If the axis is free, the operator holds its stylus upright; that requires a clearance
/// field over tips, which is made here. Errors: those of planMilling and clearanceField. Thread-safe; takes seconds.
Result<OperatorPlan> planOperator(const MillingContext& milling, const ToolBounds& bounds,
                                  const OperatorRequest& request);

/// Roughs in levels and finishes in parallel passes with a virtual hand, one take each. With a model without bodies,
/// free-hand grooves are cut instead (paper, figure 13 b). Errors: those of planMilling and recordTake; cancelled.
Result<OperatorOutcome> millWithOperator(Project& project, MillingContext& milling, const ToolBounds& bounds,
                                         const OperatorRequest& request, const std::atomic<bool>& stop);

/// Returns the mapping that fits the reachable region of the tip in a milling context into the workspace of a stylus.
/// It is the same for the same project and tool, so that a trace has the same meaning in every run.
WorkspaceMapping mappingFor(const MillingContext& milling, const StylusDescription& stylus);

} // namespace burin

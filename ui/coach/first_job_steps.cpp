// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/first_job_steps.h"

#include "core/path/edit.h"
#include "ui/panels/texts.h"
#include "ui/workbench/workbench.h"

#include <QCoreApplication>

#include <algorithm>

namespace burin {

namespace {

constexpr double quickVoxel = 1.0;          // mm: embeds the sample part quickly
constexpr double nearlyQuick = 0.95;        // mm: allows for the same value rounded in inches
constexpr const char* goodTool = "ball-10"; // for the sample part

QString voxelToEnter(const Workbench& /*workbench*/, LengthUnit unit) {
    return lengthText(quickVoxel, unit);
}

int rowOfGoodTool(const Workbench& workbench) {
    const std::vector<Tool>& tools = workbench.tool.tools();
    const auto found = std::ranges::find(tools, goodTool, &Tool::id);
    return found == tools.end() ? -1 : static_cast<int>(found - tools.begin());
}

QString nameOfGoodTool(const Workbench& workbench, LengthUnit /*unit*/) {
    const int row = rowOfGoodTool(workbench);
    return toolName(row < 0 ? workbench.tool.current() : workbench.tool.tools()[static_cast<std::size_t>(row)]);
}

/// Whether anything was milled. The workpiece shows this before the list of takes does.
bool milled(Workbench& workbench) {
    return !workbench.mill.takes().empty() || workbench.workpiece.strokes().count() > 0;
}

bool partIsOpen(const FirstJobFacts& facts) {
    return facts.workbench.model.model() != nullptr;
}

bool voxelsAreLarge(const FirstJobFacts& facts) {
    const SetupController& setup = facts.workbench.setup;
    return (setup.hasPart() && setup.setup().voxel >= nearlyQuick) || facts.workbench.workpiece.embedded();
}

bool partIsEmbedded(const FirstJobFacts& facts) {
    return facts.workbench.workpiece.embedded();
}

bool millingBegan(const FirstJobFacts& facts) {
    return facts.workbench.mill.active() || milled(facts.workbench);
}

/// Whoever mills has chosen the tool that is in the spindle.
bool toolIsChosen(const FirstJobFacts& facts) {
    return facts.workbench.tool.current().id != facts.firstTool || millingBegan(facts);
}

bool strokeIsMilled(const FirstJobFacts& facts) {
    return milled(facts.workbench);
}

bool millingEnded(const FirstJobFacts& facts) {
    return !facts.workbench.session.running() && !facts.workbench.mill.takes().empty();
}

bool pathIsMade(const FirstJobFacts& facts) {
    return facts.workbench.path.evaluated() != nullptr;
}

bool editIsAdded(const FirstJobFacts& facts) {
    static const std::size_t usual = standardEdits().size();
    const PathController& path = facts.workbench.path;
    return path.stored() != nullptr && path.stored()->edits.size() > usual && !path.outdated();
}

bool programPassed(const FirstJobFacts& facts) {
    return facts.workbench.program.exportable();
}

bool programIsExported(const FirstJobFacts& facts) {
    return facts.exported;
}

} // namespace

const std::vector<FirstJobStep>& firstJobSteps() {
    static const std::vector<FirstJobStep> steps{
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Open the sample part"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Try the sample part”. It is a computer mouse, 110 mm long. A "
                                               "part of your own does as well."),
         .widget = "samplePartButton",
         .action = "sampleAction",
         .key = ActionId::sampleProject,
         .done = partIsOpen},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Choose the stock"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "The margins state how much stock is around the part. Enter %1 as the "
                                               "voxel size: large voxels are coarse, but quick."),
         .argument = voxelToEnter,
         .place = JobStep::stock,
         .widget = "voxelField",
         .needed = false,
         .done = voxelsAreLarge},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Embed the part"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Embed the part”. Burin puts the part in its stock; this makes "
                                               "the workpiece."),
         .place = JobStep::stock,
         .widget = "embedButton",
         .key = ActionId::embed,
         .done = partIsEmbedded},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Choose a tool"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Click “%1” in the list. Any other tool will do."),
         .argument = nameOfGoodTool,
         .place = JobStep::tool,
         .widget = "toolList",
         .row = rowOfGoodTool,
         .needed = false,
         .done = toolIsChosen},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Start milling"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Mill”. From then on the left mouse button cuts in the view, and "
                                               "everything that is cut is recorded."),
         .place = JobStep::mill,
         .widget = "millButton",
         .key = ActionId::millMode,
         .done = millingBegan},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Mill a stroke"),
         .text =
             QT_TRANSLATE_NOOP("FirstJob", "Hold the left mouse button and drag over the stock. The tool cuts where "
                                           "you drag, and stops at the part."),
         .place = JobStep::mill,
         .widget = "viewport",
         .done = strokeIsMilled},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Stop milling"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press the button again. What you milled is listed as a take."),
         .place = JobStep::mill,
         .widget = "millButton",
         .key = ActionId::millMode,
         .done = millingEnded},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Make a path"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “New path from the takes”. The take becomes a tool path with the "
                                               "standard edits."),
         .place = JobStep::path,
         .widget = "newPathButton",
         .key = ActionId::newPath,
         .done = pathIsMade},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Add an edit"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Add an edit” and choose “Smooth” under “Smoother, fewer moves”. "
                                               "Any other edit does as well."),
         .place = JobStep::path,
         .action = "add-smooth-shape",
         .needed = false,
         .done = editIsAdded},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Post and check"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Post and check”. Burin makes the NC program, reads it back and "
                                               "mills it again on the stock."),
         .place = JobStep::program,
         .widget = "postButton",
         .key = ActionId::post,
         .done = programPassed},
        {.title = QT_TRANSLATE_NOOP("FirstJob", "Export the program (optional)"),
         .text = QT_TRANSLATE_NOOP("FirstJob", "Press “Export…” and choose a file, or skip this step."),
         .place = JobStep::program,
         .widget = "exportButton",
         .key = ActionId::exportProgram,
         .needed = false,
         .done = programIsExported},
    };
    return steps;
}

QString titleOf(const FirstJobStep& step) {
    return QCoreApplication::translate("FirstJob", step.title);
}

QString textOf(const FirstJobStep& step, const Workbench& workbench, LengthUnit unit) {
    const QString text = QCoreApplication::translate("FirstJob", step.text);
    return step.argument != nullptr ? text.arg(step.argument(workbench, unit)) : text;
}

} // namespace burin

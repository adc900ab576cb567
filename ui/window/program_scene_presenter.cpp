// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/program_scene_presenter.h"

#include "core/base/checksum.h"
#include "core/base/units.h"
#include "core/nc/program_lines.h"
#include "core/path/hand_interval.h"
#include "ui/panels/hand_times.h"
#include "ui/panels/texts.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr double drawnChord = 0.02; // mm, chord error of the picture of an arc

} // namespace

ProgramScenePresenter::ProgramScenePresenter(Workbench& workbench, Viewport& viewport, ProgramPanel& panel,
                                             ScenePresenter& scene, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.mill, &workbench.workpiece}, parent)
    , viewport_(viewport)
    , panel_(panel)
    , scene_(scene)
    , picker_([&viewport](const glm::dvec3& place) { return viewport.project(place); }) {
    connect(&panel, &ProgramPanel::lineChosen, this, &ProgramScenePresenter::choose);
    connect(&picker_, &PathPicker::chosen, this, &ProgramScenePresenter::pick);
    connect(&picker_, &PathPicker::hovered, this, &ProgramScenePresenter::hovered);
}

void ProgramScenePresenter::setShown(JobStep step) {
    const bool shown = step == JobStep::program, comes = shown && !shown_;
    shown_ = shown;
    present();
    if (comes) chooseSelection();
}

/// Selects the line that mills the selection of the path.
void ProgramScenePresenter::chooseSelection() {
    const auto& selection = workbench_.path.selection();
    if (!program_ || !selection) return;
    const std::vector<Moment>& moments = program_->moments;
    Moment before;
    const auto found = std::ranges::find_if(
        moments, [&](const Moment& moment) { return leadsThrough(std::exchange(before, moment), moment, *selection); });
    if (found == moments.end()) return;
    line_ = static_cast<int>(program_->parsed.motions[static_cast<std::size_t>(found - moments.begin())].line);
    panel_.showLine(line_);
    showLine();
}

void ProgramScenePresenter::present() {
    const auto& milling = workbench_.workpiece.milling();
    const bool active =
        shown_ && milling && workbench_.program.program() && !workbench_.program.edited() && !workbench_.mill.active();
    if (active) kinematics_ = kinematicsOf(milling->machine, milling->setup.workOffset);
    take(active ? workbench_.program.program() : nullptr);
    if (active != active_) {
        active_ = active;
        // In mill mode the pointer belongs to milling.
        if (active || !workbench_.mill.active()) viewport_.setInteractiveTool(active ? &picker_ : nullptr);
        if (!active) showLine();
    }
    if (active) showLine();
}

void ProgramScenePresenter::take(std::shared_ptr<const CheckedProgram> program) {
    if (program == program_) return;
    if (program && checksum(program->text) != lineOf_) {
        lineOf_ = checksum(program->text);
        // Queued: the panel may receive the text a moment later, and then goes to its start.
        QMetaObject::invokeMethod(this, &ProgramScenePresenter::followText, Qt::QueuedConnection);
    }
    program_ = std::move(program);
    moves_ = program_ ? straightMoves(program_->parsed, drawnChord) : std::vector<NcMotion>();
    std::vector<PathPicker::Move> moves;
    moves.reserve(moves_.size());
    for (const NcMotion& move : moves_) // the start of the first moves is unknown
        moves.emplace_back(tipAt(move.startKnown() ? move.from : move.to), tipAt(move.to));
    picker_.setMoves(std::move(moves));
}

/// Synchronises text, tool and values with the line after the text has changed.
void ProgramScenePresenter::followText() {
    line_ = panel_.line();
    if (active_) showLine();
}

void ProgramScenePresenter::choose(int line) {
    line_ = line;
    showLine();
}

void ProgramScenePresenter::followLine(int line) {
    line_ = line;
    panel_.showLine(line);
    showLine();
}

void ProgramScenePresenter::pick(std::size_t move) {
    if (move >= moves_.size()) return;
    followLine(static_cast<int>(moves_[move].line));
}

/// Shows what shank and holder touch on the selected line, or in the whole program if nothing is touched on that line.
void ProgramScenePresenter::showTouched() {
    std::vector<TouchedVoxels> areas;
    if (program_) areas = program_->report.touched;
    const auto onLine = [this](const TouchedVoxels& area) { return static_cast<int>(area.line) == line_; };
    if (std::ranges::any_of(areas, onLine)) std::erase_if(areas, [&](const auto& area) { return !onLine(area); });
    viewport_.setTouchedVoxels(areas);
}

void ProgramScenePresenter::showLine() {
    const auto line = static_cast<std::uint32_t>(line_);
    const NcMotion* motion = program_ && line_ > 0 ? lastMotion(program_->parsed.motions, line) : nullptr;
    std::vector<glm::dvec3> places;
    if (motion != nullptr)
        for (const NcMotion& move : motionsOf(moves_, line)) {
            if (places.empty() && move.startKnown()) places.push_back(tipAt(move.from));
            places.push_back(tipAt(move.to));
        }
    viewport_.setMoveMark({places});
    showTouched();
    if (motion != nullptr)
        scene_.showToolAt(tipAt(motion->to), program_->toolNumbered(motion->tool));
    else
        scene_.parkTool();
    panel_.showMachineState(motion != nullptr ? stateText(*motion) : QString(),
                            motion != nullptr ? endOf(*motion) : std::nullopt);
}

QString ProgramScenePresenter::stateText(const NcMotion& motion) const {
    const bool inches = unit() == LengthUnit::inch;
    QString text = QStringLiteral("X %1  Y %2  Z %3 ")
                       .arg(lengthNumber(motion.to[Axis::x], unit()), lengthNumber(motion.to[Axis::y], unit()),
                            lengthNumber(motion.to[Axis::z], unit())) +
                   unitText(unit());
    const QString separator = QStringLiteral(" · ");
    if (motion.rapid())
        text += separator + tr("rapid");
    else if (motion.kind == NcMotionKind::dwell)
        text += separator + tr("waits %1 s").arg(QLocale().toString(motion.seconds, 'f', 1));
    else
        text += separator + tr("feed %1 %2/min")
                                .arg(QLocale().toString(inches ? motion.feed / millimetresPerInch : motion.feed, 'f',
                                                        inches ? 1 : 0),
                                     unitText(unit()));
    text += separator + (motion.spindleOn() ? tr("spindle %1/min").arg(QLocale().toString(motion.spindleSpeed, 'f', 0))
                                            : tr("spindle off"));
    text += separator + QLatin1Char('T') + QString::number(motion.tool);
    const auto place = static_cast<std::size_t>(&motion - program_->parsed.motions.data());
    if (const auto seconds = endOf(motion)) text += QLatin1Char('\n') + tr("at %1").arg(durationText(*seconds));
    return text + loadText(place) + handText(place);
}

std::optional<double> ProgramScenePresenter::endOf(const NcMotion& motion) const {
    const auto place = static_cast<std::size_t>(&motion - program_->parsed.motions.data());
    const std::vector<MotionTime>& times = program_->report.times;
    if (place >= times.size()) return std::nullopt;
    return times[place].start + times[place].duration;
}

QString ProgramScenePresenter::loadText(std::size_t motion) const {
    const std::vector<MotionLoad>& loads = program_->report.loads;
    const auto load = std::ranges::lower_bound(loads, motion, {}, &MotionLoad::motion);
    if (load == loads.end() || load->motion != motion) return {};
    const QString separator = QStringLiteral(" · ");
    return separator + rateText(load->removalRate, unit()) + separator +
           tr("%1 N, peak %2 N")
               .arg(QLocale().toString(load->force, 'f', 1), QLocale().toString(load->peak.force, 'f', 1)) +
           separator + tr("peak %1 W").arg(QLocale().toString(load->peak.power, 'f', 0));
}

QString ProgramScenePresenter::handText(std::size_t motion) const {
    if (motion >= program_->moments.size() || program_->moments[motion].source == 0) return {};
    const Moment& moment = program_->moments[motion];
    return QLatin1Char('\n') + tr("the hand: %1").arg(momentText(workbench_.mill.takes(), moment));
}

} // namespace burin

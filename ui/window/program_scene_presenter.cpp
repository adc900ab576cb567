// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/program_scene_presenter.h"

#include "core/base/units.h"
#include "core/nc/program_lines.h"

namespace burin {

ProgramScenePresenter::ProgramScenePresenter(Workbench& workbench, Viewport& viewport, ProgramPanel& panel,
                                             ScenePresenter& scene, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.mill, &workbench.bench}, parent)
    , viewport_(viewport)
    , panel_(panel)
    , scene_(scene)
    , picker_([&viewport](const glm::dvec3& place) { return viewport.project(place); }) {
    connect(&panel, &ProgramPanel::lineChosen, this, &ProgramScenePresenter::choose);
    connect(&picker_, &PathPicker::chosen, this, &ProgramScenePresenter::pick);
}

void ProgramScenePresenter::setShown(JobStep step) {
    shown_ = step == JobStep::program;
    present();
}

void ProgramScenePresenter::present() {
    const auto& bench = workbench_.bench.bench();
    const bool active = shown_ && bench && workbench_.program.program() && !workbench_.mill.active();
    if (active) zero_ = bench->setup.workOffset;
    take(active ? workbench_.program.program() : nullptr);
    if (active != active_) {
        active_ = active;
        // In mill mode the pointer is the mill's own.
        if (active || !workbench_.mill.active()) viewport_.setInteractiveTool(active ? &picker_ : nullptr);
    }
    showLine();
}

void ProgramScenePresenter::take(std::shared_ptr<const CheckedProgram> program) {
    if (program == program_) return;
    if (program && program_ && program->text != program_->text) line_ = 0;
    program_ = std::move(program);
    std::vector<PathPicker::Move> moves;
    if (program_) {
        moves.reserve(program_->parsed.motions.size());
        for (const NcMotion& motion : program_->parsed.motions)
            moves.emplace_back(motion.from + zero_, motion.to + zero_);
        if (!moves.empty()) moves.front().first = moves.front().second; // where it comes from is not known
    }
    picker_.setMoves(std::move(moves));
}

void ProgramScenePresenter::choose(int line) {
    line_ = line;
    showLine();
}

void ProgramScenePresenter::pick(std::size_t move) {
    if (!program_ || move >= program_->parsed.motions.size()) return;
    line_ = static_cast<int>(program_->parsed.motions[move].line);
    panel_.showLine(line_);
    showLine();
}

void ProgramScenePresenter::showLine() {
    const auto line = static_cast<std::uint32_t>(line_);
    const NcMotion* motion = program_ && line_ > 0 ? lastMotion(program_->parsed, line) : nullptr;
    std::vector<glm::dvec3> places;
    if (motion != nullptr)
        for (const NcMotion& part : motionsOf(program_->parsed, line)) {
            const bool known = part.fromKnown[0] && part.fromKnown[1] && part.fromKnown[2];
            if (places.empty() && known) places.push_back(part.from + zero_);
            places.push_back(part.to + zero_);
        }
    viewport_.setMoveMark(places);
    scene_.showToolAt(motion != nullptr ? std::optional(motion->to + zero_) : std::nullopt);
    panel_.showMachineState(motion != nullptr ? stateText(*motion) : QString());
}

QString ProgramScenePresenter::stateText(const NcMotion& motion) const {
    const bool inches = unit() == LengthUnit::inch;
    QString text = QStringLiteral("X %1  Y %2  Z %3 ")
                       .arg(lengthNumber(motion.to.x, unit()), lengthNumber(motion.to.y, unit()),
                            lengthNumber(motion.to.z, unit())) +
                   unitText(unit());
    const QString separator = QStringLiteral(" · ");
    if (motion.rapid)
        text += separator + tr("rapid");
    else
        text += separator + tr("feed %1 %2/min")
                                .arg(QLocale().toString(inches ? motion.feed / millimetresPerInch : motion.feed, 'f',
                                                        inches ? 1 : 0),
                                     unitText(unit()));
    text += separator + (motion.spindleOn ? tr("spindle on") : tr("spindle off"));
    return text + separator + QLatin1Char('T') + QString::number(motion.tool);
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/job_presenter.h"

#include "core/base/units.h"
#include "ui/panels/texts.h"

#include <QFileInfo>

#include <algorithm>

namespace burin {

JobPresenter::JobPresenter(Workbench& workbench, StepBar& line, QObject* parent)
    : Presenter(workbench, workbench.controllers(), parent), line_(line) {}

void JobPresenter::setShown(JobStep step) {
    shown_ = step;
    presentSoon();
}

void JobPresenter::present() {
    line_.setState({part(), stock(), material(), tool(), allowance(), mill(), path(), program()}, shown_);
}

JobStepState JobPresenter::part() const {
    const auto& model = workbench_.model.model();
    if (workbench_.model.preview()) return {StepProgress::current, tr("preview")};
    if (workbench_.model.importing()) return {StepProgress::current, tr("importing")};
    if (!model) return {StepProgress::ready, tr("import one")};
    const SetupsController& setups = workbench_.setups;
    const QString file = QFileInfo(QString::fromStdString(model->sourceFile)).fileName();
    return {StepProgress::done,
            setups.setups().size() < 2 ? file : tr("%1, %2").arg(setups.title(setups.used()), file)};
}

JobStepState JobPresenter::stock() const {
    const SetupController& setup = workbench_.setup;
    if (!setup.hasPart()) return {StepProgress::missing, tr("no part yet")};
    if (setup.problem()) return {StepProgress::ready, tr("can't be embedded")};
    const glm::dvec3 size = setup.setup().stock.size();
    const auto side = [&](double length) {
        return unit() == LengthUnit::inch ? QLocale().toString(length / millimetresPerInch, 'f', 2)
                                          : QLocale().toString(length, 'f', 0);
    };
    const QString text = side(size.x) + QStringLiteral(" × ") + side(size.y) + QStringLiteral(" × ") + side(size.z) +
                         QLatin1Char(' ') + unitText(unit());
    if (workbench_.workpiece.embedding()) return {StepProgress::current, tr("embedding")};
    if (!workbench_.workpiece.embedded()) return {StepProgress::ready, text};
    if (!std::ranges::all_of(workbench_.workpiece.milling()->embedded.findings, &EmbeddingFinding::harmless))
        return {StepProgress::objected, tr("part doubtful")};
    return {StepProgress::done, text};
}

JobStepState JobPresenter::material() const {
    const SetupController& setup = workbench_.setup;
    if (!setup.hasPart()) return {StepProgress::missing, tr("no part yet")};
    const Property* material = setup.stockMaterial();
    return {StepProgress::done, material ? materialName(*material) : tr("unknown")};
}

JobStepState JobPresenter::tool() const {
    if (!workbench_.setup.hasPart()) return {StepProgress::missing, tr("no part yet")};
    const Tool& tool = workbench_.tool.current();
    return {workbench_.workpiece.fieldBusy() ? StepProgress::current : StepProgress::done, toolName(tool)};
}

JobStepState JobPresenter::allowance() const {
    if (!workbench_.setup.hasPart()) return {StepProgress::missing, tr("no part yet")};
    return {StepProgress::done, lengthText(workbench_.mill.allowance(), unit())};
}

JobStepState JobPresenter::mill() const {
    const MillController& mill = workbench_.mill;
    if (workbench_.showMe.showing()) return {StepProgress::current, tr("virtual operator")};
    if (mill.recording()) return {StepProgress::current, tr("recording")};
    if (const int count = static_cast<int>(mill.takes().size()); count > 0)
        return {StepProgress::done, count == 1 ? tr("1 take") : tr("%n takes", nullptr, count)};
    if (workbench_.workpiece.ready()) return {StepProgress::ready, tr("no take yet")};
    if (workbench_.workpiece.lacksBounds()) return {StepProgress::missing, tr("no boundary")};
    return {StepProgress::missing, workbench_.workpiece.embedded() ? tr("wait for the boundary") : tr("embed first")};
}

JobStepState JobPresenter::path() const {
    const PathController& path = workbench_.path;
    if (workbench_.mill.takes().empty() && !path.hasPasses()) return {StepProgress::missing, tr("no path yet")};
    if (path.busy()) return {StepProgress::current, tr("being made")};
    if (path.waiting()) return {StepProgress::current, tr("waits for the workpiece")};
    if (path.problem()) return {StepProgress::ready, tr("not possible")};
    if (!path.hasTakes() && path.toolsWithoutPath().empty()) { // the tool is loaded, but has not milled
        const int count = static_cast<int>(path.jobPaths().size());
        return {StepProgress::done, count == 1 ? tr("1 path") : tr("%n paths", nullptr, count)};
    }
    if (!path.evaluated()) return {StepProgress::ready, tr("not yet")};
    if (path.outdated()) return {StepProgress::ready, tr("out of date")};
    return {StepProgress::done, tr("error %1").arg(lengthText(path.evaluated()->errorBudget, unit()))};
}

JobStepState JobPresenter::program() const {
    const ProgramController& program = workbench_.program;
    if (program.busy()) return {StepProgress::current, tr("checking")};
    const bool foreign = !program.storedText().isEmpty();
    if (workbench_.path.jobPaths().empty() && !foreign) return {StepProgress::missing, tr("no path yet")};
    if (program.problem()) return {StepProgress::ready, tr("not possible")};
    if (!program.program())
        return {StepProgress::ready, program.storedText().isEmpty() ? tr("not yet") : tr("not checked")};
    if (program.outdated()) return {StepProgress::ready, tr("out of date")};
    if (program.edited()) return {StepProgress::ready, tr("edited")};
    if (!program.exportable()) return {StepProgress::objected, tr("refused")};
    if (program.program()->overridden) return {StepProgress::objected, tr("overridden")};
    return {StepProgress::done, tr("passed")};
}

} // namespace burin

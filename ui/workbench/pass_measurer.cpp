// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_measurer.h"

#include <utility>

namespace burin {

PassMeasurer::PassMeasurer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                           QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path) {
    connect(&path_, &PathController::changed, this, &PassMeasurer::changed);
}

bool PassMeasurer::possible() const {
    return !busy_ && !path_.passes().empty() && path_.stored() != nullptr && path_.evaluated() && !path_.outdated() &&
           !path_.busy() && workpiece_.milling() && !workpiece_.changing();
}

std::vector<PassFigures> PassMeasurer::figures() const {
    return measured_ && measured_ == path_.evaluated() ? figures_ : std::vector<PassFigures>{};
}

void PassMeasurer::measure() {
    if (!possible()) return;
    busy_ = true;
    emit changed();
    desk_.project.ask([path = path_.evaluated()](const Project& project) { return figureMatter(project, *path); },
                      [this, path = path_.evaluated(), question = questions_](Result<FigureMatter> matter) {
                          if (question != questions_) return;
                          if (matter && path == path_.evaluated()) return run(std::move(*matter));
                          if (!matter) emit failed(matter.error());
                          end();
                      });
}

void PassMeasurer::run(FigureMatter matter) {
    desk_.tasks.start(
        TaskKind::measuring, tr("Measuring the passes"),
        [milling = workpiece_.milling(), matter = std::move(matter), stored = *path_.stored(),
         evaluated = path_.evaluated()](Progress& progress) {
            return passFigures(matter, *milling, stored, *evaluated, progress);
        },
        [this, evaluated = path_.evaluated(), question = questions_](Result<std::vector<PassFigures>> figures) {
            if (question != questions_) return;
            if (figures) {
                measured_ = evaluated;
                figures_ = std::move(*figures);
            } else if (figures.error().code != ErrorCode::cancelled) {
                emit failed(figures.error());
            }
            end();
        });
}

void PassMeasurer::end() {
    busy_ = false;
    emit changed();
}

void PassMeasurer::forget() {
    ++questions_;
    measured_.reset();
    figures_.clear();
    desk_.tasks.abandon(TaskKind::measuring);
    end();
}

} // namespace burin

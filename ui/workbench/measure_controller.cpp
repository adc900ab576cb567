// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/measure_controller.h"

namespace burin {

MeasureController::MeasureController(const Desk& desk, const SetupController& setup, QObject* parent)
    : Controller(desk, parent), setup_(setup) {
    // The part may have moved or been replaced.
    connect(&setup_, &SetupController::changed, this, [this] {
        if (!places_.empty() && setup_.part() != part_) clear();
    });
}

void MeasureController::pick(const glm::dvec3& place) {
    if (!setup_.hasPart()) return;
    if (places_.size() == 2) places_.clear();
    part_ = setup_.part();
    places_.push_back(place);
    measure_.reset();
    desk_.tasks.start(
        TaskKind::measure, tr("Measuring"),
        [part = setup_.part(), places = places_](Progress& progress) {
            return measurePart(*part, places.front(), places.size() > 1 ? std::optional(places[1]) : std::nullopt, {},
                               progress);
        },
        [this](const Result<PartMeasure>& measured) {
            if (measured) {
                measure_ = std::make_shared<const PartMeasure>(*measured);
            } else {
                places_.clear();
                if (measured.error().code != ErrorCode::cancelled) emit failed(measured.error());
            }
            emit changed();
        });
    emit changed();
}

void MeasureController::clear() {
    desk_.tasks.abandon(TaskKind::measure);
    places_.clear();
    measure_.reset();
    emit changed();
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_parameters.h"
#include "ui/messages/messages.h"

#include "core/path/drawn_edit.h"
#include "ui/panels/hand_times.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

class EditParameterLabels {
    Q_DECLARE_TR_FUNCTIONS(EditParameterLabels)
};

/// The unit suffix of a key: "tolerance_mm" is a length.
struct KeyUnit {
    std::string_view ending;
    Quantity quantity;
};
constexpr std::array units{KeyUnit{"_mm3_s", Quantity::removalRate}, KeyUnit{"_n", Quantity::force},
                           KeyUnit{"_mm_s", Quantity::speed},        KeyUnit{"_mm", Quantity::length},
                           KeyUnit{"_hz", Quantity::frequency},      KeyUnit{"_rad", Quantity::angle},
                           KeyUnit{"_rpm", Quantity::rotation},      KeyUnit{"_s", Quantity::time}};

const KeyUnit* unitOf(std::string_view key) {
    const auto found = std::ranges::find_if(units, [&](const KeyUnit& unit) { return key.ends_with(unit.ending); });
    return found == units.end() ? nullptr : &*found;
}

Quantity quantityOf(std::string_view key) {
    const KeyUnit* unit = unitOf(key);
    return unit != nullptr ? unit->quantity : Quantity::ratio;
}

/// The origin for displaying a field, if it is a point or one coordinate of a point.
glm::dvec3 zeroOf(const EditParameters& edit, std::string_view key, const glm::dvec3& zero) {
    if (key == "low_mm" || key == "high_mm") return {zero.z, 0.0, 0.0};
    if (key == "centre_mm") return zero;
    if (const auto* mirror = std::get_if<Mirror>(&edit); mirror != nullptr && key == "at_mm")
        return {mirror->across == Mirror::Across::x ? zero.x : zero.y, 0.0, 0.0};
    return glm::dvec3(0.0);
}

/// The text of a value that is shown and can't be typed.
struct ValueLabels {
    const std::vector<TakeInfo>& takes;

    QString operator()(const Moment& moment) const { return momentText(takes, moment); }
    QString operator()(const SourceInterval& interval) const { return intervalText(takes, interval); }
    QString operator()(const std::vector<glm::dvec3>& places) const {
        return EditParameterLabels::tr("%n points", nullptr, static_cast<int>(places.size()));
    }
    QString operator()(const auto&) const { return {}; }
};

EditParameter parameterOf(const EditParameters& edit, const EditField& field, const glm::dvec3& zero,
                          const std::vector<TakeInfo>& takes) {
    return {field,
            Messages::text(field.words.label),
            Messages::text(field.words.toolTip),
            quantityOf(field.key),
            isDrawn(edit, field.key),
            zeroOf(edit, field.key, zero),
            std::visit(ValueLabels{takes}, field.value)};
}

} // namespace

std::vector<EditParameter> parametersOf(const EditParameters& edit, const glm::dvec3& zero,
                                        const std::vector<TakeInfo>& takes) {
    std::vector<EditParameter> parameters;
    for (const EditField& field : fieldsOf(edit)) parameters.push_back(parameterOf(edit, field, zero, takes));
    return parameters;
}

} // namespace burin

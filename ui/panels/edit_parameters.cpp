// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_parameters.h"

#include "core/path/drawn_edit.h"
#include "ui/panels/edit_words.h"
#include "ui/panels/hand_times.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

class EditParameterTexts {
    Q_DECLARE_TR_FUNCTIONS(EditParameterTexts)
};

/// The unit at the end of a key: "tolerance_mm" measures a length.
struct KeyUnit {
    std::string_view ending;
    Quantity quantity;
};
constexpr std::array units{KeyUnit{"_mm_s", Quantity::speed}, KeyUnit{"_mm", Quantity::length},
                           KeyUnit{"_hz", Quantity::frequency}, KeyUnit{"_rad", Quantity::angle},
                           KeyUnit{"_s", Quantity::time}};

const KeyUnit* unitOf(std::string_view key) {
    const auto found = std::ranges::find_if(units, [&](const KeyUnit& unit) { return key.ends_with(unit.ending); });
    return found == units.end() ? nullptr : &*found;
}

/// "largest_sweep_rad" as a label: "Largest sweep".
QString labelOf(std::string_view key) {
    if (const KeyUnit* unit = unitOf(key)) key.remove_suffix(unit->ending.size());
    QString label = QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
    label.replace(QLatin1Char('_'), QLatin1Char(' '));
    label[0] = label[0].toUpper();
    return label;
}

/// Of a number. What a level of engagement measures, its goal says.
Quantity quantityOf(const EditParameters& edit, std::string_view key) {
    if (const auto* level = std::get_if<LevelFeed>(&edit); level != nullptr && key == "target")
        return level->goal == LevelFeed::Goal::removal ? Quantity::removalRate : Quantity::force;
    const KeyUnit* unit = unitOf(key);
    return unit != nullptr ? unit->quantity : Quantity::ratio;
}

/// What a field is shown from, if it is a place or one of its coordinates.
glm::dvec3 zeroOf(const EditParameters& edit, std::string_view key, const glm::dvec3& zero) {
    if (key == "low_mm" || key == "high_mm") return {zero.z, 0.0, 0.0};
    if (key == "centre_mm") return zero;
    if (const auto* mirror = std::get_if<Mirror>(&edit); mirror != nullptr && key == "at_mm")
        return {mirror->across == Mirror::Across::x ? zero.x : zero.y, 0.0, 0.0};
    return glm::dvec3(0.0);
}

/// What a value that is told and not typed says.
struct ValueTexts {
    const std::vector<TakeInfo>& takes;

    QString operator()(const Moment& moment) const { return momentText(takes, moment); }
    QString operator()(const TakeStretch& stretch) const { return stretchText(takes, stretch); }
    QString operator()(const std::vector<glm::dvec3>& places) const {
        return EditParameterTexts::tr("%n points", nullptr, static_cast<int>(places.size()));
    }
    QString operator()(const auto&) const { return {}; }
};

EditParameter parameterOf(const EditParameters& edit, const EditField& field, const glm::dvec3& zero,
                          const std::vector<TakeInfo>& takes) {
    const EditWords* known = editWordsOf(idOf(edit), field.key);
    return {field,
            known != nullptr ? EditParameterTexts::tr(known->label) : labelOf(field.key),
            known != nullptr ? EditParameterTexts::tr(known->toolTip) : QString(),
            quantityOf(edit, field.key),
            isDrawn(edit, field.key),
            zeroOf(edit, field.key, zero),
            std::visit(ValueTexts{takes}, field.value)};
}

} // namespace

std::vector<EditParameter> parametersOf(const EditParameters& edit, const glm::dvec3& zero,
                                        const std::vector<TakeInfo>& takes) {
    std::vector<EditParameter> parameters;
    for (const EditField& field : fieldsOf(edit)) parameters.push_back(parameterOf(edit, field, zero, takes));
    return parameters;
}

QString choiceText(std::string_view choice) {
    if (const char* known = editChoiceWords(choice)) return EditParameterTexts::tr(known);
    QString text = QString::fromLatin1(choice.data(), static_cast<qsizetype>(choice.size()));
    text.replace(QLatin1Char('-'), QLatin1Char(' '));
    return text;
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_parameters.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {

namespace {

class EditParameterTexts {
    Q_DECLARE_TR_FUNCTIONS(EditParameterTexts)
};

/// What a panel says of one parameter of a kind of edit; what it may be, core knows.
struct ParameterWords {
    std::string_view edit; ///< empty: of every kind that has no words of its own for it
    std::string_view key;
    const char* label;
    const char* toolTip;
};

constexpr std::array words{
    ParameterWords{"drop-air-cuts", "shortest_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Shortest"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter stretch through air stays")},
    ParameterWords{"drop-dwells", "speed_mm_s", QT_TRANSLATE_NOOP("EditParameterTexts", "Slower than"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "A tip slower than this dwells")},
    ParameterWords{"drop-dwells", "time_s", QT_TRANSLATE_NOOP("EditParameterTexts", "Longer than"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter rest stays")},
    ParameterWords{"smooth", "cut_off_hz", QT_TRANSLATE_NOOP("EditParameterTexts", "Cut-off"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "What trembles faster than this is smoothed away")},
    ParameterWords{"smooth", "tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No farther from what the hand did than this")},
    ParameterWords{"hold-out", "clearance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Kept from the part beyond the allowance")},
    ParameterWords{"hold-out", "sampling_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Sampling"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How densely the path is held against the part")},
    ParameterWords{"simplify", "tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No point that is left out lies farther off than this")},
    ParameterWords{"fit-arcs", "tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No arc leaves the path farther than this")},
    ParameterWords{"fit-arcs", "largest_sweep_rad", QT_TRANSLATE_NOOP("EditParameterTexts", "Largest sweep"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "An arc that turns by more becomes several")},
    ParameterWords{"fit-arcs", "smallest_radius_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Smallest radius"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Tighter turns stay straight moves")},
    ParameterWords{"fit-arcs", "largest_radius_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Largest radius"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Flatter turns stay straight moves")},
    ParameterWords{
        "fit-arcs", "radius_mismatch_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Radius mismatch"),
        QT_TRANSLATE_NOOP("EditParameterTexts", "How far the radii at both ends may differ once figures are rounded")},
    ParameterWords{"link", "clearance_above_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance above"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far above the stock's top rapid moves run")},
    ParameterWords{"link", "approach_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Approach"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far above what is left the plunge begins")}};

constexpr std::array choiceWords{std::pair{std::string_view("x"), "X"}, std::pair{std::string_view("y"), "Y"},
                                 std::pair{std::string_view("z"), "Z"}};

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

const ParameterWords* wordsOf(std::string_view edit, std::string_view key) {
    for (const std::string_view kind : {edit, std::string_view()}) {
        const auto found =
            std::ranges::find_if(words, [&](const ParameterWords& w) { return w.edit == kind && w.key == key; });
        if (found != words.end()) return &*found;
    }
    return nullptr;
}

EditParameter parameterOf(std::string_view edit, const EditField& field) {
    const ParameterWords* known = wordsOf(edit, field.key);
    const KeyUnit* unit = unitOf(field.key);
    return {field, known != nullptr ? EditParameterTexts::tr(known->label) : labelOf(field.key),
            known != nullptr ? EditParameterTexts::tr(known->toolTip) : QString(),
            unit != nullptr ? unit->quantity : Quantity::ratio};
}

/// What a value that is told and not typed says.
struct ValueTexts {
    QString operator()(const Moment& moment) const {
        return EditParameterTexts::tr("take %1, tick %2").arg(moment.take).arg(moment.tick);
    }
    QString operator()(const Stretch& stretch) const {
        if (stretch.take == 0) return EditParameterTexts::tr("everything");
        if (stretch.last == Stretch{}.last)
            return EditParameterTexts::tr("take %1 from tick %2").arg(stretch.take).arg(stretch.first);
        return EditParameterTexts::tr("take %1, ticks %2 to %3").arg(stretch.take).arg(stretch.first).arg(stretch.last);
    }
    QString operator()(const std::vector<glm::dvec3>& places) const {
        return EditParameterTexts::tr("%n places", nullptr, static_cast<int>(places.size()));
    }
    QString operator()(const auto&) const { return {}; }
};

} // namespace

std::vector<EditParameter> parametersOf(const EditParameters& edit) {
    std::vector<EditParameter> parameters;
    for (const EditField& field : fieldsOf(edit)) parameters.push_back(parameterOf(idOf(edit), field));
    return parameters;
}

QString choiceText(std::string_view choice) {
    const auto found = std::ranges::find(choiceWords, choice, [](const auto& words) { return words.first; });
    if (found != choiceWords.end()) return EditParameterTexts::tr(found->second);
    QString text = QString::fromLatin1(choice.data(), static_cast<qsizetype>(choice.size()));
    text.replace(QLatin1Char('-'), QLatin1Char(' '));
    return text;
}

QString valueText(const EditValue& value) {
    return std::visit(ValueTexts{}, value);
}

} // namespace burin

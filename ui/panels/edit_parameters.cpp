// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_parameters.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cassert>

namespace burin {

namespace {

class EditParameterTexts {
    Q_DECLARE_TR_FUNCTIONS(EditParameterTexts)
};

/// What a panel says of one number of a kind of edit; what it may be, core knows.
struct NumberWords {
    std::string_view edit, key;
    Quantity quantity;
    const char* label;
    const char* toolTip;
};

constexpr std::array words{
    NumberWords{"drop-air-cuts", "shortest_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Shortest"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter stretch through air stays")},
    NumberWords{"drop-dwells", "speed_mm_s", Quantity::speed, QT_TRANSLATE_NOOP("EditParameterTexts", "Slower than"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "A tip slower than this dwells")},
    NumberWords{"drop-dwells", "time_s", Quantity::time, QT_TRANSLATE_NOOP("EditParameterTexts", "Longer than"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter rest stays")},
    NumberWords{"smooth", "cut_off_hz", Quantity::frequency, QT_TRANSLATE_NOOP("EditParameterTexts", "Cut-off"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "What trembles faster than this is smoothed away")},
    NumberWords{"smooth", "tolerance_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "No farther from what the hand did than this")},
    NumberWords{"hold-out", "clearance_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "Kept from the part beyond the allowance")},
    NumberWords{"hold-out", "sampling_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Sampling"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "How densely the path is held against the part")},
    NumberWords{"simplify", "tolerance_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "No point that is left out lies farther off than this")},
    NumberWords{"link", "clearance_above_mm", Quantity::length,
                QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance above"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "How far above the stock's top rapid moves run")},
    NumberWords{"link", "approach_mm", Quantity::length, QT_TRANSLATE_NOOP("EditParameterTexts", "Approach"),
                QT_TRANSLATE_NOOP("EditParameterTexts", "How far above what is left the plunge begins")}};

} // namespace

std::vector<EditParameter> parametersOf(const EditParameters& edit) {
    std::vector<EditParameter> parameters;
    for (const EditNumber& number : numbersOf(edit)) {
        const auto found = std::ranges::find_if(
            words, [&](const NumberWords& w) { return w.edit == idOf(edit) && w.key == number.key; });
        assert(found != words.end());
        parameters.push_back(
            {number, EditParameterTexts::tr(found->label), EditParameterTexts::tr(found->toolTip), found->quantity});
    }
    return parameters;
}

} // namespace burin

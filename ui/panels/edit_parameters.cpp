// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/edit_parameters.h"

#include <QCoreApplication>

namespace burin {

namespace {

class EditParameterTexts {
    Q_DECLARE_TR_FUNCTIONS(EditParameterTexts)
};

QString text(const char* source) {
    return EditParameterTexts::tr(source);
}

template <class T>
EditParameter parameter(const char* key, const char* label, const char* toolTip, Quantity quantity, double T::*member,
                        double low, double high) {
    return {QLatin1String(key),
            text(label),
            text(toolTip),
            quantity,
            low,
            high,
            [member](const EditParameters& edit) { return std::get<T>(edit).*member; },
            [member](EditParameters& edit, double value) { std::get<T>(edit).*member = value; }};
}

// Ranges are those of core/path/edit.cpp; a test holds them together.
struct Describe {
    std::vector<EditParameter> operator()(const DropAirCuts&) const {
        return {parameter("shortest_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Shortest"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter stretch through air stays"),
                          Quantity::length, &DropAirCuts::shortest, 0.0, 1000.0)};
    }
    std::vector<EditParameter> operator()(const DropDwells&) const {
        return {parameter("speed_mm_s", QT_TRANSLATE_NOOP("EditParameterTexts", "Slower than"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "A tip slower than this dwells"), Quantity::speed,
                          &DropDwells::speed, 0.0, 100.0),
                parameter("time_s", QT_TRANSLATE_NOOP("EditParameterTexts", "Longer than"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "A shorter rest stays"), Quantity::time,
                          &DropDwells::time, 0.0, 60.0)};
    }
    std::vector<EditParameter> operator()(const Smooth&) const {
        return {parameter("cut_off_hz", QT_TRANSLATE_NOOP("EditParameterTexts", "Cut-off"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "What trembles faster than this is smoothed away"),
                          Quantity::frequency, &Smooth::cutOff, 0.1, 500.0),
                parameter("tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "No farther from what the hand did than this"),
                          Quantity::length, &Smooth::tolerance, 0.0, 10.0)};
    }
    std::vector<EditParameter> operator()(const HoldOut&) const {
        return {parameter("clearance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "Kept from the part beyond the allowance"),
                          Quantity::length, &HoldOut::clearance, 0.001, 10.0),
                parameter("sampling_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Sampling"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "How densely the path is held against the part"),
                          Quantity::length, &HoldOut::sampling, 0.005, 1.0)};
    }
    std::vector<EditParameter> operator()(const Simplify&) const {
        return {
            parameter("tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                      QT_TRANSLATE_NOOP("EditParameterTexts", "No point that is left out lies farther off than this"),
                      Quantity::length, &Simplify::tolerance, 0.0, 10.0)};
    }
    std::vector<EditParameter> operator()(const Link&) const {
        return {parameter("clearance_above_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Clearance above"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "How far above the stock's top rapid moves run"),
                          Quantity::length, &Link::clearanceAbove, 0.1, 1000.0),
                parameter("approach_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Approach"),
                          QT_TRANSLATE_NOOP("EditParameterTexts", "How far above what is left the plunge begins"),
                          Quantity::length, &Link::approach, 0.1, 100.0)};
    }
    std::vector<EditParameter> operator()(const SetFeed&) const { return {}; }
};

} // namespace

std::vector<EditParameter> parametersOf(const EditParameters& edit) {
    return std::visit(Describe{}, edit);
}

} // namespace burin

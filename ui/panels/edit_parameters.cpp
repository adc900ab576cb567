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
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far above what is left the plunge begins")},
    ParameterWords{"smooth-spline", "cut_off_hz", QT_TRANSLATE_NOOP("EditParameterTexts", "Cut-off"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "What trembles faster than this is smoothed away")},
    ParameterWords{"smooth-spline", "tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No farther from what the hand did than this")},
    ParameterWords{"trim", "from_start_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "From the start"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "So much of the way goes at the start of each stroke")},
    ParameterWords{"trim", "from_end_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "From the end"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "So much of the way goes at the end of each stroke")},
    ParameterWords{"split", "at", QT_TRANSLATE_NOOP("EditParameterTexts", "At"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The moment at which the stroke becomes two")},
    ParameterWords{"join", "longest_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Longest gap"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Ends farther apart than this are not joined")},
    ParameterWords{"reorder", "stroke", QT_TRANSLATE_NOOP("EditParameterTexts", "Stroke"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The stroke of this moment is moved")},
    ParameterWords{"reorder", "before", QT_TRANSLATE_NOOP("EditParameterTexts", "Before"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "It comes before the stroke of this moment, or last")},
    ParameterWords{"mirror", "across", QT_TRANSLATE_NOOP("EditParameterTexts", "Across"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The axis that the mirror stands across")},
    ParameterWords{"mirror", "at_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "At"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Where the mirror stands on that axis")},
    ParameterWords{"mirror", "keep", QT_TRANSLATE_NOOP("EditParameterTexts", "Keep the original"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The image is added to what is there")},
    ParameterWords{"rotate", "centre_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Centre"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The upright axis that is turned about")},
    ParameterWords{"rotate", "angle_rad", QT_TRANSLATE_NOOP("EditParameterTexts", "Angle"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Anticlockwise, seen from above")},
    ParameterWords{"array", "step_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Step"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far each copy lies from the one before")},
    ParameterWords{"array", "centre_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Centre"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The upright axis that copies are turned about")},
    ParameterWords{"array", "turn_rad", QT_TRANSLATE_NOOP("EditParameterTexts", "Turn"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far each copy is turned from the one before")},
    ParameterWords{"array", "copies", QT_TRANSLATE_NOOP("EditParameterTexts", "Copies"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Besides the original")},
    ParameterWords{"move-points", "by_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "By"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far the points move")},
    ParameterWords{
        "move-points", "falloff_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Falloff"),
        QT_TRANSLATE_NOOP("EditParameterTexts", "How far beyond the stretch neighbours come along, ever less")},
    ParameterWords{"move-points", "along", QT_TRANSLATE_NOOP("EditParameterTexts", "Along"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Anywhere, or along the part's surface")},
    ParameterWords{"replace-stretch", "places_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "New stroke"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "What takes the stretch's place")},
    ParameterWords{"lift-area", "lift_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Lift"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far up what lies in the area goes")},
    ParameterWords{"project", "allowance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Allowance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Stock that is left on the part")},
    ParameterWords{"project", "sampling_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Sampling"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How densely the tool is laid on the part")},
    ParameterWords{"project", "along", QT_TRANSLATE_NOOP("EditParameterTexts", "Along"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Down the tool's axis, or the shortest way to the part")},
    ParameterWords{"offset", "distance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Distance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "To the left of the motion; negative: to the right")},
    ParameterWords{"guide-rows", "guide_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Guide"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The row that all others lie beside")},
    ParameterWords{"guide-rows", "step_over_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Step-over"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "From row to row, seen from above")},
    ParameterWords{"guide-rows", "left", QT_TRANSLATE_NOOP("EditParameterTexts", "Rows left"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Rows to the left of the guide")},
    ParameterWords{"guide-rows", "right", QT_TRANSLATE_NOOP("EditParameterTexts", "Rows right"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Rows to the right of the guide")},
    ParameterWords{"guide-rows", "allowance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Allowance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Stock that is left on the part")},
    ParameterWords{"round-corners", "tolerance_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Tolerance"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "By how much corners are passed")},
    ParameterWords{"round-corners", "smallest_turn_rad", QT_TRANSLATE_NOOP("EditParameterTexts", "Smallest turn"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Corners that turn by less stay")},
    ParameterWords{"lead-in", "form", QT_TRANSLATE_NOOP("EditParameterTexts", "Form"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How the tool comes to the stroke")},
    ParameterWords{"lead-in", "size_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Size"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Length of a line or ramp, radius of an arc or helix")},
    ParameterWords{"lead-in", "height_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Height"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How far a ramp or helix goes down")},
    ParameterWords{"lead-in", "angle_rad", QT_TRANSLATE_NOOP("EditParameterTexts", "Angle"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No helix goes down more steeply")},
    ParameterWords{"lead-out", "form", QT_TRANSLATE_NOOP("EditParameterTexts", "Form"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How the tool leaves the stroke")},
    ParameterWords{"lead-out", "size_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Size"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Length of a line, radius of an arc")},
    ParameterWords{"link", "travel", QT_TRANSLATE_NOOP("EditParameterTexts", "Travel"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Over everything, or as low as is safe")},
    ParameterWords{"level-feed", "goal", QT_TRANSLATE_NOOP("EditParameterTexts", "Goal"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "What stays level along the path")},
    ParameterWords{"level-feed", "target", QT_TRANSLATE_NOOP("EditParameterTexts", "Target"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "In N or mm³/s; 0: the mean that the path has")},
    ParameterWords{"level-feed", "smallest_chip_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Smallest chip"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No tooth takes less")},
    ParameterWords{"level-feed", "largest_chip_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Largest chip"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "No tooth takes more")},
    ParameterWords{"level-feed", "least_change", QT_TRANSLATE_NOOP("EditParameterTexts", "Least change"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Smaller changes of the feed are left out")},
    ParameterWords{"level-feed", "sampling_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Sampling"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "How often along a move the feed is looked at")},
    ParameterWords{"area-feed", "factor", QT_TRANSLATE_NOOP("EditParameterTexts", "Factor"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Feeds in the area are multiplied by it")},
    ParameterWords{
        "", "stretch", QT_TRANSLATE_NOOP("EditParameterTexts", "Stretch"),
        QT_TRANSLATE_NOOP("EditParameterTexts", "The strokes that are meant; everything, where no stretch is named")},
    ParameterWords{"", "outline_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "Outline"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "The area, seen from above")},
    ParameterWords{"", "low_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "From height"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Nothing below belongs to the area")},
    ParameterWords{"", "high_mm", QT_TRANSLATE_NOOP("EditParameterTexts", "To height"),
                   QT_TRANSLATE_NOOP("EditParameterTexts", "Nothing above belongs to the area")}};

constexpr std::array choiceWords{
    std::pair{std::string_view("x"), "X"},
    std::pair{std::string_view("y"), "Y"},
    std::pair{std::string_view("z"), "Z"},
    std::pair{std::string_view("free"), QT_TRANSLATE_NOOP("EditParameterTexts", "anywhere")},
    std::pair{std::string_view("surface"), QT_TRANSLATE_NOOP("EditParameterTexts", "on the part's surface")},
    std::pair{std::string_view("axis"), QT_TRANSLATE_NOOP("EditParameterTexts", "down the tool's axis")},
    std::pair{std::string_view("normal"), QT_TRANSLATE_NOOP("EditParameterTexts", "the shortest way")},
    std::pair{std::string_view("line"), QT_TRANSLATE_NOOP("EditParameterTexts", "line")},
    std::pair{std::string_view("arc"), QT_TRANSLATE_NOOP("EditParameterTexts", "arc")},
    std::pair{std::string_view("ramp"), QT_TRANSLATE_NOOP("EditParameterTexts", "ramp")},
    std::pair{std::string_view("helix"), QT_TRANSLATE_NOOP("EditParameterTexts", "helix")},
    std::pair{std::string_view("safe"), QT_TRANSLATE_NOOP("EditParameterTexts", "over everything")},
    std::pair{std::string_view("lowest"), QT_TRANSLATE_NOOP("EditParameterTexts", "as low as is safe")},
    std::pair{std::string_view("force"), QT_TRANSLATE_NOOP("EditParameterTexts", "cutting force")},
    std::pair{std::string_view("removal"), QT_TRANSLATE_NOOP("EditParameterTexts", "removal rate")}};

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
    QString operator()(const TakeStretch& stretch) const {
        if (stretch.take == 0) return EditParameterTexts::tr("everything");
        if (stretch.last == TakeStretch{}.last)
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

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit.h"

#include "core/base/numbers.h"
#include "core/geometry/pose.h"
#include "core/path/edit_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

Error invalid(const EditField& field, std::string value, std::string allowed) {
    return Error{ErrorCode::argumentInvalid, std::string(field.key), std::move(value), std::move(allowed)};
}

/// Checks one parameter by the type of its value.
struct CheckField {
    const EditField& field;

    Result<void> operator()(double value) const {
        if (value >= field.low && value <= field.high && (!field.whole || value == std::round(value))) return {};
        return invalid(field, formatShortest(value),
                       formatShortest(field.low) + " to " + formatShortest(field.high) +
                           (field.whole ? ", a whole number" : ""));
    }
    Result<void> operator()(bool) const { return {}; }
    Result<void> operator()(std::string_view) const { return {}; }
    Result<void> operator()(const glm::dvec3& value) const {
        if (isWithin(value, field.low, field.high)) return {};
        return invalid(field, "",
                       "coordinates from " + formatShortest(field.low) + " to " + formatShortest(field.high));
    }
    Result<void> operator()(const std::vector<glm::dvec3>& value) const {
        const auto size = static_cast<double>(value.size());
        if (!value.empty() && (size < field.low || size > field.high))
            return invalid(field, formatShortest(size),
                           formatShortest(field.low) + " to " + formatShortest(field.high) + " points");
        const auto isPlace = [](const glm::dvec3& place) { return isWithin(place, -farthestPlace, farthestPlace); };
        if (std::ranges::all_of(value, isPlace)) return {};
        return invalid(field, "", "coordinates up to " + formatShortest(farthestPlace));
    }
    Result<void> operator()(const Moment& value) const {
        if (value.tick >= 0) return {};
        return invalid(field, "", "a take and a tick of it, from 0");
    }
    Result<void> operator()(const SourceInterval& value) const {
        if (value.first >= 0 && value.first <= value.last) return {};
        return invalid(field, "", "a take and two ticks of it, the earlier one first");
    }

    static bool isWithin(const glm::dvec3& value, double low, double high) {
        for (int axis = 0; axis < 3; ++axis)
            if (!(value[axis] >= low && value[axis] <= high)) return false;
        return true;
    }
};

/// Whether a lead was of the earlier version; updates it.
bool isEarlier(LeadDirection& direction) {
    return std::exchange(direction, LeadDirection::recording) == LeadDirection::firstMove;
}

template <std::size_t... index>
std::vector<Edit> allKinds(std::index_sequence<index...>) {
    return {Edit{std::variant_alternative_t<index, EditParameters>{}}...};
}

} // namespace

const EditTraits& traitsOf(const EditParameters& parameters) {
    return *std::visit([]<class T>(const T&) { return &EditRow<T>::traits; }, parameters);
}

TextId titleOf(const EditParameters& parameters) {
    return traitsOf(parameters).title;
}

std::string_view idOf(const EditParameters& parameters) {
    return traitsOf(parameters).id;
}

std::vector<EditField> fieldsOf(const EditParameters& parameters) {
    return std::visit(
        []<class T>(const T& edit) {
            return std::apply([&](const auto&... field) { return std::vector<EditField>{field.of(edit)...}; },
                              EditRow<T>::fields);
        },
        parameters);
}

void setField(EditParameters& parameters, std::string_view key, const EditValue& value) {
    std::visit(
        [&]<class T>(T& edit) {
            std::apply(
                [&](const auto&... field) { ((field.of(edit).key == key ? field.set(edit, value) : void()), ...); },
                EditRow<T>::fields);
        },
        parameters);
}

Result<void> validate(const Edit& edit) {
    for (const EditField& field : fieldsOf(edit.parameters))
        if (Result<void> valid = std::visit(CheckField{field}, field.value); !valid) return valid;
    return {};
}

std::optional<Edit> updated(const Edit& edit) {
    constexpr double typicalSpeed = 15.0; // mm/s, of a hand that follows a shape
    const auto ofShape = [&](double cutOff, double tolerance) {
        return Edit{SmoothShape{typicalSpeed / cutOff, tolerance}, edit.enabled};
    };
    if (const auto* inTime = std::get_if<Smooth>(&edit.parameters)) return ofShape(inTime->cutOff, inTime->tolerance);
    if (const auto* spline = std::get_if<SmoothSpline>(&edit.parameters))
        return ofShape(spline->cutOff, spline->tolerance);
    Edit newer = edit;
    if (auto* in = std::get_if<LeadIn>(&newer.parameters); in != nullptr && isEarlier(in->direction)) return newer;
    if (auto* out = std::get_if<LeadOut>(&newer.parameters); out != nullptr && isEarlier(out->direction)) return newer;
    return std::nullopt;
}

std::vector<Edit> standardEdits() {
    Link gentle;
    gentle.entry = Link::Entry::ramp;
    SetFeed feeds;
    feeds.spindle = SetFeed::Spindle::byMaterial;
    return {
        {DropAirCuts{}}, {DropDwells{}}, {SmoothShape{}}, {HoldOut{}},
        {FitArcs{}},     {gentle},       {feeds},         {FeedOptimisation{.goal = FeedOptimisation::Goal::limits}}};
}

std::vector<Edit> computedEdits() {
    Link low;
    low.entry = Link::Entry::ramp;
    low.travel = Link::Travel::lowest;
    SetFeed feeds;
    feeds.spindle = SetFeed::Spindle::byMaterial;
    return {{HoldOut{}}, {FitArcs{}}, {low}, {feeds}, {FeedOptimisation{.goal = FeedOptimisation::Goal::limits}}};
}

std::vector<Edit> programEdits() {
    Link low;
    low.travel = Link::Travel::lowest;
    SetFeed stated;
    stated.feeds = SetFeed::Feeds::program;
    return {{FitArcs{.tolerance = 0.002}}, {low}, {stated}};
}

bool suitsFixedTool(const EditParameters& parameters) {
    if (traitsOf(parameters).step == EditStep::axis) return false; // it cuts as a solid, upright
    if (traitsOf(parameters).group == EditGroup::feeds) return false;
    const auto* link = std::get_if<Link>(&parameters);
    return link == nullptr || (link->travel == Link::Travel::safe && link->entry == Link::Entry::plunge);
}

std::vector<Edit> forFixedTool(std::vector<Edit> edits) {
    for (Edit& edit : edits)
        if (auto* link = std::get_if<Link>(&edit.parameters)) {
            link->travel = Link::Travel::safe;
            link->entry = Link::Entry::plunge;
        }
    std::erase_if(edits, [](const Edit& edit) { return !suitsFixedTool(edit.parameters); });
    return edits;
}

std::vector<Edit> everyEdit() {
    return allKinds(std::make_index_sequence<std::variant_size_v<EditParameters>>{});
}

} // namespace burin

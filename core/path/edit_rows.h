// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/edit_field.h"
#include "core/path/edit_step.h"

#include <tuple>

/// The table of all kinds of edits, a row each: id, title, step, what it does to the path's guarantees, parameters.
/// Files, validation, the order and the user interface read it here.
namespace burin {

template <class T>
struct EditRow;

template <>
struct EditRow<DropAirCuts> {
    static constexpr EditTraits traits{.id = "drop-air-cuts", .title = BURIN_TEXT("Edit", "Drop air cuts")};
    static constexpr std::tuple fields{number("shortest_mm", &DropAirCuts::shortest, 0.0, 1000.0)};
};
template <>
struct EditRow<DropDwells> {
    static constexpr EditTraits traits{.id = "drop-dwells", .title = BURIN_TEXT("Edit", "Drop dwells")};
    static constexpr std::tuple fields{number("speed_mm_s", &DropDwells::speed, 0.0, 100.0),
                                       number("time_s", &DropDwells::time, 0.0, 60.0)};
};
template <>
struct EditRow<Smooth> {
    static constexpr EditTraits traits{
        .id = "smooth", .title = BURIN_TEXT("Edit", "Smooth"), .approximates = true, .mayEnter = true};
    static constexpr std::tuple fields{number("cut_off_hz", &Smooth::cutOff, 0.1, 500.0),
                                       number("tolerance_mm", &Smooth::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<HoldOut> {
    static constexpr EditTraits traits{.id = "hold-out",
                                       .title = BURIN_TEXT("Edit", "Hold out of the part"),
                                       .step = EditStep::surface,
                                       .approximates = true,
                                       .holdsOut = true};
    static constexpr std::tuple fields{number("clearance_mm", &HoldOut::clearance, 0.001, 10.0),
                                       number("sampling_mm", &HoldOut::sampling, 0.005, 1.0)};
};
template <>
struct EditRow<Simplify> {
    static constexpr EditTraits traits{
        .id = "simplify", .title = BURIN_TEXT("Edit", "Simplify"), .step = EditStep::surface, .approximates = true};
    static constexpr std::tuple fields{number("tolerance_mm", &Simplify::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<FitArcs> {
    static constexpr EditTraits traits{
        .id = "fit-arcs", .title = BURIN_TEXT("Edit", "Fit arcs"), .step = EditStep::curves, .approximates = true};
    static constexpr std::tuple fields{number("tolerance_mm", &FitArcs::tolerance, 0.0002, 1.0),
                                       number("largest_sweep_rad", &FitArcs::largestSweep, 0.1, pi),
                                       number("smallest_radius_mm", &FitArcs::smallestRadius, 0.01, 100.0),
                                       number("largest_radius_mm", &FitArcs::largestRadius, 0.1, 10000.0),
                                       number("radius_mismatch_mm", &FitArcs::radiusMismatch, 0.0001, 0.1)};
};
template <>
struct EditRow<Link> {
    static constexpr EditTraits traits{
        .id = "link", .title = BURIN_TEXT("Edit", "Link"), .step = EditStep::links, .once = true};
    static constexpr std::tuple fields{number("clearance_above_mm", &Link::clearanceAbove, 0.1, 1000.0),
                                       number("approach_mm", &Link::approach, 0.1, 100.0)};
};
template <>
struct EditRow<SetFeed> {
    static constexpr EditTraits traits{
        .id = "set-feed", .title = BURIN_TEXT("Edit", "Set feed and speed"), .step = EditStep::feed, .once = true};
    static constexpr std::tuple<> fields{};
};

} // namespace burin

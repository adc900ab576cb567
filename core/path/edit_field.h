// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit.h"

#include <array>
#include <cstddef>

/// Descriptions of a parameter in a row of the table, one class per kind of value. Each describes the parameter (`of`)
/// and sets its value (`set`).
namespace burin {

/// Limit for the coordinates of points and vectors, mm.
inline constexpr double farthestPlace = 1e5;

template <class T>
struct NumberField {
    std::string_view key;
    FieldLabels words;
    double T::*member;
    double low, high;
    bool whole;

    EditField of(const T& edit) const { return {key, words, edit.*member, low, high, whole}; }
    void set(T& edit, const EditValue& value) const { edit.*member = std::get<double>(value); }
};
template <class T>
constexpr NumberField<T> number(std::string_view key, double T::*member, double low, double high,
                                const FieldLabels& words) {
    return {key, words, member, low, high, false};
}
/// An integral number; stored as the others are.
template <class T>
constexpr NumberField<T> count(std::string_view key, double T::*member, double low, double high,
                               const FieldLabels& words) {
    return {key, words, member, low, high, true};
}

/// A switch, a moment, an interval, a point or points: anything that needs no more than its key.
template <class T, class Member>
struct PlainField {
    std::string_view key;
    FieldLabels words;
    Member T::*member;
    double low, high;

    EditField of(const T& edit) const { return {key, words, edit.*member, low, high}; }
    void set(T& edit, const EditValue& value) const { edit.*member = std::get<Member>(value); }
};
template <class T>
constexpr PlainField<T, bool> onOff(std::string_view key, bool T::*member, const FieldLabels& words) {
    return {key, words, member, 0.0, 0.0};
}
template <class T>
constexpr PlainField<T, Moment> moment(std::string_view key, Moment T::*member, const FieldLabels& words) {
    return {key, words, member, 0.0, 0.0};
}
template <class T>
constexpr PlainField<T, SourceInterval> interval(std::string_view key, SourceInterval T::*member,
                                                 const FieldLabels& words) {
    return {key, words, member, 0.0, 0.0};
}
template <class T>
constexpr PlainField<T, glm::dvec3> place(std::string_view key, glm::dvec3 T::*member, const FieldLabels& words) {
    return {key, words, member, -farthestPlace, farthestPlace};
}
/// @param fewest least number of points, unless there are none
template <class T>
constexpr PlainField<T, std::vector<glm::dvec3>> places(std::string_view key, std::vector<glm::dvec3> T::*member,
                                                        double fewest, const FieldLabels& words) {
    return {key, words, member, fewest, 10000.0};
}

/// One of the names of an enumeration, in its order.
template <class T, class Enumeration, std::size_t size>
struct ChoiceField {
    std::string_view key;
    FieldLabels words;
    Enumeration T::*member;
    const std::array<EditChoice, size>* names;

    EditField of(const T& edit) const {
        return {key, words, (*names)[static_cast<std::size_t>(edit.*member)].name, 0.0, 0.0, false, *names};
    }
    void set(T& edit, const EditValue& value) const {
        for (std::size_t i = 0; i < size; ++i)
            if ((*names)[i].name == std::get<std::string_view>(value)) edit.*member = static_cast<Enumeration>(i);
    }
};
template <class T, class Enumeration, std::size_t size>
constexpr ChoiceField<T, Enumeration, size> choice(std::string_view key, Enumeration T::*member,
                                                   const std::array<EditChoice, size>& names,
                                                   const FieldLabels& words) {
    return {key, words, member, &names};
}

} // namespace burin

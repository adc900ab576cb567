// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit.h"

#include "core/base/numbers.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace burin {
namespace {

using Json = nlohmann::json;

/// One number of an edit: its key, where it is kept and what it may be.
template <class T>
struct Parameter {
    const char* key;
    double T::*member;
    double low, high;
};

/// What is known of a kind of edit: id, title and parameters. Files, validation and the user interface read it here.
template <class T>
struct Kind;
template <>
struct Kind<DropAirCuts> {
    static constexpr const char* id = "drop-air-cuts";
    static constexpr TextId title = BURIN_TEXT("Edit", "Drop air cuts");
    static constexpr std::array parameters{Parameter<DropAirCuts>{"shortest_mm", &DropAirCuts::shortest, 0.0, 1000.0}};
};
template <>
struct Kind<DropDwells> {
    static constexpr const char* id = "drop-dwells";
    static constexpr TextId title = BURIN_TEXT("Edit", "Drop dwells");
    static constexpr std::array parameters{Parameter<DropDwells>{"speed_mm_s", &DropDwells::speed, 0.0, 100.0},
                                           Parameter<DropDwells>{"time_s", &DropDwells::time, 0.0, 60.0}};
};
template <>
struct Kind<Smooth> {
    static constexpr const char* id = "smooth";
    static constexpr TextId title = BURIN_TEXT("Edit", "Smooth");
    static constexpr std::array parameters{Parameter<Smooth>{"cut_off_hz", &Smooth::cutOff, 0.1, 500.0},
                                           Parameter<Smooth>{"tolerance_mm", &Smooth::tolerance, 0.0, 10.0}};
};
template <>
struct Kind<HoldOut> {
    static constexpr const char* id = "hold-out";
    static constexpr TextId title = BURIN_TEXT("Edit", "Hold out of the part");
    static constexpr std::array parameters{Parameter<HoldOut>{"clearance_mm", &HoldOut::clearance, 0.001, 10.0},
                                           Parameter<HoldOut>{"sampling_mm", &HoldOut::sampling, 0.005, 1.0}};
};
template <>
struct Kind<Simplify> {
    static constexpr const char* id = "simplify";
    static constexpr TextId title = BURIN_TEXT("Edit", "Simplify");
    static constexpr std::array parameters{Parameter<Simplify>{"tolerance_mm", &Simplify::tolerance, 0.0, 10.0}};
};
template <>
struct Kind<Link> {
    static constexpr const char* id = "link";
    static constexpr TextId title = BURIN_TEXT("Edit", "Link");
    static constexpr std::array parameters{Parameter<Link>{"clearance_above_mm", &Link::clearanceAbove, 0.1, 1000.0},
                                           Parameter<Link>{"approach_mm", &Link::approach, 0.1, 100.0}};
};
template <>
struct Kind<SetFeed> {
    static constexpr const char* id = "set-feed";
    static constexpr TextId title = BURIN_TEXT("Edit", "Set feed and speed");
    static constexpr std::array<Parameter<SetFeed>, 0> parameters{};
};

Error invalid(const std::string& subject, std::string value, std::string allowed) {
    return Error{ErrorCode::argumentInvalid, subject, std::move(value), std::move(allowed)};
}

template <class T>
std::string rangeText(const Parameter<T>& parameter) {
    return formatShortest(parameter.low) + " to " + formatShortest(parameter.high);
}

template <class T>
Result<void> validateParameters(const T& edit) {
    for (const Parameter<T>& parameter : Kind<T>::parameters) {
        const double value = edit.*parameter.member;
        if (!(value >= parameter.low && value <= parameter.high))
            return invalid(parameter.key, formatShortest(value), rangeText(parameter));
    }
    return {};
}

/// Fills the parameters that the object states and refuses keys that are none.
template <class T>
Result<void> read(T& edit, const Json& object) {
    for (const auto& [key, value] : object.items()) {
        if (key == "edit" || key == "enabled") continue;
        const Parameter<T>* found = nullptr;
        for (const Parameter<T>& parameter : Kind<T>::parameters) {
            if (key == parameter.key) found = &parameter;
        }
        if (found == nullptr) return invalid(key, "", std::string("no parameter of ") + Kind<T>::id);
        if (!value.is_number()) return invalid(key, value.dump(), rangeText(*found));
        edit.*(found->member) = value.template get<double>();
    }
    return validateParameters(edit);
}

/// Calls `function` with a default-made edit of the given id.
template <std::size_t index = 0, class Function>
bool withKind(std::string_view id, const Function& function) {
    if constexpr (index == std::variant_size_v<EditParameters>) {
        return false;
    } else {
        using T = std::variant_alternative_t<index, EditParameters>;
        if (id == Kind<T>::id) {
            function(T{});
            return true;
        }
        return withKind<index + 1>(id, function);
    }
}

template <std::size_t... index>
std::string idsOf(std::index_sequence<index...>) {
    std::string ids;
    ((ids += (index == 0 ? "" : " ") + std::string(Kind<std::variant_alternative_t<index, EditParameters>>::id)), ...);
    return ids;
}

} // namespace

TextId titleOf(const EditParameters& parameters) {
    return std::visit([]<class T>(const T&) { return Kind<T>::title; }, parameters);
}

std::string_view idOf(const EditParameters& parameters) {
    return std::visit([]<class T>(const T&) -> std::string_view { return Kind<T>::id; }, parameters);
}

Result<void> validate(const Edit& edit) {
    return std::visit([](const auto& parameters) { return validateParameters(parameters); }, edit.parameters);
}

std::vector<EditNumber> numbersOf(const EditParameters& parameters) {
    return std::visit(
        []<class T>(const T& edit) {
            std::vector<EditNumber> numbers;
            for (const Parameter<T>& parameter : Kind<T>::parameters)
                numbers.push_back({parameter.key, edit.*parameter.member, parameter.low, parameter.high});
            return numbers;
        },
        parameters);
}

void setNumber(EditParameters& parameters, std::string_view key, double value) {
    std::visit(
        [&]<class T>(T& edit) {
            for (const Parameter<T>& parameter : Kind<T>::parameters)
                if (key == parameter.key) edit.*parameter.member = value;
        },
        parameters);
}

std::string toJson(const Edit& edit) {
    nlohmann::ordered_json object;
    object["edit"] = idOf(edit.parameters);
    object["enabled"] = edit.enabled;
    std::visit(
        [&]<class T>(const T& parameters) {
            for (const Parameter<T>& parameter : Kind<T>::parameters)
                object[parameter.key] = parameters.*parameter.member;
        },
        edit.parameters);
    return object.dump();
}

Result<Edit> editFromJson(std::string_view text) {
    const Json object = Json::parse(text, nullptr, false);
    if (!object.is_object()) return invalid("edit", std::string(text.substr(0, 80)), "a JSON object");
    const auto id = object.find("edit");
    const std::string allowed = idsOf(std::make_index_sequence<std::variant_size_v<EditParameters>>{});
    if (id == object.end() || !id->is_string())
        return invalid("edit", id == object.end() ? "" : id->dump(), "one of: " + allowed);
    Edit edit;
    if (const auto enabled = object.find("enabled"); enabled != object.end()) {
        if (!enabled->is_boolean()) return invalid("enabled", enabled->dump(), "true or false");
        edit.enabled = enabled->get<bool>();
    }
    Result<void> done;
    const bool known = withKind(id->get_ref<const std::string&>(), [&](auto parameters) {
        done = read(parameters, object);
        edit.parameters = parameters;
    });
    if (!known) return Error{ErrorCode::nameUnknown, "edit", id->get<std::string>(), allowed};
    if (!done) return done.error();
    return edit;
}

std::vector<Edit> standardEdits() {
    return {{DropAirCuts{}}, {DropDwells{}}, {Smooth{}}, {HoldOut{}}, {Simplify{}}, {Link{}}, {SetFeed{}}};
}

} // namespace burin

// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

Error invalid(std::string_view subject, const std::string& value, const std::string& allowed) {
    return Error{ErrorCode::argumentInvalid, std::string(subject), value, allowed};
}

Json jsonOf(const glm::dvec3& place) {
    return Json::array({place.x, place.y, place.z});
}

struct Write {
    Json operator()(double value) const { return value; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::string_view value) const { return value; }
    Json operator()(const glm::dvec3& value) const { return jsonOf(value); }
    Json operator()(const std::vector<glm::dvec3>& value) const {
        Json list = Json::array();
        for (const glm::dvec3& place : value) list.push_back(jsonOf(place));
        return list;
    }
    Json operator()(const Moment& value) const { return {{"take", value.source}, {"tick", value.tick}}; }
    Json operator()(const SourceInterval& value) const {
        Json object{{"take", value.source}, {"first", value.first}};
        if (value.last != SourceInterval{}.last) object["last"] = value.last;
        return object;
    }
};

/// Reads the members of an object: integers with these names and no others. @return false for any other object
bool readNumbers(const Json& object, std::initializer_list<std::pair<std::string_view, std::int64_t*>> members) {
    if (!object.is_object()) return false;
    for (const auto& [key, value] : object.items()) {
        const auto member = std::ranges::find_if(members, [&](const auto& m) { return m.first == key; });
        if (member == members.end() || !value.is_number_integer()) return false;
        *member->second = value.template get<std::int64_t>();
    }
    return true;
}

bool readPlace(const Json& list, glm::dvec3& place) {
    if (!list.is_array() || list.size() != 3) return false;
    for (int axis = 0; axis < 3; ++axis) {
        if (!list[static_cast<std::size_t>(axis)].is_number()) return false;
        place[axis] = list[static_cast<std::size_t>(axis)].get<double>();
    }
    return true;
}

/// Reads a value of the parameter's type. @return what is allowed, if the text is something else
struct Read {
    const EditField& field;
    const Json& json;
    EditValue& value;
    using Refusal = std::optional<std::string>;

    Refusal operator()(double) const {
        if (!json.is_number()) return "a number";
        value = json.get<double>();
        return {};
    }
    Refusal operator()(bool) const {
        if (!json.is_boolean()) return "true or false";
        value = json.get<bool>();
        return {};
    }
    Refusal operator()(std::string_view) const {
        std::string names;
        for (const EditChoice& choice : field.choices) {
            const std::string_view name = choice.name;
            if (json.is_string() && json.get_ref<const std::string&>() == name) {
                value = name;
                return {};
            }
            names += (names.empty() ? "one of: " : " ") + std::string(name);
        }
        return names;
    }
    Refusal operator()(const glm::dvec3&) const {
        glm::dvec3 place{0.0};
        if (!readPlace(json, place)) return "three numbers";
        value = place;
        return {};
    }
    Refusal operator()(const std::vector<glm::dvec3>&) const {
        if (!json.is_array()) return "a list of points, three numbers each";
        std::vector<glm::dvec3> places(json.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            if (!readPlace(json[i], places[i])) return "a list of points, three numbers each";
        value = std::move(places);
        return {};
    }
    Refusal operator()(const Moment&) const {
        Moment moment;
        if (!readNumbers(json, {{"take", &moment.source}, {"tick", &moment.tick}}))
            return R"({"take": number, "tick": number})";
        value = moment;
        return {};
    }
    Refusal operator()(const SourceInterval&) const {
        SourceInterval interval;
        if (!readNumbers(json, {{"take", &interval.source}, {"first", &interval.first}, {"last", &interval.last}}))
            return R"({"take": number, "first": number, "last": number})";
        value = interval;
        return {};
    }
};

/// Sets parameters that older projects do not state to the behaviour of the edit before it had them.
void makeEarliest(EditParameters& parameters) {
    if (auto* in = std::get_if<LeadIn>(&parameters)) in->direction = LeadDirection::firstMove;
    if (auto* out = std::get_if<LeadOut>(&parameters)) out->direction = LeadDirection::firstMove;
}

/// Earlier versions wrote the target of feed optimisation without its unit.
bool isKey(const EditField& field, std::string_view key) {
    return field.key == key || (key == "target" && (field.key == "target_n" || field.key == "target_mm3_s"));
}

bool isName(const EditField& field) {
    return std::holds_alternative<std::string_view>(field.value);
}

/// Sets the parameters that the object states: its choices (`names`), or all others, which may depend on them.
Result<void> read(Edit& edit, const Json& object, bool names) {
    const std::vector<EditField> fields = fieldsOf(edit.parameters);
    for (const auto& [key, json] : object.items()) {
        if (key == "edit" || key == "enabled") continue;
        const auto field =
            std::ranges::find_if(fields, [&, &name = key](const EditField& f) { return isKey(f, name); });
        if ((field != fields.end() && isName(*field)) != names) continue;
        if (field == fields.end()) return invalid(key, "", "no parameter of " + std::string(idOf(edit.parameters)));
        EditValue value = field->value;
        if (const auto refusal = std::visit(Read{*field, json, value}, field->value))
            return invalid(key, json.dump(), *refusal);
        setField(edit.parameters, field->key, value);
    }
    return {};
}

} // namespace

std::string toJson(const Edit& edit) {
    Json object;
    object["edit"] = idOf(edit.parameters);
    object["enabled"] = edit.enabled;
    for (const EditField& field : fieldsOf(edit.parameters))
        object[std::string(field.key)] = std::visit(Write{}, field.value);
    return object.dump();
}

Result<Edit> editFromJson(std::string_view text) {
    const Json object = Json::parse(text, nullptr, false);
    if (!object.is_object()) return invalid("edit", std::string(text.substr(0, 80)), "a JSON object");
    std::string allowed;
    std::vector<Edit> kinds = everyEdit();
    for (const Edit& kind : kinds) allowed += (allowed.empty() ? "" : " ") + std::string(idOf(kind.parameters));
    const auto id = object.find("edit");
    if (id == object.end() || !id->is_string())
        return invalid("edit", id == object.end() ? "" : id->dump(), "one of: " + allowed);
    const auto kind = std::ranges::find_if(
        kinds, [&](const Edit& k) { return idOf(k.parameters) == id->get_ref<const std::string&>(); });
    if (kind == kinds.end()) return Error{ErrorCode::nameUnknown, "edit", id->get<std::string>(), allowed};
    if (const auto enabled = object.find("enabled"); enabled != object.end()) {
        if (!enabled->is_boolean()) return invalid("enabled", enabled->dump(), "true or false");
        kind->enabled = enabled->get<bool>();
    }
    makeEarliest(kind->parameters);
    for (const bool names : {true, false})
        if (Result<void> done = read(*kind, object, names); !done) return done.error();
    if (Result<void> valid = validate(*kind); !valid) return valid.error();
    return std::move(*kind);
}

} // namespace burin

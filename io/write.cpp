// JSON as text that people can read too: an object or a list is broken over lines only when it does not fit on one.
#include <nlohmann/json.hpp>
#include <utility>

#include "snug/io.hpp"

namespace snug {
namespace {

constexpr std::size_t line_width = 120;

std::string scalar(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string key(const Json::const_iterator& item, const Json& of) {
    return of.is_object() ? scalar(item.key()) + ": " : "";
}

std::string on_one_line(const Json& json) {
    if (!json.is_structured()) {
        return scalar(json);
    }
    std::string text;
    for (auto item = json.begin(); item != json.end(); ++item) {
        text += (text.empty() ? "" : ", ") + key(item, json) + on_one_line(*item);
    }
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string broken(const Json& json, std::size_t indent) {
    std::string text = on_one_line(json);
    if (!json.is_structured() || indent + text.size() <= line_width) {
        return text;
    }
    text = json.is_object() ? "{" : "[";
    for (auto item = json.begin(); item != json.end(); ++item) {
        text += item == json.begin() ? "\n" : ",\n";
        text += std::string(indent + 2, ' ') + key(item, json) + broken(*item, indent + 2);
    }
    return text + "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string ListInParts::begin(const Json& object, const std::string& key_of_list) {
    std::string text = "{";
    for (auto item = object.begin(); item != object.end(); ++item)
        text += "\n  " + key(item, object) + broken(*item, 2) + ',';
    return text + "\n  " + scalar(key_of_list) + ": [";
}

std::string ListInParts::item(const Json& item) {
    return (std::exchange(first_, false) ? "\n    " : ",\n    ") + broken(item, 4);
}

std::string ListInParts::end() { return first_ ? "]\n}\n" : "\n  ]\n}\n"; }

std::string write(const Json& json) { return broken(json, 0) + "\n"; }

std::string write(double number) { return scalar(number); }

}  // namespace snug

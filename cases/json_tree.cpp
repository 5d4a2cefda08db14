// SPDX-License-Identifier: MIT
#include "cases/json_tree.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace cases {
namespace {

using Json = nlohmann::json;

// Receives the events of the parser. A child that is being filled is the last of its parent, and the parent grows only
// when the child is complete: the pointers in `open_` stay valid.
class TreeBuilder : public nlohmann::json_sax<Json> {
  public:
    TreeBuilder(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {
        root_.where = path + ": ";
    }

    Value take() {
        if (root_.kind != Value::Kind::object) {
            root_.where = path_;
            refuse(root_, "must be an object", "begin the file with {");
        }
        return std::move(root_);
    }

    bool null() override { return scalar(Value::Kind::null, 0.0); }
    bool boolean(bool value) override { return scalar(Value::Kind::boolean, value ? 1.0 : 0.0); }
    bool number_integer(number_integer_t value) override {
        return scalar(Value::Kind::number, static_cast<double>(value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        return scalar(Value::Kind::number, static_cast<double>(value));
    }
    bool number_float(number_float_t value, const string_t&) override {
        return scalar(Value::Kind::number, value);
    }
    bool string(string_t& value) override {
        add(Value::Kind::text).written_text = std::move(value);
        return true;
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Value::Kind::object); }
    bool start_array(std::size_t) override { return open(Value::Kind::list); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        Value& object = *open_.back();
        key_ = name;
        if (object.has(name)) {
            throw scaling::InvalidInput(
                scaling::mistake(child_path(object), "the key a second time",
                                 "must stand once in its object", "remove one of the two"));
        }
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const Json::exception& error) override {
        const std::size_t at = std::min(position == 0 ? 0 : position - 1, bytes_.size());
        const auto from = bytes_.begin(), to = from + static_cast<std::ptrdiff_t>(at);
        const auto line = std::count(from, to, '\n') + 1;
        const std::size_t line_start = at == 0 ? std::string::npos : bytes_.rfind('\n', at - 1);
        const std::size_t column = line_start == std::string::npos ? at + 1 : at - line_start;
        const bool ended = std::string(error.what()).find("end of input") != std::string::npos;
        const std::string inside = open_.empty() ? "the file" : place(*open_.back());
        throw scaling::InvalidInput(scaling::mistake(
            fmt::format("{}:{}:{}", path_, line, column),
            ended ? "the end of the file"
                  : in_quotes(bytes_.substr(at, bytes_.find_first_of(" \t\r\n", at) - at)),
            "must be complete JSON here",
            ended ? inside + " is not closed"
                  : "look inside " + inside + " for a missing comma, quote or bracket"));
    }

  private:
    static std::string place(const Value& value) {
        const std::string path = value.where.substr(value.where.rfind(": ") + 2);
        return path.empty() ? "the outermost object" : path;
    }

    std::string child_path(const Value& parent) const {
        if (parent.kind == Value::Kind::list)
            return fmt::format("{}[{}]", parent.where, parent.items.size());
        const std::string shown = in_quotes(key_);
        return parent.where + (parent.where.ends_with(": ") ? "" : ".") +
               shown.substr(1, shown.size() - 2);
    }

    Value& add(Value::Kind kind) {
        Value* value = &root_;
        if (!open_.empty()) {
            Value& parent = *open_.back();
            Value child;
            child.where = child_path(parent);
            if (parent.kind == Value::Kind::list) {
                parent.items.push_back(std::move(child));
                value = &parent.items.back();
            } else {
                parent.members.emplace_back(key_, std::move(child));
                value = &parent.members.back().second;
            }
        }
        value->kind = kind;
        return *value;
    }

    bool scalar(Value::Kind kind, double number) {
        add(kind).written_number = number;
        return true;
    }

    bool open(Value::Kind kind) {
        constexpr std::size_t deepest = 32;  // a case needs 6; more would only exhaust the stack
        Value& value = add(kind);
        if (open_.size() == deepest)
            refuse(value, "must not be nested this deep", "flatten the file");
        open_.push_back(&value);
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    const std::string& path_;
    const std::string& bytes_;
    Value root_;
    std::vector<Value*> open_;
    std::string key_;
};

}  // namespace

Value read_json(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)),
                            std::istreambuf_iterator<char>());
    if (!file.is_open() || file.bad() || std::filesystem::is_directory(path)) {
        throw scaling::InvalidInput(scaling::mistake(path, "no readable file",
                                                     "must be a case (case.json or its folder)",
                                                     "check the path"));
    }
    TreeBuilder builder(path, bytes);
    Json::sax_parse(bytes, &builder);
    return builder.take();
}

}  // namespace cases

// The options of a subcommand: each is declared once, with its help and what may be typed, and read into a typed value.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/numbers.hpp"
#include "snug/error.hpp"

namespace snug::cli {

/// An option that the command does not have; another may.
struct UnknownOption : Error {
    UnknownOption(std::string typed, const std::string& sentence) : Error(sentence), option(std::move(typed)) {}

    std::string option;  ///< as in "--road"
};

/// What was typed after an option, understood; nothing when it was not given. Only a declaration makes one, so an option that
/// was never declared cannot be read.
template <class Value>
class Option {
public:
    [[nodiscard]] const std::string& name() const { return typed_->name; }  ///< as in "--car"
    explicit operator bool() const { return typed_->value.has_value(); }
    const Value& operator*() const { return *typed_->value; }
    const Value* operator->() const { return &*typed_->value; }
    [[nodiscard]] Value value_or(Value otherwise) const { return typed_->value.value_or(std::move(otherwise)); }

private:
    friend class Options;
    struct Typed {
        std::string name;
        std::optional<Value> value;
    };
    explicit Option(std::string name) : typed_(std::make_shared<Typed>(Typed{std::move(name), {}})) {}
    std::shared_ptr<Typed> typed_;  ///< shared with the Options that will read it
};

/// A word that may be typed, and what it stands for.
template <class Value>
using Word = std::pair<const char*, Value>;

/// The options of one subcommand. Whatever is wrong with what was typed is an Error that begins with the option.
class Options {
public:
    /// `examples` ends the help text.
    Options(const std::string& command, const std::string& purpose, const std::string& examples);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// The heading in the help text of the options that follow.
    Options& group(const std::string& title);

    // Each declares an option: its names ("-o,--output"), what its value is called in the help text, and the help.
    Option<std::string> text(const std::string& names, const std::string& value, const std::string& help);
    Option<double> number(const std::string& names, const std::string& value, const std::string& help,
                          const Quantity& quantity);
    Option<int> whole_number(const std::string& names, const std::string& value, const std::string& help, int low,
                             int high);
    Option<std::vector<double>> numbers(const std::string& names, const std::string& value, const std::string& help,
                                        const Quantity& quantity);
    template <class Value>
    Option<Value> choice(const std::string& names, const std::string& value, const std::string& help,
                         const std::vector<Word<Value>>& words) {
        return declared<Value>(names, value, help, [words](const std::string& option, const std::string& typed) {
            std::vector<std::string> known;
            for (const Word<Value>& word : words) known.emplace_back(word.first);
            return words[cli::choice(option, typed, known)].second;
        });
    }
    /// A value that `understand` makes of the option's name and what was typed.
    template <class Value, class Understand>
    Option<Value> declared(const std::string& names, const std::string& value, const std::string& help,
                           const Understand& understand) {
        Option<Value> option(long_name(names));
        declare(names, value, help, [typed = option.typed_, understand](const std::string& text) {
            typed->value = understand(typed->name, text);
        });
        return option;
    }
    /// What stands alone, without a name before it.
    Option<std::string> argument(const std::string& name, const std::string& help);

    /// False when help is wanted instead. Throws Error when an option is unknown, twice there, without a value, or its value is
    /// none of those it may have.
    [[nodiscard]] bool read(const std::vector<std::string>& arguments);
    [[nodiscard]] std::string help() const;

private:
    using Take = std::function<void(const std::string& typed)>;
    static std::string long_name(const std::string& names) { return names.substr(names.find("--")); }
    void declare(const std::string& names, const std::string& value, const std::string& help, Take take);

    struct Parser;
    std::unique_ptr<Parser> parser_;
};

}  // namespace snug::cli

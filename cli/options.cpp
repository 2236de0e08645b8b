// The only file that knows CLI11, whose one header takes as long to compile as the rest of the command.
#include "cli/options.hpp"

#include <CLI/CLI.hpp>

#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

/// About the first argument that is no option of the app's: what it could have been.
[[noreturn]] void refuse(const CLI::App& app, const std::string& argument) {
    if (argument.size() < 2 || argument[0] != '-') {
        throw Error("unexpected argument " + in_quotes(argument) + "; see " + app.get_name() + " --help");
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string name = argument.substr(0, argument.find('='));
    throw UnknownOption(name,
                        "unknown option " + in_quotes(name) + "; " +
                            did_you_mean(nearest_word(name, names), app.get_name() + " --help lists those there are"));
}

}  // namespace

struct Options::Parser {
    /// An option, what was typed after it, and what takes that in.
    struct Declared {
        Take take;
        std::optional<std::string> typed;
    };

    CLI::App app;
    std::string group;
    std::vector<std::unique_ptr<Declared>> all = {};

    CLI::Option* add(const std::string& names, const std::string& help, Take take) {
        Declared* const declared = all.emplace_back(new Declared{std::move(take), {}}).get();
        return app.add_option(
            names,
            [declared](const CLI::results_t& results) {
                declared->typed = results.front();
                return true;
            },
            help);
    }
};

Options::Options(const std::string& command, const std::string& purpose, const std::string& examples)
    : parser_(new Parser{CLI::App(purpose + "\n", command), {}}) {
    CLI::App& app = parser_->app;
    app.set_help_flag("-h,--help", "This text.");
    app.footer(examples);
    app.allow_extras();  // so that the sentence about them is ours
    app.get_formatter()->column_width(26);
    app.get_formatter()->label("OPTIONS", "options");
    app.get_formatter()->label("Positionals", "Arguments");
}

Options::~Options() = default;

Options& Options::group(const std::string& title) {
    parser_->group = title;
    return *this;
}

void Options::declare(const std::string& names, const std::string& value, const std::string& help, Take take) {
    parser_->add(names, help, std::move(take))->type_name(value)->group(parser_->group);
}

Option<std::string> Options::text(const std::string& names, const std::string& value, const std::string& help) {
    return declared<std::string>(names, value, help,
                                 [](const std::string&, const std::string& typed) { return typed; });
}

Option<double> Options::number(const std::string& names, const std::string& value, const std::string& help,
                               const Quantity& quantity) {
    return declared<double>(names, value, help, [quantity](const std::string& option, const std::string& typed) {
        return cli::number(option, typed, quantity);
    });
}

Option<int> Options::whole_number(const std::string& names, const std::string& value, const std::string& help, int low,
                                  int high) {
    return declared<int>(names, value, help, [low, high](const std::string& option, const std::string& typed) {
        return cli::whole_number(option, typed, low, high);
    });
}

Option<std::vector<double>> Options::numbers(const std::string& names, const std::string& value,
                                             const std::string& help, const Quantity& quantity) {
    return declared<std::vector<double>>(names, value, help,
                                         [quantity](const std::string& option, const std::string& typed) {
                                             return cli::numbers(option, typed, quantity);
                                         });
}

Option<std::string> Options::argument(const std::string& name, const std::string& help) {
    Option<std::string> option(name);
    parser_->add(name, help, [typed = option.typed_](const std::string& text) { typed->value = text; });
    return option;
}

bool Options::read(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        if (argument.size() > 3 && argument.substr(0, 2) == "--" && argument.back() == '=') {
            throw Error(in_quotes(argument) + " gives no value; write it after the =");
        }
    }
    CLI::App& app = parser_->app;
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return false;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string what = error.what();
        const std::string option = what.substr(0, what.find(':'));
        throw Error(option + (what.find("received") != what.npos
                                  ? " is given twice; give it once"
                                  : " needs a value; see " + app.get_name() + " --help"));
    } catch (const CLI::ParseError& error) {
        throw Error(std::string(error.what()) + "; see " + app.get_name() + " --help");
    }
    const std::vector<std::string> rest = app.remaining();
    if (!rest.empty()) refuse(app, rest.front());
    for (const auto& declared : parser_->all) {
        if (declared->typed) declared->take(*declared->typed);
    }
    return true;
}

std::string Options::help() const {
    std::string text = parser_->app.help();
    for (std::size_t gap = 0; (gap = text.find("\n\n\n", gap)) != text.npos;) {
        text.erase(gap, 1);
    }
    return text;
}

}  // namespace snug::cli

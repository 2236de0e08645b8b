// The options that subcommands share: their names, their help and what they mean, each in one place.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "snug/entry.hpp"
#include "snug/fewest.hpp"

namespace snug::cli {

enum class Format { text, json, csv };

/// The options of one subcommand: declared with their help, read once, then asked for their values, which are checked
/// only then. Whatever is wrong is an Error that begins with the option.
class Options {
public:
    /// `examples` ends the help text.
    Options(const std::string& command, const std::string& purpose, const std::string& examples);

    void add(const std::string& names, const std::string& value, const std::string& help);
    void add_argument(const std::string& name, const std::string& help);
    void group(const std::string& title) { group_ = title; }

    /// False when help is wanted instead. Throws Error when an option is unknown, twice there or without a value.
    [[nodiscard]] bool read(const std::vector<std::string>& arguments);
    [[nodiscard]] std::string help() const;

    /// What was typed after an option, named as in "--car"; null when it was not given.
    [[nodiscard]] const std::string* typed(const std::string& option) const;

    [[nodiscard]] double number(const std::string& option, double otherwise, double low, double high,
                                std::string_view unit) const;
    [[nodiscard]] std::size_t choice(const std::string& option, const std::vector<std::string>& words) const;

private:
    CLI::App app_;
    std::string group_;
    std::map<std::string, std::string> typed_;
};

// Each declares its options, in a group of their own.
void add_car(Options& options);
void add_slot(Options& options);
void add_driving(Options& options);   // clearance, enter
void add_strategy(Options& options);  // strategy and its steps
void add_fewest(Options& options);    // what the search over all maneuvers is limited to
void add_output(Options& options, const std::string& formats = "text (default), json or csv.");  // format, output
void add_threads(Options& options);

// Each answers with the checked values.
Car car(const Options& options);
Slot slot(const Options& options, const Car& car);
double clearance(const Options& options);
Enter enter(const Options& options);
Strategy strategy(const Options& options);  // max-steer for --strategy fewest, which is no strategy of entry()
FewestOptions fewest_options(const Options& options);
Format format(const Options& options);
int threads(const Options& options);

/// How the command ends with that answer.
int exit_code(const Answer& answer);

/// The file of `-o`, which can be written as far as one can tell before the work; empty for standard output.
std::string output(const Options& options);

/// The catalogue's car of that name, or the car in that file. Throws Error.
Car find_or_read_car(const std::string& name_or_file);

}  // namespace snug::cli

// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/options.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <type_traits>

#include "renderer/base/error.h"
#include "renderer/base/nearest.h"

namespace obscura::app {

Option Option::required() const { return Option(*option_->required()); }
Option Option::shows_default() const { return Option(*option_->capture_default_str()); }
Option Option::type(const std::string& word) const { return Option(*option_->type_name(word)); }
Option Option::one_of(const std::vector<std::string>& words) const {
    const CLI::Validator one = CLI::IsMember(words);
    return Option(
        *option_->check(one.description(""))->type_name(fmt::format("{}", fmt::join(words, "|"))));
}
Option Option::between(std::int64_t least, std::int64_t most) const {
    const CLI::Validator range = CLI::Range(least, most);
    const std::string allowed = most == std::numeric_limits<std::int64_t>::max()
                                    ? fmt::format(" (from {})", least)
                                    : fmt::format(" ({} to {})", least, most);
    std::string what = option_->get_description();
    const std::size_t standard = what.find(" (default: ");  // the last that is said
    what.insert(standard == std::string::npos ? what.size() : standard, allowed);
    return Option(*option_->check(range.description(""))->description(what));
}
Option Option::existing_folder() const {
    return Option(*option_->check(CLI::ExistingDirectory.description(""))->type_name("FOLDER"));
}
Option Option::folder() const { return Option(*option_->type_name("FOLDER")); }
Option Option::comma_separated() const { return Option(*option_->delimiter(',')); }
Option Option::repeatable() const { return Option(*option_->allow_extra_args(false)); }
Option Option::value_optional() const { return Option(*option_->expected(0, 1)); }
Option Option::needs(const Option& other) const { return Option(*option_->needs(other.option_)); }
Option Option::excludes(const std::vector<Option>& others) const {
    for (const Option& other : others) option_->excludes(other.option_);
    return *this;
}

template <class T>
Option Options::add(const std::string& name, T& value, const std::string& what) const {
    const Option option(*app_->add_option(name, value, what));
    if constexpr (std::is_same_v<T, std::filesystem::path> ||
                  std::is_same_v<T, std::vector<std::filesystem::path>>) {
        return option.type("FILE");
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>> ||
                         std::is_same_v<T, std::vector<double>>) {
        return option.type("NUMBER");
    } else if constexpr (!std::is_same_v<T, std::string> &&
                         !std::is_same_v<T, std::vector<std::string>>) {
        return option.type("N");
    } else {
        return option.type(name.starts_with("-") ? "NAME" : "");
    }
}
template Option Options::add(const std::string&, std::string&, const std::string&) const;
template Option Options::add(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Options::add(const std::string&, std::uint64_t&, const std::string&) const;
template Option Options::add(const std::string&, int&, const std::string&) const;
template Option Options::add(const std::string&, double&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<int>&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<double>&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<std::int64_t>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::optional<std::uint64_t>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::filesystem::path>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<int>&, const std::string&) const;
template Option Options::add(const std::string&, std::vector<double>&, const std::string&) const;

Option Options::add_flag(const std::string& name, bool& value, const std::string& what) const {
    return Option(*app_->add_flag(name, value, what));
}
void Options::footer(const std::string& text) const { app_->footer(text); }
Options Options::add_command(const std::string& name, const std::string& what) const {
    return Options(*app_->add_subcommand(name, what));
}
void Options::require_command() const { app_->require_subcommand(1); }
void Options::when_given(const std::function<void()>& act) const { app_->callback(act); }

namespace {

/// What an option is for, whether it may be left out, and what is meant then: the one form in which
/// help, manual and completion say it.
std::string what_of(const CLI::Option& option) {
    std::string text = option.get_description();
    if (option.get_required()) text += " (required)";
    if (const std::string standard = option.get_default_str(); !standard.empty()) {
        text += fmt::format(" (default: {})", standard);
    }
    return text;
}

/// `--size WxH   Of the image (default: 1280x720)`
class HelpFormat : public CLI::Formatter {
  public:
    std::string make_option_opts(const CLI::Option* option) const override {
        if (option->get_type_size() == 0) return "";
        const bool several = option->get_expected_max() == CLI::detail::expected_max_vector_size;
        const std::string type = option->get_type_name();
        return (type.empty() ? "" : " " + type) + (several ? " ..." : "");
    }
    std::string make_footer(const CLI::App* app) const override {
        const std::string own = app->get_footer().empty() ? "" : app->get_footer() + "\n";
        if (app->get_parent() == nullptr) return own;
        return own + (own.empty() ? "" : "\n") +
               "Every command also takes --data, --allow and --quiet: see obscura --help.\n";
    }
    std::string make_option_desc(const CLI::Option* option) const override {
        return what_of(*option);
    }
};

}  // namespace

CommandLine::CommandLine(const std::string& what, const std::string& program,
                         std::function<std::string()> version)
    : app_(std::make_unique<CLI::App>(what, program)) {
    app_->set_version_flag("--version", std::move(version), "Version, commit and driver");
    app_->formatter(std::make_shared<HelpFormat>());
    app_->fallthrough();
}
CommandLine::~CommandLine() = default;

Options CommandLine::options() const { return Options(*app_); }

namespace {

DescribedCommand described_app(const CLI::App& app) {
    DescribedCommand command{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        DescribedOption one;
        one.by_place = option->get_positional();
        for (const std::string& name : option->get_snames()) one.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) one.names.push_back("--" + name);
        if (one.by_place) one.names = {option->get_name(true)};
        if (option->get_expected_max() > 0) one.value = option->get_type_name();
        one.what = what_of(*option);
        command.options.push_back(std::move(one));
    }
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        command.commands.push_back(described_app(*sub));
    }
    return command;
}

}  // namespace

DescribedCommand CommandLine::described() const { return described_app(*app_); }

namespace {

/// The command that the words chose, the innermost.
const CLI::App& chosen_app(const CLI::App& app) {
    const std::vector<CLI::App*> subs = app.get_subcommands();
    return subs.empty() ? app : chosen_app(*subs.back());
}

/// Options among the words that neither the command nor the program has, with what may have been
/// meant; empty where there is none.
std::string of_unknown_options(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App& chosen = chosen_app(program);
    std::vector<std::string> known;
    for (const CLI::App* app : {&chosen, &program}) {
        for (const CLI::Option* option : app->get_options()) {
            for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
        }
    }
    std::string text;
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (!name.starts_with("--") || name == "--") continue;
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        text += fmt::format("{}there is no option {}{}", text.empty() ? "" : "; ", name,
                            base::did_you_mean(name, known));
    }
    return text;
}

/// `Could not convert: --radius = 50cm` as the rest of the program would say it.
std::string in_words_of_conversion(const std::string& text) {
    const std::size_t colon = text.find(": ");
    const std::size_t equals = text.find(" = ");
    if (colon == std::string::npos || equals == std::string::npos || equals < colon) return text;
    return fmt::format("{}: \"{}\" is no number that it can take",
                       text.substr(colon + 2, equals - colon - 2), text.substr(equals + 3));
}

/// The word in the place of a command that is none, with what may have been meant; empty where
/// nothing stands there.
std::string of_unknown_command(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App& chosen = chosen_app(program);
    std::vector<std::string> known;
    for (const CLI::App* sub : chosen.get_subcommands([](const CLI::App*) { return true; })) {
        known.push_back(sub->get_name());
    }
    const auto own = std::find(words.begin(), words.end(), chosen.get_name());
    if (known.empty() || own == words.end() || own + 1 == words.end()) return "";
    const std::string& word = *(own + 1);
    if (word.starts_with("-")) return "";
    return fmt::format("{} has no command \"{}\"; it has {}{}", chosen.get_name(), word,
                       fmt::join(known, ", "), base::did_you_mean(word, known));
}

/// What the library says, as the rest of the program would.
std::string in_our_words(const CLI::App& program, const CLI::ParseError& error,
                         const std::vector<std::string>& words) {
    std::string text = error.what();
    const auto is = [&error](CLI::ExitCodes code) {
        return error.get_exit_code() == static_cast<int>(code);
    };
    const bool too_much = is(CLI::ExitCodes::ExtrasError);
    if (too_much || is(CLI::ExitCodes::RequiredError)) {
        const std::string unknown = of_unknown_options(program, words);
        if (!unknown.empty()) text = unknown;
        const std::string command = of_unknown_command(program, words);
        if (!command.empty()) text = command;
    }
    if (is(CLI::ExitCodes::ConversionError)) text = in_words_of_conversion(text);
    if (const std::size_t at = text.rfind("not expected: "); too_much && at != std::string::npos) {
        text = fmt::format("\"{}\" is one value too many", text.substr(text.rfind(' ') + 1));
    }
    const auto replace = [&](std::string_view from, std::string_view to) {
        if (const std::size_t at = text.find(from); at != std::string::npos) {
            text.replace(at, from.size(), to);
        }
    };
    replace(" is required", " is missing");
    replace("A subcommand is missing", "a command is missing");
    std::string name = program.get_name();
    for (const CLI::App* app = &program; !app->get_subcommands().empty();) {
        app = app->get_subcommands().back();
        name += " " + app->get_name();
    }
    return fmt::format("{}\nSee {} --help.", text, name);
}

}  // namespace

bool CommandLine::parse(std::vector<std::string> words) {
    const std::vector<std::string> given = words;
    std::reverse(words.begin(), words.end());
    try {
        app_->parse(std::move(words));
    } catch (const CLI::Success& asked) {
        app_->exit(asked);
        return false;
    } catch (const CLI::ParseError& error) {
        throw base::bad_input("{}", in_our_words(*app_, error, given));
    }
    return true;
}

}  // namespace obscura::app

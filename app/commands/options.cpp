// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "renderer/base/error.h"

namespace obscura::app {

Option Option::required() const { return Option(*option_->required()); }
Option Option::shows_default() const { return Option(*option_->capture_default_str()); }
Option Option::type(const std::string& word) const { return Option(*option_->type_name(word)); }
Option Option::one_of(const std::vector<std::string>& words) const {
    return Option(*option_->check(CLI::IsMember(words)));
}
Option Option::between(std::int64_t least, std::int64_t most) const {
    return Option(*option_->check(CLI::Range(least, most)));
}
Option Option::existing_folder() const { return Option(*option_->check(CLI::ExistingDirectory)); }
Option Option::comma_separated() const { return Option(*option_->delimiter(',')); }
Option Option::repeatable() const { return Option(*option_->allow_extra_args(false)); }
Option Option::needs(const Option& other) const { return Option(*option_->needs(other.option_)); }
Option Option::excludes(const std::vector<Option>& others) const {
    for (const Option& other : others) option_->excludes(other.option_);
    return *this;
}

template <class T>
Option Options::add(const std::string& name, T& value, const std::string& what) const {
    return Option(*app_->add_option(name, value, what));
}
template Option Options::add(const std::string&, std::string&, const std::string&) const;
template Option Options::add(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Options::add(const std::string&, std::uint64_t&, const std::string&) const;
template Option Options::add(const std::string&, int&, const std::string&) const;
template Option Options::add(const std::string&, double&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<int>&, const std::string&) const;
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

CommandLine::CommandLine(const std::string& what, const std::string& program,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(what, program)) {
    app_->set_version_flag("--version", version);
    app_->fallthrough();
}
CommandLine::~CommandLine() = default;

Options CommandLine::options() const { return Options(*app_); }

bool CommandLine::parse(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());
    try {
        app_->parse(std::move(words));
    } catch (const CLI::Success& asked) {
        app_->exit(asked);
        return false;
    } catch (const CLI::ParseError& error) {
        throw base::bad_input("{}\nRun with --help for more information.", error.what());
    }
    return true;
}

}  // namespace obscura::app

// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace obscura::app {

/// One option as it is described: a handle, cheap to copy.
class Option {
  public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    Option required() const;
    /// Help shows the value that it has now.
    Option shows_default() const;
    /// What stands for the value in help: FILE, N.
    Option type(const std::string& word) const;
    Option one_of(const std::vector<std::string>& words) const;
    /// Both ends included.
    Option between(std::int64_t least, std::int64_t most) const;
    Option existing_folder() const;
    /// Several values in one word, with commas between.
    Option comma_separated() const;
    /// May be given several times, one value each time.
    Option repeatable() const;
    /// Of a string: it may stand without a value, and is then empty.
    Option value_optional() const;
    Option needs(const Option& other) const;
    Option excludes(const std::vector<Option>& others) const;

  private:
    CLI::Option* option_;
};

/// The options of one command: a handle, cheap to copy. Texts are what help prints.
class Options {
  public:
    explicit Options(CLI::App& app) : app_(&app) {}

    /// A name without dashes is of a value by its place. T: a string, path, number, an optional or
    /// a vector of them, as instantiated in options.cpp. The value must live until after parsing.
    template <class T>
    Option add(const std::string& name, T& value, const std::string& what) const;
    Option add_flag(const std::string& name, bool& value, const std::string& what) const;
    void footer(const std::string& text) const;

    /// A word that has options of its own.
    Options add_command(const std::string& name, const std::string& what) const;
    void require_command() const;
    /// Called when that command was given.
    void when_given(const std::function<void()>& act) const;

  private:
    CLI::App* app_;
};

/// An option as help shows it.
struct DescribedOption {
    std::vector<std::string>
        names;  ///< with their dashes; of a value by its place as it is written
    bool by_place = false;
    std::string value;  ///< what stands for it: FILE; empty: it takes none
    std::string what;
};

/// A command as help shows it; the program itself is one.
struct DescribedCommand {
    std::string name;
    std::string what;
    std::string footer;
    std::vector<DescribedOption> options;
    std::vector<DescribedCommand> commands;
};

/// What is typed after the program's name. Only this and its handles know the library behind it,
/// whose headers take longer to compile than most commands.
class CommandLine {
  public:
    CommandLine(const std::string& what, const std::string& program, const std::string& version);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    [[nodiscard]] Options options() const;
    /// All that was added, for manuals and shells.
    [[nodiscard]] DescribedCommand described() const;
    /// False: help or the version was asked for and printed. Throws bad_input for what is not
    /// allowed.
    [[nodiscard]] bool parse(std::vector<std::string> words);

  private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace obscura::app

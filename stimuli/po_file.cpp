// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// gettext's PO form (GNU gettext manual, "The Format of PO Files"), as far as a catalogue without
// plurals uses it. Debian's libgettextpo reads files only, and this catalogue is in the program.
#include <optional>

#include "renderer/base/error.h"
#include "stimuli/words.h"

namespace obscura::stimuli {
namespace {

/// The text in quotes that a line ends with; nothing where it is none.
[[nodiscard]] std::optional<std::string> quoted(std::string_view line) {
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') return std::nullopt;
    std::string text;
    for (std::size_t at = 1; at + 1 < line.size(); ++at) {
        if (line[at] == '"') return std::nullopt;
        if (line[at] != '\\') {
            text += line[at];
            continue;
        }
        ++at;
        if (at + 1 >= line.size()) return std::nullopt;
        switch (line[at]) {
            case 'n':
                text += '\n';
                break;
            case 't':
                text += '\t';
                break;
            case '"':
            case '\\':
                text += line[at];
                break;
            default:
                return std::nullopt;
        }
    }
    return text;
}

class PoReader {
  public:
    explicit PoReader(std::string_view name) : name_(name) {}

    void take(std::string_view line) {
        ++line_;
        if (line.empty() || line.front() == '#') return;
        if (line.front() == '"') {
            if (field_ == nullptr) throw refused(line);
            *field_ += value_in(line, line);
            return;
        }
        const auto blank = line.find(' ');
        if (blank == std::string_view::npos) throw refused(line);
        const std::string_view keyword = line.substr(0, blank);
        const std::string value = value_in(line.substr(blank + 1), line);
        if (keyword == "msgctxt") {
            begin_entry(line);
            field_ = &entry_.context;
        } else if (keyword == "msgid") {
            if (field_ != &entry_.context || entry_.context.empty()) begin_entry(line);
            field_ = &entry_.source;
        } else if (keyword == "msgstr" && field_ == &entry_.source) {
            field_ = &entry_.text;
        } else {
            throw refused(line);
        }
        *field_ = value;
    }

    [[nodiscard]] std::vector<PoEntry> finish() {
        begin_entry("the end");
        return std::move(entries_);
    }

  private:
    void begin_entry(std::string_view line) {
        if (field_ != nullptr && field_ != &entry_.text) throw refused(line);
        // The header is the entry of the empty text.
        if (!entry_.context.empty()) entries_.push_back(entry_);
        entry_ = {};
        field_ = nullptr;
    }
    [[nodiscard]] std::string value_in(std::string_view text, std::string_view line) const {
        auto value = quoted(text);
        if (!value) throw refused(line);
        return std::move(*value);
    }
    [[nodiscard]] base::Error refused(std::string_view line) const {
        return base::failure(
            "{}:{}: {} is not allowed there; an entry is msgctxt, msgid and msgstr, each with a "
            "text in quotes",
            name_, line_, line);
    }

    std::string name_;
    int line_ = 0;
    PoEntry entry_;
    std::string* field_ = nullptr;  ///< of the entry, which the next quoted line goes on with
    std::vector<PoEntry> entries_;
};

}  // namespace

std::vector<PoEntry> parse_po(std::string_view text, std::string_view name) {
    PoReader reader(name);
    while (!text.empty()) {
        const auto end = text.find('\n');
        reader.take(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return reader.finish();
}

}  // namespace obscura::stimuli

// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/participant_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;
using Problems = std::vector<StudyProblem>;

constexpr std::string_view kBlank = " \t\n";
constexpr double kFarthest = 1e15;  // doubles are whole numbers up to there
constexpr std::size_t kMostChoices = 30;
constexpr std::size_t kMostFields = 40;
constexpr std::size_t kMostItems = 20;

bool is_blank(std::string_view text) {
    return text.find_first_not_of(kBlank) == std::string_view::npos;
}

/// A text for a word of the kiosk: its placeholders are those of the English, if any.
void check_word(TableReader& reader, const std::string& key, const std::string& text) {
    const auto allowed = placeholders_of(catalogue_words("en").at(key));
    for (const std::string& name : placeholders_of(text)) {
        if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
        reader.add(key, fmt::format("has {{{}}}, allowed in braces are {}", name, listed(allowed)));
    }
    if (is_blank(text)) reader.add(key, "is empty, allowed is a text");
}

/// Texts of an array; none where it is missing or wrong.
std::vector<std::string> read_texts(TableReader& reader, const std::string& where,
                                    const std::string& key, Need need, std::size_t least,
                                    std::size_t most, Study& study) {
    const std::string wanted = fmt::format("an array of {} to {} different texts", least, most);
    const toml::array* array = reader.array(key, need, wanted);
    if (array == nullptr) return {};
    std::vector<std::string> texts;
    for (const toml::node& node : *array) {
        const auto text = node.value<std::string>();
        if (!text || is_blank(*text)) continue;
        texts.push_back(*text);
        study.shown_texts.push_back({where + ": " + key, line_of(node), *text});
    }
    const std::set<std::string> different(texts.begin(), texts.end());
    if (different.size() != array->size() || texts.size() < least || texts.size() > most) {
        reader.add(key, fmt::format("allowed is {}", wanted));
        return {};
    }
    return texts;
}

void read_range(TableReader& reader, FormField& field) {
    if (field.kind == FieldKind::kScale) {
        const auto low = reader.integer("min", Need::kRequired, -100, 100);
        const auto high = reader.integer("max", Need::kRequired, -100, 100);
        if (low && high && (*high <= *low || *high - *low >= kLongestScale)) {
            reader.add("max", fmt::format("{} makes a scale of {} steps from {}, allowed are 2 to "
                                          "{} steps",
                                          *high, *high - *low + 1, *low, kLongestScale));
            return;
        }
        if (low) field.min = static_cast<double>(*low);
        if (high) field.max = static_cast<double>(*high);
        return;
    }
    field.min = reader.number("min", Need::kOptional, -kFarthest, kFarthest);
    field.max = reader.number("max", Need::kOptional, -kFarthest, kFarthest);
    if (field.min && field.max && *field.max <= *field.min) {
        reader.add("max", fmt::format("{} is not above min, which is {}", *field.max, *field.min));
    }
}

void read_kind_of_field(TableReader& reader, const std::string& where, FormField& field,
                        Study& study) {
    switch (field.kind) {
        case FieldKind::kNumber:
            read_range(reader, field);
            field.unit = reader.text("unit", Need::kOptional).value_or("");
            if (!field.unit.empty()) {
                const int line = line_of(*reader.table().get("unit"));
                study.shown_texts.push_back({where + ": unit", line, field.unit});
            }
            break;
        case FieldKind::kScale:
            read_range(reader, field);
            field.labels = read_texts(reader, where, "labels", Need::kOptional, 2, 2, study);
            break;
        case FieldKind::kChoice:
        case FieldKind::kChoices: {
            const std::size_t least = field.kind == FieldKind::kChoice ? 2 : 1;
            field.choices =
                read_texts(reader, where, "choices", Need::kRequired, least, kMostChoices, study);
            break;
        }
        case FieldKind::kCode:
            field.generate = reader.boolean("generate", Need::kOptional).value_or(false);
            break;
        case FieldKind::kText:
            break;
    }
}

FormField read_field(TableReader& reader, const std::string& where, Study& study) {
    FormField field;
    field.id = reader.safe_id("column");
    const auto kind = reader.choice("kind", Need::kRequired, names_of(kFieldKinds));
    for (const FieldKind known : kFieldKinds) {
        if (kind && to_string(known) == *kind) field.kind = known;
    }
    field.label = read_shown_text(reader, where, "label", Need::kRequired, study);
    field.required = reader.boolean("required", Need::kOptional).value_or(false);
    for (const char* key : {"min", "max"}) reader.known_elsewhere(key, "number and scale");
    reader.known_elsewhere("unit", "number");
    reader.known_elsewhere("choices", "choice and choices");
    reader.known_elsewhere("labels", "scale");
    reader.known_elsewhere("generate", "code");
    if (kind) {
        read_kind_of_field(reader, where, field, study);
        reader.finish();
    }
    return field;
}

}  // namespace

std::string_view to_string(FieldKind kind) {
    switch (kind) {
        case FieldKind::kText:
            return "text";
        case FieldKind::kNumber:
            return "number";
        case FieldKind::kChoice:
            return "choice";
        case FieldKind::kChoices:
            return "choices";
        case FieldKind::kScale:
            return "scale";
        case FieldKind::kCode:
            return "code";
    }
    return "";
}

std::string read_shown_text(TableReader& reader, const std::string& where, const std::string& key,
                            Need need, Study& study) {
    const std::optional<std::string> text = reader.text(key, need);
    if (!text) return "";
    study.shown_texts.push_back({where + ": " + key, line_of(*reader.table().get(key)), *text});
    if (is_blank(*text)) reader.add(key, "is empty, allowed is a text");
    return *text;
}

void read_words(TableReader& study_table, const toml::table* texts, Study& study,
                Problems& problems) {
    std::string language = "en";
    if (const auto given = study_table.text("language", Need::kOptional)) {
        if (is_language(*given)) {
            language = *given;
        } else {
            study_table.add("language",
                            fmt::format("{} is no language, allowed is a tag of BCP 47: en, de-AT",
                                        in_quotes(*given)));
        }
    }
    Words::Texts own;
    if (texts != nullptr) {
        TableReader reader(*texts, "texts", problems);
        for (const auto& [key, english] : catalogue_words("en")) {
            const auto text = reader.text(key, Need::kOptional);
            if (!text) continue;
            check_word(reader, key, *text);
            own[key] = *text;
            study.shown_texts.push_back({"texts: " + key, line_of(*texts->get(key)), *text});
        }
        reader.finish();
    }
    study.words = Words(language, own);
}

void read_information(const toml::table& table, Study& study, Problems& problems) {
    TableReader reader(table, "information", problems);
    study.information = read_shown_text(reader, "information", "text", Need::kRequired, study);
    reader.finish();
}

void read_consent(const toml::table& table, Study& study, Problems& problems) {
    TableReader reader(table, "consent", problems);
    Consent consent;
    consent.version = reader.text("version", Need::kRequired).value_or("");
    if (reader.has("version") && is_blank(consent.version)) {
        reader.add("version", "is empty, allowed is a text");
    }
    consent.text = read_shown_text(reader, "consent", "text", Need::kOptional, study);
    consent.items = read_texts(reader, "consent", "items", Need::kRequired, 1, kMostItems, study);
    reader.finish();
    study.consent = std::move(consent);
}

void read_form(const toml::table& table, Study& study, Problems& problems) {
    TableReader reader(table, "form", problems);
    const std::string wanted =
        fmt::format("1 to {} tables, each begun with [[form.field]]", kMostFields);
    const toml::array* fields = reader.array("field", Need::kRequired, wanted);
    reader.finish();
    if (fields == nullptr) return;
    std::set<std::string> seen;
    bool has_code = false;
    for (const toml::node& node : *fields) {
        const toml::table* entry = node.as_table();
        if (entry == nullptr) continue;
        const auto id = (*entry)["id"].value<std::string>();
        const std::string where = id ? fmt::format("form.field {}", in_quotes(*id))
                                     : fmt::format("form.field {}", study.form.size() + 1);
        TableReader field_reader(*entry, where, problems);
        study.form.push_back(read_field(field_reader, where, study));
        const FormField& field = study.form.back();
        if (!field.id.empty() && !seen.insert(field.id).second) {
            field_reader.add(
                "id", fmt::format("{} is used twice, each must be another", in_quotes(field.id)));
        }
        if (field.kind == FieldKind::kCode && std::exchange(has_code, true)) {
            field_reader.add("kind", "\"code\" is used twice, a participant has one code");
        }
    }
    if (study.form.size() != fields->size() || fields->empty() || fields->size() > kMostFields) {
        reader.add("field", fmt::format("allowed are {}", wanted));
    }
}

}  // namespace obscura::stimuli

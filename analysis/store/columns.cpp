// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/columns.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

base::Error unknown_word(std::string_view what, std::string_view met) {
    return base::failure("the store holds the unknown {} '{}'", what, met);
}

template <typename T>
base::Error unknown_number(T met) {
    return base::failure("the store holds the number {}, which none of its values can be", met);
}

/// How a member's type lies in a cell.
template <typename T>
struct Codec;

template <>
struct Codec<std::string> {
    static constexpr CellType kType = CellType::kText;
    static void to(const std::string& value, Cell& cell) { cell.text = value; }
    static void from(std::string& value, const Cell& cell) { value = cell.text; }
};

/// Nothing that is measured is below 0.
template <>
struct Codec<double> {
    static constexpr CellType kType = CellType::kReal;
    static void to(double value, Cell& cell) { cell.real = value; }
    static void from(double& value, const Cell& cell) {
        if (!(cell.real >= 0 && std::isfinite(cell.real))) throw unknown_number(cell.real);
        value = cell.real;
    }
};

/// int, bool and std::uint64_t, none of which is below 0; the last fits because the store refuses
/// values above 2^63 - 1.
template <typename T>
struct IntegerCodec {
    static constexpr CellType kType = CellType::kInteger;
    static void to(T value, Cell& cell) { cell.integer = static_cast<long long>(value); }
    static void from(T& value, const Cell& cell) {
        const bool fits = cell.integer >= 0 && static_cast<unsigned long long>(cell.integer) <=
                                                   std::numeric_limits<T>::max();
        if (!fits) throw unknown_number(cell.integer);
        value = static_cast<T>(cell.integer);
    }
};
template <>
struct Codec<int> : IntegerCodec<int> {};
template <>
struct Codec<bool> : IntegerCodec<bool> {};
template <>
struct Codec<std::uint64_t> : IntegerCodec<std::uint64_t> {};

template <>
struct Codec<char> {
    static constexpr CellType kType = CellType::kText;
    static void to(char value, Cell& cell) { cell.text.assign(1, value); }
    static void from(char& value, const Cell& cell) {
        if (cell.text != "A" && cell.text != "B") throw unknown_word("side", cell.text);
        value = cell.text.front();
    }
};

template <>
struct Codec<Kind> {
    static constexpr CellType kType = CellType::kText;
    static void to(Kind value, Cell& cell) { cell.text = to_string(value); }
    static void from(Kind& value, const Cell& cell) {
        const auto kind = kind_from(cell.text);
        if (!kind) throw unknown_word("kind", cell.text);
        value = *kind;
    }
};

template <>
struct Codec<SessionState> {
    static constexpr CellType kType = CellType::kText;
    static void to(SessionState value, Cell& cell) { cell.text = to_string(value); }
    static void from(SessionState& value, const Cell& cell) {
        const auto state = session_state_from(cell.text);
        if (!state) throw unknown_word("session state", cell.text);
        value = *state;
    }
};

template <typename T>
struct Codec<std::optional<T>> {
    static constexpr CellType kType = Codec<T>::kType;
    static void to(const std::optional<T>& value, Cell& cell) {
        cell.indicator = value ? soci::i_ok : soci::i_null;
        if (value) Codec<T>::to(*value, cell);
    }
    static void from(std::optional<T>& value, const Cell& cell) {
        value.reset();
        if (cell.indicator == soci::i_ok) Codec<T>::from(value.emplace(), cell);
    }
};

/// Text whose empty value is NULL in the database.
struct TextOrNull {
    static constexpr CellType kType = CellType::kText;
    static void to(const std::string& value, Cell& cell) {
        cell.indicator = value.empty() ? soci::i_null : soci::i_ok;
        cell.text = value;
    }
    static void from(std::string& value, const Cell& cell) {
        value = cell.indicator == soci::i_ok ? cell.text : std::string();
    }
};

/// A level of ecological validity.
struct Level : Codec<std::string> {
    static void from(std::string& value, const Cell& cell) {
        if (cell.text != "low" && cell.text != "moderate" && cell.text != "high") {
            throw unknown_word("level of validity", cell.text);
        }
        value = cell.text;
    }
};

/// A letter that may be missing: 0, or NULL in the database.
struct LetterOrNull {
    static constexpr CellType kType = CellType::kText;
    static void to(char value, Cell& cell) {
        cell.indicator = value == '\0' ? soci::i_null : soci::i_ok;
        Codec<char>::to(value, cell);
    }
    static void from(char& value, const Cell& cell) {
        value = '\0';
        if (cell.indicator == soci::i_ok) Codec<char>::from(value, cell);
    }
};

template <typename Member>
struct MemberTraits;
template <typename R, typename T>
struct MemberTraits<T R::*> {
    using Record = R;
    using Type = T;
};

template <auto kMember,
          typename MemberCodec = Codec<typename MemberTraits<decltype(kMember)>::Type>>
constexpr auto column(const char* name) {
    using Record = typename MemberTraits<decltype(kMember)>::Record;
    return Column<Record>{
        name, MemberCodec::kType,
        [](const Record& record, Cell& cell) { MemberCodec::to(record.*kMember, cell); },
        [](Record& record, const Cell& cell) { MemberCodec::from(record.*kMember, cell); }};
}

}  // namespace

const RecordTable<ParticipantRecord>& participants_table() {
    using R = ParticipantRecord;
    static const RecordTable<R> table{
        "participants",
        {column<&R::participant_id>("participant_id"), column<&R::kind>("kind"),
         column<&R::age_years>("age_years"), column<&R::gender>("gender"),
         column<&R::normal_vision>("normal_vision"), column<&R::naive>("naive"),
         column<&R::consent>("consent"), column<&R::created_utc>("created_utc"),
         column<&R::code, TextOrNull>("code"),
         column<&R::consent_version, TextOrNull>("consent_version"),
         column<&R::consent_items, TextOrNull>("consent_items"),
         column<&R::consent_utc, TextOrNull>("consent_utc"), column<&R::form, TextOrNull>("form")}};
    return table;
}

const RecordTable<SessionRecord>& sessions_table() {
    using R = SessionRecord;
    static const RecordTable<R> table{"sessions",
                                      {column<&R::session_id>("session_id"),
                                       column<&R::participant_id>("participant_id"),
                                       column<&R::kind>("kind"),
                                       column<&R::study>("study"),
                                       column<&R::study_sha256>("study_sha256"),
                                       column<&R::order>("order_kind"),
                                       column<&R::seed>("seed"),
                                       column<&R::slot>("slot"),
                                       column<&R::latin_square>("latin_square"),
                                       column<&R::latin_row>("latin_row"),
                                       column<&R::swapped>("swapped"),
                                       column<&R::condition_count>("condition_count"),
                                       column<&R::state>("state"),
                                       column<&R::started_utc>("started_utc"),
                                       column<&R::ended_utc, TextOrNull>("ended_utc"),
                                       column<&R::software>("software"),
                                       column<&R::operating_system>("operating_system"),
                                       column<&R::gpu_renderer>("gpu_renderer"),
                                       column<&R::display>("display"),
                                       column<&R::refresh_hz>("refresh_hz"),
                                       column<&R::exclusion, TextOrNull>("exclusion"),
                                       column<&R::study_plan, TextOrNull>("study_plan"),
                                       column<&R::timing, TextOrNull>("timing"),
                                       column<&R::slot_copy>("slot_copy")}};
    return table;
}

const RecordTable<TrialRecord>& trials_table() {
    using R = TrialRecord;
    static const RecordTable<R> table{"trials",
                                      {column<&R::session_id>("session_id"),
                                       column<&R::kind>("kind"),
                                       column<&R::trial_index>("trial_index"),
                                       column<&R::condition>("condition"),
                                       column<&R::hypothesis>("hypothesis"),
                                       column<&R::scene>("scene"),
                                       column<&R::validity, Level>("validity"),
                                       column<&R::condition_A>("condition_A"),
                                       column<&R::condition_B>("condition_B"),
                                       column<&R::first_shown>("first_shown"),
                                       column<&R::response_first>("response_first"),
                                       column<&R::is_A_selected>("is_A_selected"),
                                       column<&R::response_time_s>("response_time_s"),
                                       column<&R::first_onset_s>("first_onset_s"),
                                       column<&R::second_onset_s>("second_onset_s"),
                                       column<&R::question_onset_s>("question_onset_s"),
                                       column<&R::first_view_ms>("first_view_ms"),
                                       column<&R::second_view_ms>("second_view_ms"),
                                       column<&R::grey_ms_measured>("grey_ms_measured"),
                                       column<&R::dropped_frames>("dropped_frames"),
                                       column<&R::hidden_ms>("hidden_ms"),
                                       column<&R::first_sha256>("first_sha256"),
                                       column<&R::second_sha256>("second_sha256"),
                                       column<&R::answered_utc>("answered_utc"),
                                       column<&R::expected, LetterOrNull>("expected"),
                                       column<&R::repeats, TextOrNull>("repeats"),
                                       column<&R::override_reason, TextOrNull>("override_reason")}};
    return table;
}

const RecordTable<EventRecord>& events_table() {
    using R = EventRecord;
    static const RecordTable<R> table{
        "events",
        {column<&R::session_id, TextOrNull>("session_id"), column<&R::time_utc>("time_utc"),
         column<&R::name>("name"), column<&R::detail>("detail")}};
    return table;
}

}  // namespace obscura::analysis

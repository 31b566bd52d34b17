// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/model_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "analysis/conclusions/participants.h"
#include "analysis/conclusions/words.h"
#include "analysis/statistics/mixed_logistic.h"

namespace obscura::analysis {
namespace {

/// One condition's answers in the model: its terms, and whether A counts as B.
struct ModelledCondition {
    std::vector<std::pair<std::size_t, double>> x;
    bool is_turned = false;
};

/// What is fitted: conditions by their place in Tally::conditions, and the number of their terms.
/// The order's term comes after them.
struct Design {
    std::map<std::uint32_t, ModelledCondition> conditions;
    std::size_t terms = 0;
    bool has_effect = true;  ///< term 0 is the effect that is tested
    /// The terms, from the first, without those whose likelihood ratio says whether conditions or
    /// levels differ.
    std::size_t nested = 0;
};

/// The answers to the design's conditions, participants who answered alike together.
class ModelAnswers {
  public:
    ModelAnswers(const Tally& tally, const VotesByParticipant& votes, const Design& design)
        : knows_order_(tally.order.has_value()), terms_(design.terms) {
        std::map<std::string, std::size_t> places;
        bool first = false;
        bool second = false;
        for (std::size_t who = 0; who < votes.participants(); ++who) {
            std::string key;
            for (const auto& vote : votes.of(who)) {
                if (!design.conditions.contains(vote.condition)) continue;
                const Answer& answer = votes.answer(vote);
                key += fmt::format("{}{}{};", vote.condition, answer.chose_b ? 'B' : 'A',
                                   knows_order_ && answer.b_second ? '2' : '1');
            }
            if (key.empty()) continue;
            ++participants_;
            answers_ += std::count(key.begin(), key.end(), ';');
            const auto [entry, is_new] = places.emplace(key, data_.size());
            if (!is_new) {
                ++data_[entry->second].participants;
                continue;
            }
            MixedParticipants& alike = data_.emplace_back();
            for (const auto& vote : votes.of(who)) {
                const auto condition = design.conditions.find(vote.condition);
                if (condition == design.conditions.end()) continue;
                const Answer& answer = votes.answer(vote);
                const bool turned = condition->second.is_turned;
                const bool second_is_b = answer.b_second != turned;
                (second_is_b ? second : first) = true;
                MixedAnswers& row = alike.answers.emplace_back();
                row.x = condition->second.x;
                row.x.emplace_back(terms_, second_is_b ? 1.0 : -1.0);
                ++(answer.chose_b != turned ? row.votes.b : row.votes.a);
            }
        }
        has_order_ = knows_order_ && first && second;
        if (has_order_) return;
        for (MixedParticipants& alike : data_) {
            for (MixedAnswers& row : alike.answers) row.x.pop_back();
        }
    }

    [[nodiscard]] std::int64_t participants() const { return participants_; }
    [[nodiscard]] std::int64_t answers() const { return answers_; }
    [[nodiscard]] bool has_order() const { return has_order_; }
    [[nodiscard]] std::size_t predictors() const { return terms_ + (has_order_ ? 1 : 0); }
    [[nodiscard]] const std::vector<MixedParticipants>& data() const { return data_; }

    /// The same without the terms from `first` to before the order's.
    [[nodiscard]] std::vector<MixedParticipants> without_terms_from(std::size_t first) const {
        std::vector<MixedParticipants> fewer = data_;
        for (MixedParticipants& alike : fewer) {
            for (MixedAnswers& row : alike.answers) {
                std::erase_if(row.x, [&](const auto& term) {
                    return term.first >= first && term.first < terms_;
                });
                for (auto& [place, x] : row.x) {
                    if (place == terms_) place = first;
                }
            }
        }
        return fewer;
    }

  private:
    bool knows_order_;
    std::size_t terms_;
    bool has_order_ = false;
    std::int64_t participants_ = 0;
    std::int64_t answers_ = 0;
    std::vector<MixedParticipants> data_;
};

ModelTerm term_of(const MixedLogistic& fit, std::size_t place) {
    ModelTerm term;
    term.log_odds = fit.coefficients[place];
    term.standard_error = std::sqrt(fit.covariance[place * fit.coefficients.size() + place]);
    const double z = term.log_odds / term.standard_error;
    term.p = chi_square_tail(z * z, 1);
    constexpr double kNormal95 = 1.959963984540054;
    term.interval = {term.log_odds - kNormal95 * term.standard_error,
                     term.log_odds + kNormal95 * term.standard_error};
    return term;
}

Possible<ModelCheck> checked(const ModelAnswers& answered, const Design& design) {
    const auto& [conditions, terms, has_effect, nested] = design;
    using None = Possible<ModelCheck>;
    if (answered.predictors() > kMostPredictors) {
        return None::none(fmt::format("more than {} terms", kMostPredictors));
    }
    const auto fit = mixed_logistic(answered.data(), answered.predictors());
    if (!fit.has_value()) return None::none(fit.reason);
    ModelCheck check;
    check.participants = answered.participants();
    check.nodes = kMixedNodes;
    check.sd = fit->sd;
    if (has_effect) check.effect = term_of(*fit, 0);
    if (answered.has_order()) {
        check.order = term_of(*fit, terms);
    } else {
        check.order =
            Possible<ModelTerm>::none("the order of showing is not known or never varied");
    }
    if (nested == terms) return check;
    const auto simpler = mixed_logistic(answered.without_terms_from(nested),
                                        answered.predictors() - (terms - nested));
    if (!simpler.has_value()) {
        check.conditions_differ = Possible<NestedTest>::none(simpler.reason);
        return check;
    }
    const int df = static_cast<int>(terms - nested);
    if (answered.answers() - answered.participants() - df < 1) {
        check.conditions_differ =
            Possible<NestedTest>::none("too few answers of each participant for the terms");
        return check;
    }
    check.conditions_differ =
        nested_test(std::max(0.0, 2.0 * (fit->log_likelihood - simpler->log_likelihood)), df,
                    answered.answers(), answered.participants());
    return check;
}

using Places = std::map<std::string_view, std::uint32_t>;

/// The mean of the conditions' log odds, and how each but the last differs from it.
Design design_of(const HypothesisResult& result, const Places& places) {
    Design design;
    const std::size_t conditions = result.conditions.size();
    design.terms = conditions;
    design.nested = 1;
    for (std::size_t i = 0; i < conditions; ++i) {
        ModelledCondition& own = design.conditions[places.at(result.conditions[i])];
        own.is_turned = result.pooling->turned[i];
        own.x.emplace_back(0, 1.0);
        for (std::size_t term = 1; term < conditions; ++term) {
            if (i + 1 == conditions) {
                own.x.emplace_back(term, -1.0);
            } else if (i + 1 == term) {
                own.x.emplace_back(term, 1.0);
            }
        }
    }
    return design;
}

/// The difference between two levels, or those between more, and a term for each scene.
Design design_of(const Comparison& comparison, const Analysis& analysis, const Places& places) {
    Design design;
    std::vector<std::string_view> views;
    for (std::size_t i = 0; i < comparison.conditions.size(); ++i) {
        const std::uint32_t place = places.at(comparison.conditions[i]);
        const ConditionVotes& condition = analysis.conditions[place].condition;
        const auto known = std::find(views.begin(), views.end(), condition.view);
        const auto view = static_cast<std::size_t>(known - views.begin());
        if (known == views.end()) views.push_back(condition.view);
        ModelledCondition& own = design.conditions[place];
        own.is_turned = comparison.turned[i];
        own.x.emplace_back(view, 1.0);
    }
    const std::size_t levels = comparison.levels.size();
    design.has_effect = levels == 2;
    design.terms = views.size() + levels - 1;
    design.nested = design.has_effect ? design.terms : views.size();
    for (std::size_t i = 0; i < comparison.conditions.size(); ++i) {
        const std::uint32_t place = places.at(comparison.conditions[i]);
        auto& x = design.conditions[place].x;
        const auto level =
            static_cast<std::size_t>(std::find(comparison.levels.begin(), comparison.levels.end(),
                                               analysis.conditions[place].condition.validity) -
                                     comparison.levels.begin());
        if (design.has_effect) {
            x.front().first += 1;
            x.emplace(x.begin(), 0, level == 0 ? -.5 : .5);
        } else if (level > 0) {
            x.emplace_back(views.size() + level - 1, 1.0);
        }
    }
    return design;
}

}  // namespace

void check_by_model(Analysis& analysis) {
    const Tally& tally = analysis.tally;
    const VotesByParticipant votes(tally);
    Places places;
    for (std::size_t i = 0; i < analysis.conditions.size(); ++i) {
        places.emplace(analysis.conditions[i].condition.id, static_cast<std::uint32_t>(i));
    }
    for (HypothesisResult& result : analysis.hypotheses) {
        if (!result.pooling.has_value()) {
            result.model = Possible<ModelCheck>::none(result.pooling.reason);
            continue;
        }
        const Design design = design_of(result, places);
        result.model = checked(ModelAnswers(tally, votes, design), design);
    }
    if (!analysis.validity.has_value()) return;
    for (Comparison& comparison : analysis.validity.value->by_level) {
        const Design design = design_of(comparison, analysis, places);
        comparison.model = checked(ModelAnswers(tally, votes, design), design);
    }
}

std::string model_words(const Possible<ModelCheck>& model, const Possible<PValue>& tested) {
    if (!model.has_value()) return fmt::format("no model: {}", model.reason);
    std::vector<std::string> parts;
    if (model->effect.has_value()) {
        const ModelTerm& effect = *model->effect;
        parts.push_back(fmt::format(
            "log odds {:+.3f}, standard error {:.3f}, 95 % interval {:+.3f} to {:+.3f}, {}",
            effect.log_odds, effect.standard_error, effect.interval.low, effect.interval.high,
            p_words(effect.p)));
    }
    parts.push_back(fmt::format("standard deviation between participants {:.3f}", model->sd));
    if (model->order.has_value()) {
        parts.push_back(fmt::format("order term {:+.3f} (standard error {:.3f})",
                                    model->order->log_odds, model->order->standard_error));
    }
    if (model->conditions_differ.has_value()) {
        const NestedTest& test = *model->conditions_differ;
        parts.push_back(fmt::format("{} differ: likelihood ratio {:.3f}, df {} and {}, {}",
                                    model->effect.has_value() ? "conditions" : "levels",
                                    test.statistic, test.df, test.error_df, p_words(test.p)));
    }
    const std::string text = fmt::format("{}", fmt::join(parts, "; "));
    const auto p = p_of(*model);
    if (!tested.has_value() || !p.has_value()) return text;
    const bool agree = (p->p < kSignificance) == (tested->p < kSignificance);
    return text + (agree ? fmt::format(". Like the test, it is {} {:g}",
                                       p->p < kSignificance ? "below" : "above", kSignificance)
                         : fmt::format(". It parts from the test ({}), on which the verdict rests",
                                       p_words(*tested)));
}

}  // namespace obscura::analysis

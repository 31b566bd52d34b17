// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/mixed_logistic.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/statistics/check_votes.h"
#include "analysis/statistics/logistic.h"
#include "renderer/base/check.h"

namespace obscura::analysis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The nodes of Gauss and Hermite, for the weight exp(-z^2), and the logarithms of weight exp(z^2).
struct HermiteRule {
    std::vector<double> nodes, log_weights;

    /// G. H. Golub and J. H. Welsch 1969.
    explicit HermiteRule(int count) {
        MatrixXd jacobi = MatrixXd::Zero(count, count);
        for (int i = 1; i < count; ++i) jacobi(i, i - 1) = jacobi(i - 1, i) = std::sqrt(i / 2.0);
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(jacobi);
        for (int i = 0; i < count; ++i) {
            const double node = solved.eigenvalues()(i);
            const double first = solved.eigenvectors()(0, i);
            nodes.push_back(node);
            log_weights.push_back(std::log(std::numbers::pi) / 2.0 +
                                  2.0 * std::log(std::abs(first)) + node * node);
        }
    }
};

/// Answers of one participant, with what does not depend on his intercept.
struct FixedPart {
    const MixedAnswers* answers;
    double n, b, linear;
};

std::vector<FixedPart> fixed_of(const MixedParticipants& alike, const VectorXd& at) {
    std::vector<FixedPart> all;
    all.reserve(alike.answers.size());
    for (const MixedAnswers& answers : alike.answers) {
        double linear = 0.0;
        for (const auto& [place, x] : answers.x) linear += x * at(static_cast<Eigen::Index>(place));
        all.push_back({&answers, static_cast<double>(answers.votes.n()),
                       static_cast<double>(answers.votes.b), linear});
    }
    return all;
}

/// log of the votes' probability times the density of u, without constants.
double log_joint(const std::vector<FixedPart>& fixed, double sd, double u) {
    double sum = -u * u / 2.0;
    for (const FixedPart& own : fixed) {
        const double linear = own.linear + sd * u;
        sum += own.b * linear - own.n * log1p_exp(linear);
    }
    return sum;
}

/// Where that is largest, and how wide it is there.
struct Peak {
    double place = 0.0;
    double width = 1.0;
};

Peak peak_of(const std::vector<FixedPart>& fixed, double sd) {
    constexpr int kMostSteps = 100;
    Peak peak;
    for (int i = 0; i < kMostSteps; ++i) {
        double slope = -peak.place;
        double bend = 1.0;
        for (const FixedPart& own : fixed) {
            const double share = logistic(own.linear + sd * peak.place);
            slope += sd * (own.b - own.n * share);
            bend += sd * sd * own.n * share * (1.0 - share);
        }
        peak.width = 1.0 / std::sqrt(bend);
        const double step = slope / bend;
        peak.place += std::clamp(step, -2.0, 2.0);
        if (std::abs(step) < 1e-10) break;
    }
    return peak;
}

/// The log likelihood with its derivatives by the coefficients and, last, the deviation.
struct LikelihoodPoint {
    double value = 0.0;
    VectorXd gradient;
    MatrixXd hessian;
};

class MixedModel {
  public:
    MixedModel(const std::vector<MixedParticipants>& data, std::size_t predictors, int nodes)
        : data_(data), size_(static_cast<Eigen::Index>(predictors)), rule_(nodes) {
        for (const MixedParticipants& alike : data) {
            for (const MixedAnswers& answers : alike.answers) {
                const auto n = static_cast<double>(answers.votes.n());
                const auto b = static_cast<double>(answers.votes.b);
                constant_ +=
                    static_cast<double>(alike.participants) *
                    (std::lgamma(n + 1.0) - std::lgamma(b + 1.0) - std::lgamma(n - b + 1.0));
            }
        }
    }

    [[nodiscard]] double value(const VectorXd& at) const {
        double sum = constant_;
        std::vector<double> logs;
        for (const MixedParticipants& alike : data_) {
            const std::vector<FixedPart> fixed = fixed_of(alike, at);
            const Peak peak = peak_of(fixed, at(size_));
            sum += static_cast<double>(alike.participants) * integral(fixed, at(size_), peak, logs);
        }
        return sum;
    }

    [[nodiscard]] LikelihoodPoint derivatives(const VectorXd& at) const {
        LikelihoodPoint point{constant_, VectorXd::Zero(size_ + 1),
                              MatrixXd::Zero(size_ + 1, size_ + 1)};
        std::vector<double> logs;
        VectorXd mean(size_ + 1);
        VectorXd own(size_ + 1);
        for (const MixedParticipants& alike : data_) {
            const auto participants = static_cast<double>(alike.participants);
            const double sd = at(size_);
            const std::vector<FixedPart> fixed = fixed_of(alike, at);
            const Peak peak = peak_of(fixed, sd);
            const double integrated = integral(fixed, sd, peak, logs);
            point.value += participants * integrated;
            mean.setZero();
            for (std::size_t k = 0; k < logs.size(); ++k) {
                const double u = node(peak, k);
                const double weight = std::exp(logs[k] - integrated);
                own.setZero();
                for (const FixedPart& answer : fixed) {
                    add(answer, u, sd, participants * weight, own, point.hessian);
                }
                mean += weight * own;
                point.hessian.noalias() += participants * weight * own * own.transpose();
            }
            point.gradient += participants * mean;
            point.hessian.noalias() -= participants * mean * mean.transpose();
        }
        return point;
    }

  private:
    [[nodiscard]] double node(const Peak& peak, std::size_t k) const {
        return peak.place + std::numbers::sqrt2 * peak.width * rule_.nodes[k];
    }

    /// log of the participant's likelihood; `logs`: of what each node adds to it.
    double integral(const std::vector<FixedPart>& fixed, double sd, const Peak& peak,
                    std::vector<double>& logs) const {
        logs.clear();
        for (std::size_t k = 0; k < rule_.nodes.size(); ++k) {
            logs.push_back(rule_.log_weights[k] + log_joint(fixed, sd, node(peak, k)) +
                           std::log(peak.width) - std::log(std::numbers::pi) / 2.0);
        }
        const double highest = *std::max_element(logs.begin(), logs.end());
        double sum = 0.0;
        for (const double log : logs) sum += std::exp(log - highest);
        return highest + std::log(sum);
    }

    /// First derivatives of the votes' log probability, and `weight` times the second ones.
    void add(const FixedPart& answer, double u, double sd, double weight, VectorXd& first,
             MatrixXd& second) const {
        const double share = logistic(answer.linear + sd * u);
        const double off = answer.b - answer.n * share;
        const double bend = weight * answer.n * share * (1.0 - share);
        first(size_) += off * u;
        second(size_, size_) -= bend * u * u;
        for (const auto& [place, x] : answer.answers->x) {
            const auto row = static_cast<Eigen::Index>(place);
            first(row) += off * x;
            second(row, size_) -= bend * x * u;
            second(size_, row) -= bend * x * u;
            for (const auto& [other, other_x] : answer.answers->x) {
                second(row, static_cast<Eigen::Index>(other)) -= bend * x * other_x;
            }
        }
    }

    const std::vector<MixedParticipants>& data_;
    Eigen::Index size_;
    HermiteRule rule_;
    double constant_ = 0.0;
};

void check_data(const std::vector<MixedParticipants>& data, std::size_t predictors) {
    base::check_range("mixed_logistic", "number of predictors", predictors, std::size_t{1},
                      kMostPredictors);
    for (const MixedParticipants& alike : data) {
        for (const MixedAnswers& answers : alike.answers) {
            check_votes("mixed_logistic", answers.votes);
            for (const auto& [place, x] : answers.x) {
                base::check_range("mixed_logistic", "predictor", place, std::size_t{0},
                                  predictors - 1);
                if (!std::isfinite(x)) {
                    throw base::bad_input("mixed_logistic: x is {}, allowed is a finite number", x);
                }
            }
        }
    }
}

/// A step uphill: Newton's, with as much added to the diagonal as makes it one.
VectorXd step_of(const LikelihoodPoint& point) {
    const MatrixXd bend = -point.hessian;
    const double unit = std::max(1e-8, bend.diagonal().cwiseAbs().maxCoeff());
    for (double added = 0.0; added < 1e6; added = added == 0.0 ? 1e-6 : 10.0 * added) {
        const MatrixXd damped = bend + added * unit * MatrixXd::Identity(bend.rows(), bend.cols());
        const Eigen::LLT<MatrixXd> factors(damped);
        if (factors.info() == Eigen::Success) return factors.solve(point.gradient);
    }
    return VectorXd::Zero(point.gradient.size());
}

Possible<MixedLogistic> fit_at(const LikelihoodPoint& point, const VectorXd& at) {
    const auto size = static_cast<std::size_t>(at.size() - 1);
    MixedLogistic fit;
    fit.sd = std::abs(at(at.size() - 1));
    fit.log_likelihood = point.value;
    fit.coefficients.assign(at.data(), at.data() + size);
    constexpr double kNone = 1e-4;
    MatrixXd bend = -point.hessian;
    if (fit.sd < kNone) {  // at the edge of what a deviation may be it tells nothing of the others
        fit.sd = 0.0;
        bend.row(at.size() - 1).setZero();
        bend.col(at.size() - 1).setZero();
        bend(at.size() - 1, at.size() - 1) = 1.0;
    }
    const Eigen::LLT<MatrixXd> factors(bend);
    const MatrixXd covariance = factors.solve(MatrixXd::Identity(bend.rows(), bend.cols()));
    constexpr double kCannotBeTold = 1e6;
    if (factors.info() != Eigen::Success || !covariance.allFinite() ||
        covariance.diagonal().maxCoeff() > kCannotBeTold) {
        return Possible<MixedLogistic>::none("the terms of the model cannot be told apart");
    }
    for (std::size_t row = 0; row < size; ++row) {
        for (std::size_t column = 0; column < size; ++column) {
            fit.covariance.push_back(
                covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
        }
    }
    return fit;
}

}  // namespace

Possible<MixedLogistic> mixed_logistic(const std::vector<MixedParticipants>& data,
                                       std::size_t predictors) {
    using None = Possible<MixedLogistic>;
    check_data(data, predictors);
    if (data.empty()) return None::none("no answers");
    constexpr int kMostSteps = 100;
    constexpr double kFar = 15.0;  // log odds: what a million to one does not reach
    constexpr double kSmallStep = 1e-9;
    const MixedModel model(data, predictors, kMixedNodes);
    VectorXd at = VectorXd::Zero(static_cast<Eigen::Index>(predictors) + 1);
    at(at.size() - 1) = 0.7;
    for (int i = 0; i < kMostSteps; ++i) {
        const LikelihoodPoint point = model.derivatives(at);
        VectorXd step = step_of(point);
        if (step.lpNorm<Eigen::Infinity>() < kSmallStep) return fit_at(point, at);
        const double longest = step.lpNorm<Eigen::Infinity>();
        if (longest > 2.0) step *= 2.0 / longest;
        const double slack = 1e-11 * std::abs(point.value);
        double part = 1.0;
        while (part > 1e-8 && !(model.value(at + part * step) >= point.value - slack)) part /= 2.0;
        at += part * step;
        if (at.lpNorm<Eigen::Infinity>() > kFar) {
            return None::none("the votes are separated, so that no finite effect fits");
        }
    }
    return None::none("the fit did not settle");
}

double mixed_log_likelihood(const std::vector<MixedParticipants>& data,
                            const std::vector<double>& coefficients, double sd, int nodes) {
    check_data(data, coefficients.size());
    base::check_range("mixed_log_likelihood", "nodes", nodes, 1, 100);
    const auto count = static_cast<Eigen::Index>(coefficients.size());
    VectorXd at(count + 1);
    at << Eigen::Map<const VectorXd>(coefficients.data(), count), sd;
    return MixedModel(data, coefficients.size(), nodes).value(at);
}

}  // namespace obscura::analysis

#!/usr/bin/env Rscript
# SPDX-FileCopyrightText: 2026 The Obscura authors
# SPDX-License-Identifier: MIT
#
# Repeats the main tests from the exported tables: votes and exact binomial test of each condition
# with Holm's correction, then the tests of the hypotheses over participants with Holm's correction
# over the primary ones. Base R only, but for an export as JSON Lines, which needs the package
# jsonlite. Run it with Rscript, or set the working directory to its folder and source() it. Prints
# two tables with tabs. Looks before the last one, where a study spends its level over several, are
# not taken into account.

file_argument <- grep("^--file=", commandArgs(FALSE), value = TRUE)
here <- if (length(file_argument) == 1) dirname(normalizePath(sub("^--file=", "", file_argument))) else "."

read_table <- function(path) {
  if (grepl("jsonl$", path)) {
    lines <- readLines(path, encoding = "UTF-8")
    if (length(lines) == 0) return(data.frame())
    return(jsonlite::stream_in(textConnection(lines), verbose = FALSE))
  }
  read.table(path, header = TRUE, sep = if (grepl("tsv$", path)) "\t" else ",", quote = if
    (grepl("_beh.tsv$|code", path)) "" else "\"", comment.char = "", na.strings = c("", "n/a"),
    colClasses = "character", check.names = FALSE, encoding = "UTF-8")
}

# Of an export as CSV, TSV or JSON Lines, Psych-DS or BIDS, whichever lies here.
table_of <- function(name) {
  places <- c(file.path(here, paste0(name, c(".csv", ".tsv", ".jsonl"))),
              file.path(here, "..", "data", paste0("description-", name, "_data.csv")))
  there <- places[file.exists(places)]
  if (length(there) > 0) return(read_table(there[1]))
  answers <- Sys.glob(file.path(here, "..", "sub-*", "beh", "*_beh.tsv"))
  if (length(answers) == 0) stop(here, ": there is no table ", name)
  do.call(rbind, lapply(answers, function(path) {
    rows <- read_table(path)
    if (nrow(rows) > 0) rows$participant_id <- basename(dirname(dirname(path)))
    rows
  }))
}

binomial_p <- function(b, n) if (n == 0) NA else binom.test(b, n)$p.value

# A test that could not be computed counts as 1.
holm <- function(p) {
  adjusted <- p.adjust(ifelse(is.na(p), 1, p), "holm")
  ifelse(is.na(p), NA, adjusted)
}

# Share of all flips of signs with a sum at least this far from 0.
sign_flip_p <- function(d) {
  sizes <- abs(d[d != 0])
  total <- sum(sizes)
  reached <- abs(sum(d))
  if (length(sizes) == 0 || reached == 0) return(1)
  if (all(sizes == 1)) return(binomial_p((total + reached) / 2, total))
  if (length(sizes) > 1000 || length(sizes) * total > 2e7) {
    return(pchisq(reached^2 / sum(sizes^2), 1, lower.tail = FALSE))
  }
  chance <- 1 # of the sums -reach to reach
  for (size in sizes) chance <- (c(chance, rep(0, 2 * size)) + c(rep(0, 2 * size), chance)) / 2
  min(1, 2 * sum(chance[seq(total + reached + 1, 2 * total + 1)]))
}

cochran_p <- function(rows) {
  k <- ncol(rows)
  below <- k * sum(rows) - sum(rowSums(rows)^2)
  if (below == 0) return(1)
  q <- (k - 1) * (k * sum(colSums(rows)^2) - sum(rows)^2) / below
  pchisq(q, k - 1, lower.tail = FALSE)
}

# Participants counted, sum of differences and p of one test; tests are its rows.
hypothesis <- function(tests, votes) {
  own <- votes[votes$condition %in% tests$condition, ]
  if (tests$question[1] == "none") own <- own[0, ]
  nothing <- list(participants = 0, sum = NA, p = NA)
  if (nrow(own) == 0) return(nothing)
  weight <- as.integer(tests$weight[match(own$condition, tests$condition)])
  answer <- ifelse(own$chose_B == "1", 1L, -1L)
  if (tests$question[1] == "preference") {
    d <- as.vector(tapply(weight * answer, own$participant_id, sum))
    return(list(participants = length(d), sum = sum(d), p = sign_flip_p(d)))
  }
  cells <- table(own$participant_id, factor(own$condition, tests$condition))
  if (any(cells > 1)) return(nothing) # somebody answered a condition twice
  complete <- rownames(cells)[rowSums(cells) == nrow(tests)]
  if (length(complete) == 0) return(nothing)
  chose_b <- sapply(tests$condition, function(condition) {
    rows <- own[own$condition == condition, ]
    rows$chose_B[match(complete, rows$participant_id)] == "1"
  })
  chose_b <- matrix(as.integer(chose_b), nrow = length(complete))
  if (tests$question[1] == "levels") {
    return(list(participants = length(complete), sum = NA, p = cochran_p(chose_b)))
  }
  d <- as.vector((2 * chose_b - 1) %*% as.integer(tests$weight))
  if (all(d %% 2 == 0)) d <- d / 2
  list(participants = length(d), sum = sum(d), p = sign_flip_p(d))
}

trials <- table_of("trials")
votes <- if (nrow(trials) == 0) trials else
  trials[!is.na(trials$excluded) & trials$is_vote == "1" & trials$excluded == "0", ]
conditions <- hypotheses <- NULL
if (nrow(votes) > 0) {
  tests <- table_of("tests")
  for (group in unique(paste(votes$study, votes$kind, sep = "\t"))) {
    of_group <- function(rows) rows[paste(rows$study, rows$kind, sep = "\t") == group, ]
    own <- of_group(votes)
    names <- sort(unique(own$condition), method = "radix")
    b <- sapply(names, function(name) sum(own$condition == name & own$chose_B == "1"))
    n <- sapply(names, function(name) sum(own$condition == name))
    p <- mapply(binomial_p, b, n)
    conditions <- rbind(conditions, data.frame(study = own$study[1], kind = own$kind[1],
      condition = names, A = n - b, B = b, p_exact = p, p_holm = holm(p)))
    of_study <- of_group(tests)
    found <- lapply(unique(of_study$test), function(name) {
      rows <- of_study[of_study$test == name, ]
      data.frame(study = own$study[1], kind = own$kind[1], test = name,
        role = rows$role[1], question = rows$question[1], hypothesis(rows, own))
    })
    if (length(found) > 0) {
      found <- do.call(rbind, found)
      primary <- found$role == "primary"
      found$p_holm <- NA
      found$p_holm[primary] <- holm(found$p[primary])
      hypotheses <- rbind(hypotheses, found)
    }
  }
}
options(digits = 12)
for (result in list(conditions, hypotheses)) {
  if (is.null(result)) next
  write.table(result, sep = "\t", quote = FALSE, row.names = FALSE, na = "")
  cat("\n")
}

#pragma once

#include <array>

#include "trials/plan/plan.hpp"
#include "trials/plan/random.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/task/task.hpp"

namespace palpate::tasks {

/// Two-interval forced choice, "2IFC": two conditions are presented one after the other, in an order that is
/// drawn, and the question is which interval held the one that [task] calls correct. An answer is the number
/// of an interval, 1 or 2.
extern const trials::Task kTwoInterval;

/// What the parts below make up; each is described at its place in trials::Task.
namespace two_interval {

// design.cpp
extern const std::array<base::Key, 2> kKeys;
extern const std::array<base::Key, 1> kOrderKeys;
void read(base::TomlReader& task, trials::Protocol& protocol);
void read_order(base::TomlReader& order, trials::Protocol& protocol);
void check_primary(const base::TomlReader& analysis, const trials::Protocol& protocol);

// draw.cpp
void draw(const trials::Protocol& protocol, std::span<trials::Trial> trials, trials::Generator& generator);
void redraw(const trials::Protocol& protocol, trials::Trial& trial, trials::Generator& generator);
int correct_answer(const trials::Protocol& protocol, const trials::Trial& trial);

// decide.cpp
int decide(const trials::Protocol& protocol, std::span<const std::optional<double>> percepts,
           const trials::Observer& observer, trials::Generator& generator);

// words.cpp
std::string question_in_words(const trials::Protocol& protocol);
std::string order_in_words(const trials::Protocol& protocol);
std::string course_in_words(const trials::Protocol& protocol);
std::string task_means(const trials::Protocol& protocol);
std::string correct_answer_means(const trials::Protocol& protocol);

}  // namespace two_interval
}  // namespace palpate::tasks

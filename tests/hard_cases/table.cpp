#include "tests/hard_cases/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace palpate::hard_cases {
namespace {

constexpr double kRoundingFloor = 1e-3;  // of its limit: a figure below that is rounding
constexpr double kAgreement = 10.0;

constexpr std::string_view kBegin = R"(# Hard cases

What naive code breaks on, and what this program does instead. Each line is a test of its name
(`build/release/tests/hard_cases/hard_cases_test --gtest_filter='*Slivers'`) under `tests/hard_cases`: run once as it
stands and ten times with seeded jitter of its positions and parameters (each by a part of itself, log-uniform in 1e-9 to
1e-3). The worst of the eleven runs is measured, and one that fails fails the case. Some cases are hard at one place alone
(bodies that touch exactly, nodes on nodes): there jitter changes what leaves them there. Two long runs are shorter with
jitter: of a million cycles 10 000, of a circle a tenth.

L is the largest eigenvalue of the probe's stiffness with every contact that may close taken as closed [N/m]; lengths of
vectors are Euclidean; a difference of forces is a part of the force. *Margin* is how many times as large the figure could be (as small, where
it has to be at least the limit). *Binds* says which contact models must keep the limit; what `kuroda` and `sibille` do where it does not bind
them is measured as well, and published: their jumps and their imbalance are those of the laws ([method.md](method.md)).

Made by `ninja -C build/release hard_cases`; the test `hard_cases.table` compares it with what is measured. Figures of
rounding differ from machine to machine.
)";

struct Group {
  const char* name;
  int first, last;
};
constexpr Group kGroups[] = {{"Meshes", 1, 13},           {"Algebra", 14, 22},
                             {"Contact", 23, 36},         {"Large motion", 37, 41},
                             {"Loop and device", 42, 50}, {"Found in use", 51, 1000}};

/// Two digits, without the zeros of an exponent: "0.42", "3e-15".
std::string short_number(double value) {
  std::string text = fmt::format("{:.2g}", value);
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  std::string power = text.substr(exponent + 1);
  const bool small = power.front() == '-';
  power.erase(0, power.find_first_not_of("+-0"));
  return text.substr(0, exponent) + (small ? "e-" : "e") + power;
}

std::string published(const std::optional<double>& figure) {
  return figure ? short_number(*figure) : "";
}

std::string measured(const Result& result) {
  const Outcome& worst = result.worst;
  if (*result.hard_case.figure == '\0')
    return fmt::format("{} of {}", worst.checks - std::ssize(worst.faults), worst.checks);
  return short_number(worst.figure);
}

std::string limit_of(const Result& result) {
  if (*result.hard_case.figure == '\0') return "all";
  const Outcome& worst = result.worst;
  return (worst.bound == Bound::AtMost ? "≤ " : "≥ ") + short_number(worst.limit);
}

std::string margin_of(const Result& result) {
  const Outcome& worst = result.worst;
  if (*result.hard_case.figure == '\0' || worst.limit == 0.0 || worst.figure == 0.0) return "";
  return short_number(worst.bound == Bound::AtMost ? worst.limit / worst.figure : worst.figure / worst.limit);
}

std::string row(const Result& result, bool laws) {
  const HardCase& of = result.hard_case;
  std::string text = fmt::format("| {} | `{}` | {} | {} | {} | {} | {} | {} | {} |", of.number, of.name,
                                 of.title, of.criterion, *of.figure == '\0' ? "checks" : of.figure,
                                 measured(result), limit_of(result), margin_of(result), of.binds);
  if (laws)
    text += fmt::format(" {} | {} |", published(result.worst.kuroda), published(result.worst.sibille));
  return text + "\n";
}

std::string table(const Group& group, const std::vector<Result>& results) {
  std::vector<Result> own;
  std::ranges::copy_if(results, std::back_inserter(own), [&](const Result& result) {
    return result.hard_case.number >= group.first && result.hard_case.number <= group.last;
  });
  if (own.empty()) return "";
  const bool laws =
      std::ranges::any_of(own, [](const Result& result) { return result.worst.kuroda.has_value(); });
  std::string text =
      fmt::format("\n## {}\n\n| # | test | case | must hold | figure | worst | limit | margin | binds |{}\n",
                  group.name, laws ? " `kuroda` | `sibille` |" : "");
  text += fmt::format("|--:|---|---|---|---|--:|--:|--:|---|{}\n", laws ? "--:|--:|" : "");
  for (const Result& result : own) text += row(result, laws);
  return text;
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// A cell that holds one number.
std::optional<double> number_in(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (end == cell.c_str() || std::string_view(end).find_first_not_of(' ') != std::string_view::npos)
    return std::nullopt;
  return value;
}

bool agree(double a, double b, const Outcome& outcome) {
  const double floor = outcome.bound == Bound::AtMost ? kRoundingFloor * outcome.limit : 0.0;
  if (a <= floor && b <= floor) return true;
  return a * b > 0.0 && std::max(a / b, b / a) <= kAgreement;
}

/// Columns by place in a row that begins and ends with a bar.
enum Column : std::size_t { kWorst = 6, kMargin = 8, kKuroda = 10, kSibille = 11 };

/// Whether two lines say the same, but for figures of a case.
bool same(const std::string& committed, const std::string& fresh, const std::vector<Result>& results) {
  if (committed == fresh) return true;
  const std::vector<std::string> old = split(committed, '|'), now = split(fresh, '|');
  if (old.size() != now.size() || old.size() < 3) return false;
  const auto of = std::ranges::find_if(results, [&](const Result& result) {
    return number_in(now[1]) == static_cast<double>(result.hard_case.number);
  });
  if (of == results.end()) return false;
  for (std::size_t column = 0; column < now.size(); ++column) {
    if (old[column] == now[column]) continue;
    if (column == kMargin) continue;  // follows from the figure
    const auto a = number_in(old[column]), b = number_in(now[column]);
    const bool figure = column == kWorst || column == kKuroda || column == kSibille;
    if (!figure || !a || !b || !agree(*a, *b, of->worst)) return false;
  }
  return true;
}

}  // namespace

std::string document(const std::vector<Result>& results) {
  std::string text(kBegin);
  for (const Group& group : kGroups) text += table(group, results);
  text += "\n## Open\n\n| # | case | must hold | why it is open |\n|--:|---|---|---|\n";
  for (const OpenCase& open : open_cases())
    text += fmt::format("| {} | {} | {} | {} |\n", open.number, open.title, open.criterion, open.reason);
  return text;
}

std::vector<std::string> differences(std::string_view committed, std::string_view fresh,
                                     const std::vector<Result>& results) {
  const std::vector<std::string> old = split(committed, '\n'), now = split(fresh, '\n');
  std::vector<std::string> found;
  for (std::size_t line = 0; line < std::max(old.size(), now.size()); ++line) {
    const std::string was = line < old.size() ? old[line] : "", is = line < now.size() ? now[line] : "";
    if (!same(was, is, results))
      found.push_back(fmt::format("line {}:\n  committed: {}\n  measured:  {}", line + 1, was, is));
  }
  return found;
}

}  // namespace palpate::hard_cases

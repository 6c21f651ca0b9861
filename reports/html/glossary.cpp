#include "reports/html/glossary.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "reports/paper_names.hpp"

namespace tcert {
namespace {

struct Explained {
  std::string_view term;
  std::string_view meaning;
  std::initializer_list<std::string_view> words;  ///< It is explained if one of them is there.
};

const std::array<Explained, 15> kExplained = {{
    {"E, A, T(E; A)",
     "E is a place and A a robot. T(E; A) is the best margin that any path through the place has "
     "for the robot: what the certificate is meant to stay below.",
     {"T(E; A)"}},
    {"S, G", "Start and goal of a trial.", {"S", "G"}},
    {"m_t",
     "The tick margin, in metres: the width of the place here less the robot's own, or how much "
     "larger the radius of its turn is than the least one that it can drive, whichever is less.",
     {"m_t", "margin_m"}},
    {"V_t",
     "The corridor value, in metres: the narrowest place of the best explored way from S to the "
     "robot, less a penalty where it touched something lately.",
     {"V_t"}},
    {"T_t",
     "The certificate, in metres: the narrowest place of the best explored way from S to G. It "
     "never falls, and is issued when it is above 0.",
     {"T_t"}},
    {"TC_early",
     "The early certificate, in metres: V_t of the beginning of a trial (T_t once it is issued), "
     "its 10th percentile in the first 15 s and in the first 5 m, the lower of the two (numbers by "
     "default; the methods say which took effect). As a column it is tc_early; tc_landmark is that "
     "of the first 15 s alone.",
     {"TC_early", "tc_early", "tc_landmark"}},
    {"Rivals",
     "What a robot could have counted instead: contacts per metre, dwell (share of the time spent "
     "standing), bend variance (how much its feelers move).",
     {"rivals", "contacts_per_m", "bend_variance", "contacts_per_m_landmark"}},
    {"Landmark panel",
     "The first 15 s alone, of trials that still run and move then, so that no outcome is in what "
     "predicts it. Conclusions are drawn from it. The paper panel has all trials, and the whole "
     "early window.",
     {"landmark"}},
    {"AUC",
     "The chance that of a success and a failure, drawn at random, the success has the better "
     "value: 0.5 is no use, 1 is perfect.",
     {"AUC"}},
    {"C",
     "Harrell's C, the same for time: the chance that of two trials the one with the better value "
     "reaches the goal earlier.",
     {"C"}},
    {"OR, HR",
     "Odds ratio of success and hazard ratio of reaching the goal, for one standard deviation "
     "towards the better side: above 1 it helps.",
     {"OR", "HR"}},
    {"squash, clip",
     "Speed laws that open up with the margin: squash rises smoothly, clip in proportion to the "
     "margin up to a limit. Beta says how fast, per metre.",
     {"squash", "clip"}},
    {"A1, A2, A3",
     "Parts of the method left out: the memory of contacts (A1), the rule that unknown space is "
     "occupied (A2), the limit on curvature (A3).",
     {"A1", "A2", "A3"}},
    {"0.7 [0.6, 0.8]", "A value and its interval, of 95 % unless something else is said.", {"["}},
    {"NA", "Not known, or not defined. Never 0.", {"NA"}},
}};

bool is_word_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool stands_at(std::string_view text, std::size_t at, std::string_view word) {
  const std::size_t end = at + word.size();
  const bool begins =
      at == 0 || !is_word_character(word.front()) || !is_word_character(text[at - 1]);
  const bool ends =
      end == text.size() || !is_word_character(word.back()) || !is_word_character(text[end]);
  return begins && ends;
}

}  // namespace

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    if (stands_at(text, at, word)) {
      return true;
    }
  }
  return false;
}

std::vector<GlossaryEntry> glossary_of(std::string_view text, bool with_algorithms) {
  std::vector<GlossaryEntry> entries;
  for (const Explained& one : kExplained) {
    if (std::any_of(one.words.begin(), one.words.end(), [&](std::string_view word) {
          return has_word(text, word);
        })) {
      entries.push_back({std::string(one.term), std::string(one.meaning)});
    }
  }
  if (with_algorithms) {
    for (const PaperName& name : paper_names()) {
      if (has_word(text, name.name)) {
        entries.push_back(
            {std::string(name.name), "Algorithm: " + std::string(name.meaning) + "."});
      }
    }
  }
  return entries;
}

}  // namespace tcert

#include "datasets/import/bag_survey.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "datasets/import/decoder.hpp"
#include "datasets/import/topic_stream.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kMostFieldsShown = 200;

std::vector<std::string> numbers_of(const MessageType& type) {
  std::vector<std::string> paths;
  for (const FieldName& field : field_names(type)) {
    if (field.kind.find("string") == std::string::npos && paths.size() < kMostFieldsShown) {
      paths.push_back(field.path);
    }
  }
  return paths;
}

void look_at_first(const RawMessage& raw,
                   const Decoder& decoder,
                   Value& message,
                   TopicSurvey& survey) {
  std::string problem;
  if (!decoder(raw.data, message, problem)) {
    survey.problem = problem;
    return;
  }
  const std::string prefix = survey.role == StreamRole::transforms ? "transforms[0]." : "";
  if (const auto stamp_ns = header_time(message, prefix)) {
    survey.header_apart_s = 1e-9 * static_cast<double>(*stamp_ns - raw.log_ns);
  }
}

}  // namespace

std::string_view to_string(StreamRole role) noexcept {
  constexpr std::array<std::string_view, 6> kWords = {
      "", "pose", "scan", "range", "control", "transforms"};
  return kWords[static_cast<std::size_t>(role)];
}

std::vector<TopicSurvey> survey_bag(Bag& bag, table::DiagnosticGroups& problems) {
  std::vector<TopicSurvey> surveys;
  std::vector<std::optional<Decoder>> decoders;
  for (const Topic& topic : bag.topics()) {
    TopicSurvey survey;
    survey.name = topic.name;
    survey.type = topic.type;
    survey.role = role_of(topic.type);
    decoders.push_back(Decoder::of(topic, survey.problem));
    if (decoders.back() && decoders.back()->type() != nullptr) {
      survey.fields = numbers_of(*decoders.back()->type());
    }
    surveys.push_back(std::move(survey));
  }
  std::vector<std::size_t> all(surveys.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::int64_t> before(surveys.size());
  Value message;
  bag.for_each(
      all,
      [&](const RawMessage& raw) {
        TopicSurvey& survey = surveys[raw.topic];
        if (survey.messages++ == 0) {
          survey.first_ns = survey.last_ns = raw.log_ns;
          if (decoders[raw.topic]) {
            look_at_first(raw, *decoders[raw.topic], message, survey);
          }
        } else {
          survey.set_back += raw.log_ns < before[raw.topic] ? 1U : 0U;
          survey.first_ns = std::min(*survey.first_ns, raw.log_ns);
          survey.last_ns = std::max(*survey.last_ns, raw.log_ns);
        }
        before[raw.topic] = raw.log_ns;
        return true;
      },
      problems);
  for (TopicSurvey& survey : surveys) {
    if (survey.messages > 1 && *survey.last_ns > *survey.first_ns) {
      survey.rate_hz = 1e9 * static_cast<double>(survey.messages - 1) /
                       static_cast<double>(*survey.last_ns - *survey.first_ns);
    }
  }
  return surveys;
}

}  // namespace tcert::recording

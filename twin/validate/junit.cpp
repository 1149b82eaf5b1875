// SPDX-License-Identifier: MIT
#include "twin/validate/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/output/text_format.hpp"

namespace sensotwin::twin {
namespace {

/// Chosen: a body that CI servers still show; report.json holds all of them.
constexpr std::size_t kCommandsMax = 50;

std::string xml(std::string_view text) {
  std::string escaped;
  robot::append_xml_text(escaped, text);
  return escaped;
}

std::string found_text(const JudgedThreshold& judged) {
  return fmt::format("found {}, interval {}", estimate_text(judged), interval_text(judged));
}

std::string body_of(const Validation& validation, const JudgedThreshold& judged) {
  std::string body = found_text(judged) + "\n";
  if (judged.outcome == Outcome::kOpen) {
    body += "The interval holds what is asked: more seeds would tell.\n";
  }
  if (judged.worst) {
    body += fmt::format("worst: {:.6g} in seed {}\n  {}\n", judged.worst->value, judged.worst->seed,
                        rerun_command(validation, judged.worst->seed));
  }
  if (judged.failing.empty()) {
    return body;
  }
  body += fmt::format("failing seeds: {}\n", judged.failing.size());
  for (std::size_t i = 0; i < std::min(judged.failing.size(), kCommandsMax); ++i) {
    const SeedValue& failing = judged.failing[i];
    body += fmt::format("seed {}: {:.6g}\n  {}\n", failing.seed, failing.value,
                        rerun_command(validation, failing.seed));
  }
  if (judged.failing.size() > kCommandsMax) {
    body += fmt::format("and {} more, see report.json\n", judged.failing.size() - kCommandsMax);
  }
  return body;
}

std::string case_of(const Validation& validation, const JudgedThreshold& judged) {
  const std::string head = fmt::format("    <testcase classname=\"twin.validate.{}\" name=\"{}\">\n",
                                       xml(validation.name), xml(sentence_of(judged.asked)));
  std::string body;
  if (!validation.complete()) {
    body = fmt::format("      <error message=\"interrupted after {} of {} seeds\"/>\n",
                       validation.runs.size(), validation.seeds.size());
  } else if (judged.outcome == Outcome::kKept) {
    body = fmt::format("      <system-out>{}</system-out>\n", xml(body_of(validation, judged)));
  } else {
    body =
        fmt::format("      <failure message=\"{}: {}\" type=\"{}\">{}</failure>\n", name_of(judged.outcome),
                    xml(found_text(judged)), name_of(judged.outcome), xml(body_of(validation, judged)));
  }
  return head + body + "    </testcase>\n";
}

}  // namespace

std::string to_junit(const Validation& validation) {
  const std::size_t cases = validation.judged.size();
  const auto not_kept = static_cast<std::size_t>(
      std::count_if(validation.judged.begin(), validation.judged.end(),
                    [](const JudgedThreshold& judged) { return judged.outcome != Outcome::kKept; }));
  const std::size_t failures = validation.complete() ? not_kept : 0;
  const std::size_t errors = validation.complete() ? 0 : cases;
  const std::string counts = fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\"",
                                         xml(validation.name), cases, failures, errors);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites {}>\n  <testsuite {} skipped=\"0\">\n", counts, counts);
  text +=
      fmt::format("    <properties>\n      <property name=\"scene\" value=\"{}\"/>\n", xml(validation.scene));
  text += fmt::format("      <property name=\"seeds\" value=\"{}\"/>\n    </properties>\n",
                      xml(seeds_text(validation.seeds)));
  for (const JudgedThreshold& judged : validation.judged) {
    text += case_of(validation, judged);
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace sensotwin::twin

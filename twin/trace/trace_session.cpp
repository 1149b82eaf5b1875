// SPDX-License-Identifier: MIT
#include "twin/trace/trace_session.hpp"

#include <fmt/format.h>

#include <cassert>
#include <utility>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/config/text_file.hpp"
#include "twin/trace/map_answers.hpp"
#include "twin/trace/trace_document.hpp"
#include "twin/trace/trace_error.hpp"

namespace sensotwin::twin {
namespace {

/// Chosen: a few tabs of one person, each with a plan.
constexpr std::size_t kPlansMax = 4;

constexpr const char* kTracingEnding = ".trace.json";

std::string without(std::string text, std::string_view ending) {
  if (text.ends_with(ending)) {
    text.resize(text.size() - ending.size());
  }
  return text;
}

/// "office" of office.trace.json, office.hallways.yaml, office.map.yaml and office.png.
std::string stem_of(const std::string& file_name) {
  std::string stem = without(file_name, kTracingEnding);
  if (stem == file_name) {
    stem = std::filesystem::path(file_name).stem().string();
    stem = without(without(without(stem, ".hallways"), ".map"), ".plan");
  }
  return is_file_name(stem) ? stem : "plan";
}

Json document_of(const Json& request) {
  const auto found = request.find("document");
  if (found == request.end() || !found->is_object()) {
    throw TraceError(TraceError::kBadRequest, "the request has no document");
  }
  return *found;
}

std::string name_in(const Json& request, const char* key) {
  const auto found = request.find(key);
  std::string name = found != request.end() && found->is_string() ? found->get<std::string>() : "";
  if (!is_file_name(name)) {
    throw TraceError(
        TraceError::kBadRequest,
        fmt::format("'{}' is no name for a file: expected letters, digits, '_', '-' and '.'", name));
  }
  return name;
}

std::string hallways_file_in(const Json& request) {
  std::string name = name_in(request, "hallways_file");
  if (!name.ends_with(".yaml") && !name.ends_with(".yml")) {
    throw TraceError(TraceError::kBadRequest, fmt::format("'{}': a hallway map's name ends in .yaml", name));
  }
  if (name.ends_with(".scene.yaml") || name.ends_with(".map.yaml")) {
    throw TraceError(TraceError::kBadRequest,
                     fmt::format("'{}' would be a scene's or a map's name, not a hallway map's", name));
  }
  return name;
}

bool has_places(const Json& document) {
  const auto hallways = document.find("hallways");
  return hallways != document.end() && hallways->is_object() && hallways->contains("places") &&
         !(*hallways)["places"].empty();
}

TraceReply refusal(int status, const std::string& what) {
  return {status, "application/json", Json{{"error", what}}.dump()};
}

}  // namespace

TraceSession::TraceSession(std::filesystem::path folder, std::filesystem::path scratch)
    : folder_(std::move(folder)), scratch_(std::move(scratch)) {}

void TraceSession::suggest_hallways_file(const std::string& name) {
  assert(is_file_name(name));
  name_ = stem_of(name);
  hallways_file_ = name;
}

void TraceSession::open_operand(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  name_ = stem_of(name);
  try {
    if (name.ends_with(kTracingEnding)) {
      opened_ = opened_tracing(robot::read_text_file(file, "tracing"), name, TraceFolder(file.parent_path()));
      return;
    }
    if (file.extension() == ".yaml" || file.extension() == ".yml") {
      std::vector<robot::Problem> problems;
      const std::string text = robot::read_text_file(file, "map");
      if (robot::parse_yaml(text, file.string(), problems).find("places") != nullptr) {
        (void)robot::read_hallway_text(text, file);
        opened_ = {{"hallways", hallways_from(text)}, {"hallways_file", name}, {"name", name_}};
        opened_["stamps"][name] = stamp_of_content(text);
        return;
      }
    }
  } catch (const TraceError& error) {
    throw robot::LoadError({{{file.string(), 0, 0}, "", error.what(), "expected a tracing"}},
                           robot::kExitInvalid);
  }
  const PlanPicture plan = read_plan(file);
  const std::string id = keep(plan);
  opened_ = {{"plan", plan_json(plan, id)}, {"name", name_}};
  if (std::filesystem::exists(folder_.path() / (name_ + kTracingEnding))) {
    opened_["note"] =
        fmt::format("{}{} holds an earlier drawing: Open goes on with it.", name_, kTracingEnding);
  }
}

TraceReply TraceSession::answer(const TraceRequest& request) {
  const std::lock_guard lock(mutex_);
  try {
    return dispatch(request);
  } catch (const TraceError& error) {
    return refusal(error.status(), error.what());
  } catch (const robot::LoadError& error) {
    return refusal(TraceError::kUnusable, error.problems().front().text());
  } catch (const Json::exception& error) {
    // A value of another type than the page sends.
    return refusal(TraceError::kBadRequest, error.what());
  }
}

TraceReply TraceSession::dispatch(const TraceRequest& request) {
  const auto reply = [](const Json& json) {
    return TraceReply{200, "application/json", json.dump(-1, ' ', false, Json::error_handler_t::replace)};
  };
  if (request.what == "session") {
    return reply(session());
  }
  if (request.what == "plan") {
    if (const PlanPicture* plan = find_plan(request.argument)) {
      return {200, "image/png", plan->png};
    }
    throw TraceError(TraceError::kNotFound, "this plan is no longer held: open it again");
  }
  if (request.what == "upload") {
    const std::string name = is_file_name(request.argument) ? request.argument : std::string{"the picture"};
    PlanPicture plan = plan_from_bytes(request.body, name);
    const std::string id = keep(plan);
    return reply({{"plan", plan_json(plan, id)}, {"name", stem_of(name)}});
  }
  if (request.body.size() > kBodyMax) {
    throw TraceError(TraceError::kTooLarge, "the document is too large");
  }
  const Json body = document_from(request.body);
  if (request.what == "open") {
    return reply(open(name_in(body, "name")));
  }
  if (request.what == "check") {
    return reply(check_answer(document_of(body)));
  }
  if (request.what == "route") {
    return reply(route_answer(body));
  }
  if (request.what == "scene") {
    return reply(scene(body));
  }
  if (request.what == "save") {
    const Json saved = save(body);
    TraceReply answered = reply(saved);
    answered.status = saved.contains("conflicts") ? TraceError::kConflict
                      : saved.contains("refused") ? TraceError::kUnusable
                                                  : 200;
    return answered;
  }
  throw TraceError(TraceError::kNotFound, fmt::format("nobody answers '{}'", request.what));
}

Json TraceSession::session() const {
  Json files = Json::array();
  for (const TraceFile& file : folder_.files()) {
    files.push_back({{"name", file.name}, {"kind", file.kind}});
  }
  return {{"folder", folder_.path().string()},
          {"files", files},
          {"name", name_},
          {"hallways_file", hallways_file_},
          {"opened", opened_}};
}

Json TraceSession::open(const std::string& name) {
  const std::string text = folder_.read(name);
  if (name.ends_with(kTracingEnding)) {
    return opened_tracing(text, name, folder_);
  }
  std::vector<robot::Problem> problems;
  const bool yaml = name.ends_with(".yaml") || name.ends_with(".yml");
  const robot::YamlNode root = yaml ? robot::parse_yaml(text, name, problems) : robot::YamlNode{};
  if (yaml && root.find("places") != nullptr) {
    (void)robot::read_hallway_text(text, name);
    return {{"hallways", hallways_from(text)},
            {"hallways_file", name},
            {"name", stem_of(name)},
            {"stamps", {{name, stamp_of_content(text)}}}};
  }
  if (const robot::YamlEntry* image = yaml ? root.find("image") : nullptr) {
    // A map in the folder must not fetch a picture from elsewhere.
    (void)folder_.file(image->value.text);
  }
  PlanPicture plan = read_plan(folder_.file(name));
  const std::string id = keep(plan);
  return {{"plan", plan_json(plan, id)}, {"name", stem_of(name)}};
}

Json TraceSession::opened_tracing(const std::string& text, const std::string& name, const TraceFolder& from) {
  Json document = document_from(text);
  if (document.value("tracing", Json()) != 1) {
    throw TraceError(TraceError::kUnusable, fmt::format("'{}' is no tracing", name));
  }
  (void)hallway_text(document);  // so that its shape is that of a tracing
  const std::string stem = stem_of(name);
  Json reply{{"name", stem}};
  const Json placement = document.value("plan", Json());
  if (placement.is_object()) {
    try {
      PlanPicture plan = plan_from_bytes(from.read(stem + ".plan.png"), stem + ".plan.png");
      take_placement(plan, placement);
      plan.name = placement.value("name", plan.name);
      const std::string id = keep(plan);
      document["plan"] = plan_json(plan, id);
    } catch (const TraceError& error) {
      document["plan"] = nullptr;
      reply["note"] = fmt::format("Opened without its picture: {}.", error.what());
    }
  }
  const std::string hallways_file = document.value("hallways_file", stem + ".hallways.yaml");
  reply["hallways_file"] = is_file_name(hallways_file) ? hallways_file : stem + ".hallways.yaml";
  reply["stamps"][name] = stamp_of_content(text);
  for (const std::string& other : {reply["hallways_file"].get<std::string>(), stem + ".scene.yaml",
                                   stem + ".plan.png", stem + ".map.pgm", stem + ".map.yaml"}) {
    try {
      reply["stamps"][other] = stamp_of_content(from.read(other));
    } catch (const TraceError&) {
      continue;  // not saved yet
    }
  }
  reply["document"] = std::move(document);
  return reply;
}

FileContents TraceSession::scene_contents(const Json& request) const {
  const Json document = document_of(request);
  const std::string name = name_in(request, "name");
  SceneNames names;
  FileContents contents;
  if (has_places(document)) {
    names.hallways = hallways_file_in(request);
    const JudgedMap judged = judged_map(document);
    contents[names.hallways] = judged.file ? robot::hallway_yaml(*judged.file) : hallway_text(document);
  }
  const Json scene = document.value("scene", Json::object());
  if (scene.value("walls", "plan") == "plan") {
    const auto plan = placed_plan(document);
    if (!plan) {
      throw TraceError(TraceError::kUnusable,
                       "the scene's walls are those of the plan, and there is no plan");
    }
    if (!plan->scaled) {
      throw TraceError(TraceError::kUnusable,
                       "the plan has no scale yet: nobody knows how large the rooms are");
    }
    names.map = name + ".map.yaml";
    MapFiles map = map_files(*plan, name + ".map.pgm");
    contents[name + ".map.pgm"] = std::move(map.pgm);
    contents[names.map] = std::move(map.yaml);
  }
  contents[name + ".scene.yaml"] = scene_text(document, names);
  return contents;
}

Json TraceSession::scene(const Json& request) {
  const FileContents contents = scene_contents(request);
  FileStamps unused = scratch_.write(contents);
  const std::string file = name_in(request, "name") + ".scene.yaml";
  return scene_answer(contents.at(file), scratch_.path() / file, document_of(request));
}

FileContents TraceSession::contents_to_save(const Json& request, Json& reply) const {
  const Json document = document_of(request);
  const std::string name = name_in(request, "name");
  const std::string hallways_file = hallways_file_in(request);
  FileContents contents;
  if (request.value("scene", false)) {
    contents = scene_contents(request);
  }
  if (has_places(document)) {
    const JudgedMap judged = judged_map(document);
    if (judged.file) {
      contents[hallways_file] = robot::hallway_yaml(*judged.file);
    } else {
      contents.erase(hallways_file);
      reply["problems"] = problems_json(judged.problems, document);
    }
  }
  Json kept = document;
  kept["hallways_file"] = hallways_file;
  if (const auto plan = placed_plan(document)) {
    contents[name + ".plan.png"] = plan->png;
    kept["plan"].erase("id");
  }
  contents[name + kTracingEnding] = kept.dump(1) + "\n";
  return contents;
}

Json TraceSession::save(const Json& request) {
  Json reply = Json::object();
  if (request.value("scene", false)) {
    const Json judged = scene(request);
    if (!judged["sound"].get<bool>()) {
      return {{"refused", "the scene has mistakes, and was not saved"}, {"problems", judged["problems"]}};
    }
  }
  const FileContents contents = contents_to_save(request, reply);
  FileStamps known;
  const Json stamps = request.value("stamps", Json::object());
  for (const auto& [file, stamp] : stamps.items()) {
    if (stamp.is_string()) {
      known[file] = stamp.get<std::string>();
    }
  }
  const std::vector<std::string> conflicts = folder_.conflicts(contents, known);
  if (!conflicts.empty() && !request.value("overwrite", false)) {
    return {{"conflicts", conflicts}, {"error", "the folder holds files that were changed by somebody else"}};
  }
  for (const auto& [file, stamp] : folder_.write(contents)) {
    reply["stamps"][file] = stamp;
  }
  reply["draft"] = reply.contains("problems");
  return reply;
}

std::string TraceSession::keep(PlanPicture plan) {
  std::string id = stamp_of_content(plan.png);
  std::erase_if(plans_, [&](const auto& held) { return held.first == id; });
  plans_.emplace_back(id, std::move(plan));
  while (plans_.size() > kPlansMax) {
    plans_.pop_front();
  }
  return id;
}

const PlanPicture* TraceSession::find_plan(const std::string& id) const {
  for (const auto& [held, plan] : plans_) {
    if (held == id) {
      return &plan;
    }
  }
  return nullptr;
}

std::optional<PlanPicture> TraceSession::placed_plan(const Json& document) const {
  const Json placement = document.value("plan", Json());
  if (!placement.is_object()) {
    return std::nullopt;
  }
  const PlanPicture* held = find_plan(placement.value("id", ""));
  if (held == nullptr) {
    throw TraceError(TraceError::kUnusable, "this plan is no longer held: open its picture again");
  }
  PlanPicture plan = *held;
  take_placement(plan, placement);
  return plan;
}

}  // namespace sensotwin::twin

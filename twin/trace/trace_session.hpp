// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "twin/trace/json_yaml.hpp"
#include "twin/trace/plan_picture.hpp"
#include "twin/trace/trace_folder.hpp"

namespace sensotwin::twin {

/// A question of the page.
struct TraceRequest {
  std::string what;      ///< "session", "open", "check" ...: see TraceSession
  std::string argument;  ///< of "plan" and "upload": the picture's id, or its file's name
  std::string body;      ///< JSON; of "upload": the picture
};

struct TraceReply {
  int status{200};
  std::string type{"application/json"};
  std::string body;
};

/// What stands behind the page: each question is a function from what it says to what is answered, without
/// sockets. The page holds the document; here lie the folder and the pictures last shown.
///
/// | what    | asks                                            | answer |
/// |---------|-------------------------------------------------|---------------------------------------------|
/// | session |                                                 | folder, files, name, what was opened | |
/// open    | { name }                                        | a document, or a plan                       |
/// | upload  | a picture                                       | a plan | | plan    | | the picture,
/// image/png                      | | check   | { document }                                    | problems
/// and advice, the file's text        | | route   | { document, from, to, blocked: [[place, side]] } | steps
/// and words, or why there is none       | | scene   | { document, name, hallways_file }               |
/// problems, tiles and start, the file's text  | | save    | the same, { scene, stamps, overwrite } | files
/// and stamps; 409 when others wrote     |
///
/// A refusal has a status of 400 or more and { "error": a sentence }. May be called by several threads.
class TraceSession {
 public:
  /// \param scratch  an empty folder of ours, where scenes are tried before they are saved
  TraceSession(std::filesystem::path folder, std::filesystem::path scratch);

  /// What the command line names: a picture, a map, a hallway map or a tracing, from wherever it lies.
  /// \throws LoadError kExitMissing, kExitInvalid
  void open_operand(const std::filesystem::path& file);
  /// Under which name the hallway map is to be saved unless told otherwise. \pre is_file_name(), ends in
  /// .yaml
  void suggest_hallways_file(const std::string& name);

  [[nodiscard]] TraceReply answer(const TraceRequest& request);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

  /// Bytes of a request other than upload. Chosen: a document of kPlacesMax places is a tenth.
  static constexpr std::size_t kBodyMax = 8'000'000;

 private:
  [[nodiscard]] TraceReply dispatch(const TraceRequest& request);
  [[nodiscard]] Json session() const;
  [[nodiscard]] Json open(const std::string& name);
  [[nodiscard]] Json opened_tracing(const std::string& text, const std::string& name,
                                    const TraceFolder& from);
  [[nodiscard]] Json save(const Json& request);
  [[nodiscard]] Json scene(const Json& request);
  [[nodiscard]] FileContents contents_to_save(const Json& request, Json& reply) const;
  /// The scene's text and the files beside it, by name. \throws TraceError
  [[nodiscard]] FileContents scene_contents(const Json& request) const;

  std::string keep(PlanPicture plan);
  [[nodiscard]] const PlanPicture* find_plan(const std::string& id) const;
  [[nodiscard]] std::optional<PlanPicture> placed_plan(const Json& document) const;

  std::mutex mutex_;
  TraceFolder folder_;
  TraceFolder scratch_;
  std::string name_{"plan"};
  std::string hallways_file_;                              ///< empty: made from the name
  Json opened_;                                            ///< what open_operand() found, as `open` answers
  std::deque<std::pair<std::string, PlanPicture>> plans_;  ///< the last shown, by id
};

}  // namespace sensotwin::twin

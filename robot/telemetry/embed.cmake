# SPDX-License-Identifier: MIT
# embed.cmake: writes OUTPUT, C++ that holds the files NAMES (a;b;c) of FOLDER as robot::EmbeddedFile.
#   FUNCTION   qualified name of the function that gives them: sensotwin::robot::monitor_files
#   HEADER     that declares it
# The HTML file among them is the page "/".
string(REGEX REPLACE "::[^:]*$" "" namespace "${FUNCTION}")
string(REGEX REPLACE "^.*::" "" function "${FUNCTION}")
set(arrays "")
set(table "")
set(number 0)
foreach(name IN LISTS NAMES)
  file(READ "${FOLDER}/${name}" hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  set(path "/${name}")
  if(name MATCHES "[.]html$")
    set(path "/")
    set(type "text/html")
  elseif(name MATCHES "[.]js$")
    set(type "text/javascript")
  elseif(name MATCHES "[.]css$")
    set(type "text/css")
  else()
    message(FATAL_ERROR "embed.cmake: what is ${name}?")
  endif()
  string(APPEND arrays "constexpr char kFile${number}[] = \"${bytes}\";\n")
  string(APPEND table "    EmbeddedFile{\"${path}\", \"${type}; charset=utf-8\", {kFile${number}, ${size}}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
// Made by robot/telemetry/embed.cmake from a committed bundle.
#include \"${HEADER}\"

#include <array>

namespace ${namespace} {
namespace {
using ::sensotwin::robot::EmbeddedFile;
${arrays}
constexpr std::array<EmbeddedFile, ${number}> kFiles{{
${table}}};
}  // namespace

std::span<const EmbeddedFile> ${function}() { return kFiles; }

}  // namespace ${namespace}
")

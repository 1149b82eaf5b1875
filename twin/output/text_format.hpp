// SPDX-License-Identifier: MIT
#pragma once

#include "robot/output/text_format.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::append_json_string;
using robot::append_xml_text;
using robot::put_fixed;
using robot::put_uid;
using robot::uid_text;

}  // namespace sensotwin::twin

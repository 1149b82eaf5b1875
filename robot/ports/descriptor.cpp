// SPDX-License-Identifier: MIT
#include "robot/ports/descriptor.hpp"

#include <unistd.h>

namespace sensotwin::robot {

void Descriptor::close() {
  if (fd_ >= 0) {
    // Not repeated when interrupted: Linux has closed it all the same.
    ::close(std::exchange(fd_, -1));
  }
}

}  // namespace sensotwin::robot

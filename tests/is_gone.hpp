// Whether a process has ended.
#pragma once

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace pardel {

/// Waits until the process has ended; false if it has not in ten seconds. A zombie counts as ended, because its new
/// parent may reap it later. `process`: a line with its number.
[[nodiscard]] inline bool is_gone(const std::string& process) {
  for (int tries = 0; tries < 1000; ++tries, std::this_thread::sleep_for(std::chrono::milliseconds(10))) {
    std::ifstream stat("/proc/" + process.substr(0, process.find('\n')) + "/stat");
    std::string id, name, state;
    if (!(stat >> id >> name >> state) || state == "Z" || state == "X") return true;
  }
  return false;
}

}  // namespace pardel

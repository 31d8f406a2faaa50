#include "supervise.hpp"

#include <utility>

namespace pardel::cli {

Error interrupted() { return {ErrorKind::cancelled, "interrupted"}; }

Result<Meshed> supervise(const Interrupt& interrupt, ProgressBar& bar, Options options,
                         const std::function<Result<Meshed>(const Options&)>& work) {
  bar.begin("triangulating");
  options.progress = [&](const Progress& progress) {
    if (progress.triangles > 0) bar.update(progress.triangles, progress.estimate);
    return !interrupt.requested();
  };
  Result<Meshed> result = work(options);
  if (!result && result.error().kind == ErrorKind::cancelled) return interrupted();
  return result;
}

}  // namespace pardel::cli
